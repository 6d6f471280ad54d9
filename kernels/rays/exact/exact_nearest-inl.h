// Loop one_ray for the exact methods: the triangle that is hit at the least
// exact t, the first one of several.
//
// The end of the range of t is brought in to the nearest hit so far, so that
// what is farther is missed by the filter; of the few that are left two t are
// compared, exactly where floating-point numbers cannot tell.
#if defined(PITBENCH_KERNELS_RAYS_EXACT_EXACT_NEAREST_INL_H_) == \
    defined(HWY_TARGET_TOGGLE)
#ifdef PITBENCH_KERNELS_RAYS_EXACT_EXACT_NEAREST_INL_H_
#undef PITBENCH_KERNELS_RAYS_EXACT_EXACT_NEAREST_INL_H_
#else
#define PITBENCH_KERNELS_RAYS_EXACT_EXACT_NEAREST_INL_H_
#endif

#include "kernels/rays/exact/exact_method-inl.h"
#include "kernels/rays/loops/one_ray-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

template <class T, Boundary kBoundary>
class NearestExactly {
 public:
  explicit HWY_INLINE NearestExactly(const RayBatch<T>& b)
      : batch_(b), range_(b) {}

  const ExactRange<T>& range() const { return range_; }
  const NearestHit<T>& nearest() const { return nearest_; }

  // Takes triangle i, which is hit, if it is nearer.
  HWY_INLINE void Take(std::size_t i) {
    const OneLane<T> one;
    const RayBatch<T> b = From(i);
    const Exact<OneLane<T>, kBoundary> method(one, FirstTriangle(b));
    auto t = Zero(one);
    auto u = t;
    auto v = t;
    method.Hit(one, FirstRay(b), ExactRange<T>(batch_), t, u, v);
    const auto at = static_cast<T>(hn::GetLane(t));
    // Twice what two t are off together, and what `at` may round to below.
    const T most_off = kShare * (Magnitude(at) + Magnitude(nearest_.t)) +
                       std::numeric_limits<T>::min();
    if (nearest_.triangle != kNoTriangle && !(at < nearest_.t - most_off) &&
        (at > nearest_.t + most_off ||
         !IsExactlyNearer(Case(i), Case(nearest_.triangle)))) {
      return;
    }
    nearest_.triangle = i;
    nearest_.t = at;
    const T above =
        at + (kShare * Magnitude(at) + std::numeric_limits<T>::min());
    range_ = ExactRange<T>(batch_.t_min, HWY_MIN(above, batch_.t_max));
  }

 private:
  static constexpr T kShare =
      static_cast<T>(4 * kTuvError + 2 * std::numeric_limits<T>::epsilon());

  static HWY_INLINE T Magnitude(T x) { return x < 0 ? -x : x; }

  HWY_INLINE RayBatch<T> From(std::size_t i) const {
    RayBatch<T> b = batch_;
    for (Xyz<T>* p : {&b.a, &b.b, &b.c}) {
      *p = {p->x + i, p->y + i, p->z + i};
    }
    return b;
  }

  HWY_INLINE RayAndTriangle Case(std::size_t i) const {
    const OneLane<T> one;
    const RayBatch<T> b = From(i);
    const CaseLanes<OneLane<T>> lanes(one, FirstTriangle(b), FirstRay(b));
    return lanes.Case(0);
  }

  RayBatch<T> batch_;
  ExactRange<T> range_;
  NearestHit<T> nearest_;
};

// Triangles first + k for the bits k of `hits`, which are few.
template <class T, Boundary kBoundary>
static HWY_NOINLINE void TakeHits(NearestExactly<T, kBoundary>& nearest,
                                  std::size_t first, std::uint64_t hits) {
  for (; hits != 0; hits &= hits - 1) {
    nearest.Take(first + hwy::Num0BitsBelowLS1Bit_Nonzero64(hits));
  }
}

template <class T, Boundary kBoundary>
static void OneRayExactly(const RayBatch<T>& batch,
                          const RayResult<T>& result) {
  using D = Lanes<T>;
  const D d;
  const RayBatch<T> b = batch;
  const auto ray = FirstRay(b);
  NearestExactly<T, kBoundary> nearest(b);
  const auto hits = [&](const auto& triangles) HWY_ATTR {
    return Exact<D, kBoundary>(d, triangles).HitAlone(d, ray, nearest.range());
  };
  const std::size_t lanes = hn::Lanes(d);
  std::size_t i = 0;
  for (; i + lanes <= b.n; i += lanes) {
    const auto hit = hits(LoadTriangles(d, b, i));
    if (HWY_UNLIKELY(!hn::AllFalse(d, hit)))
      TakeHits(nearest, i, MaskBits(d, hit));
  }
  if (i < b.n) {
    const TrianglesTail<D> tail(b, i, b.n - i);
    TakeHits(nearest, i,
             MaskBits(d, And(hits(tail.In(d)), hn::FirstN(d, b.n - i))));
  }
  *result.nearest = nearest.nearest().triangle;
  *result.t = nearest.nearest().t;
}

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

#endif  // include guard that Highway toggles
