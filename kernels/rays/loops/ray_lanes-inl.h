// How rays and triangles are read from their arrays, and a ray's answer.
#if defined(PITBENCH_KERNELS_RAYS_LOOPS_RAY_LANES_INL_H_) == \
    defined(HWY_TARGET_TOGGLE)
#ifdef PITBENCH_KERNELS_RAYS_LOOPS_RAY_LANES_INL_H_
#undef PITBENCH_KERNELS_RAYS_LOOPS_RAY_LANES_INL_H_
#else
#define PITBENCH_KERNELS_RAYS_LOOPS_RAY_LANES_INL_H_
#endif

#include "kernels/loops/bits-inl.h"
#include "kernels/loops/plain-inl.h"
#include "kernels/rays/turn-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

// Points i to i + Lanes(d), all of which exist.
template <class D, class T = TFromD<D>>
HWY_INLINE PointLanes<Loaded<D>> LoadPoints(D d, const Xyz<T>& p,
                                            std::size_t i) {
  return {Loaded<D>(d, p.x + i), Loaded<D>(d, p.y + i), Loaded<D>(d, p.z + i)};
}
template <class D, class T = TFromD<D>>
HWY_INLINE TriangleLanes<Loaded<D>> LoadTriangles(D d, const RayBatch<T>& b,
                                                  std::size_t i) {
  return {LoadPoints(d, b.a, i), LoadPoints(d, b.b, i), LoadPoints(d, b.c, i)};
}
template <class D, class T = TFromD<D>>
HWY_INLINE RayLanes<Loaded<D>> LoadRays(D d, const RayBatch<T>& b,
                                        std::size_t i) {
  return {LoadPoints(d, b.origin, i), LoadPoints(d, b.direction, i)};
}

// The last `count` points of arrays that end with them.
template <class D>
struct PointsTail {
  using T = TFromD<D>;
  Tail<D> x, y, z;

  HWY_INLINE PointsTail(const Xyz<T>& p, std::size_t i, std::size_t count)
      : x(p.x + i, count), y(p.y + i, count), z(p.z + i, count) {}
  HWY_INLINE Xyz<T> Arrays() const { return {x.data(), y.data(), z.data()}; }
};
template <class D>
struct TrianglesTail {
  using T = TFromD<D>;
  PointsTail<D> a, b, c;

  HWY_INLINE TrianglesTail(const RayBatch<T>& of, std::size_t i,
                           std::size_t count)
      : a(of.a, i, count), b(of.b, i, count), c(of.c, i, count) {}
  HWY_INLINE TriangleLanes<Loaded<D>> In(D d) const {
    return {LoadPoints(d, a.Arrays(), 0), LoadPoints(d, b.Arrays(), 0),
            LoadPoints(d, c.Arrays(), 0)};
  }
};
template <class D>
struct RaysTail {
  using T = TFromD<D>;
  PointsTail<D> origin, direction;

  HWY_INLINE RaysTail(const RayBatch<T>& of, std::size_t i, std::size_t count)
      : origin(of.origin, i, count), direction(of.direction, i, count) {}
  HWY_INLINE RayLanes<Loaded<D>> In(D d) const {
    return {LoadPoints(d, origin.Arrays(), 0),
            LoadPoints(d, direction.Arrays(), 0)};
  }
};

// The triangle as M wants it: one that cannot be hit with NaN in it, but for a
// method which tells by itself (kTakesEveryTriangle).
template <class M, class D, class H>
HWY_INLINE auto TriangleFor(D d, const TriangleLanes<H>& t) {
  if constexpr (requires { M::kTakesEveryTriangle; }) {
    return t;
  } else {
    return ValidTriangle(d, t);
  }
}

// The range of t as M compares with it.
template <class M, class T>
HWY_INLINE auto RangeFor(const RayBatch<T>& b) {
  if constexpr (requires { typename M::RangeOfT; }) {
    return typename M::RangeOfT(b);
  } else {
    return Range<T>(b);
  }
}

// Which of the rays hit, by HitAlone where the method has it and t, u and v are
// not asked for.
template <RayOutput kOutput, class M, class D, class Ray, class MRange>
HWY_INLINE Mask<D> HitOf(const M& method, D d, const Ray& ray,
                         const MRange& range, Vec<D>& t, Vec<D>& u, Vec<D>& v) {
  if constexpr (kOutput == RayOutput::kHits &&
                requires { method.HitAlone(d, ray, range); }) {
    return method.HitAlone(d, ray, range);
  } else {
    return method.Hit(d, ray, range, t, u, v);
  }
}

// Which of the rays hit; stores t, u and v as well where kOutput says so.
// `count` lanes are real; kWhole promises that all of them are.
template <RayOutput kOutput, bool kWhole, class M, class D, class Ray,
          class MRange, class T = TFromD<D>>
HWY_INLINE Mask<D> AnswerRays(const M& method, D d, const Ray& ray,
                              const MRange& range, const RayResult<T>& result,
                              std::size_t i, std::size_t count) {
  auto t = Zero(d);
  auto u = t;
  auto v = t;
  const auto hit = HitOf<kOutput>(method, d, ray, range, t, u, v);
  if constexpr (kOutput == RayOutput::kTuv) {
    const auto nan = Set(d, std::numeric_limits<T>::quiet_NaN());
    StoreThree<kWhole>(d, IfThenElse(hit, t, nan), IfThenElse(hit, u, nan),
                       IfThenElse(hit, v, nan), result.t + i, result.u + i,
                       result.v + i, count);
  }
  if constexpr (kWhole) {
    return hit;
  } else {
    return And(hit, hn::FirstN(d, count));
  }
}

// Writes n answers as WriteBits does; of the autovec ISAs in plain loops.
template <class D, class MaskAt, class TailAt>
HWY_INLINE void WriteAnswers(D d, std::size_t n, std::uint8_t* bits,
                             const MaskAt& mask_at, const TailAt& tail_at) {
#if PITBENCH_AUTOVEC
  (void)d;
  (void)tail_at;
  WritePlainBits(n, bits, [=](std::size_t i) {
    return static_cast<std::uint8_t>(mask_at(i).bits & 1);
  });
#else
  WriteBits(d, n, bits, mask_at, tail_at);
#endif
}

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

#endif  // include guard that Highway toggles
