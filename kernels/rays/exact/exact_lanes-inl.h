// The lanes that a filter leaves, one by one: as numbers, decided in f64 if
// they are f32, and else exactly.
#if defined(PITBENCH_KERNELS_RAYS_EXACT_EXACT_LANES_INL_H_) == \
    defined(HWY_TARGET_TOGGLE)
#ifdef PITBENCH_KERNELS_RAYS_EXACT_EXACT_LANES_INL_H_
#undef PITBENCH_KERNELS_RAYS_EXACT_EXACT_LANES_INL_H_
#else
#define PITBENCH_KERNELS_RAYS_EXACT_EXACT_LANES_INL_H_
#endif

#include "kernels/rays/exact/ray_contains.h"
#include "kernels/rays/exact/ray_filter-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

// Hits are right either way; contraction makes the filter cheaper.
inline constexpr bool kFilterFma = HWY_NATIVE_FMA != 0;

// Bit i of lane i, and no bit where there is no lane: a mask of less than a
// whole register may say anything there (Not says yes).
template <class D>
HWY_INLINE std::uint64_t BitsOfLanes(D d, Mask<D> mask) {
  const std::uint64_t bits = MaskBits(d, mask);
  if constexpr (kMaxLanes<D> * sizeof(TFromD<D>) < 16) {
    return bits & ((std::uint64_t{1} << kMaxLanes<D>)-1);
  } else {
    return bits;
  }
}

// Triangles, rays, and t, u and v as numbers.
template <class D>
struct CaseLanes {
  using Numbers = TFromD<D>[kMaxLanes<D>];
  HWY_ALIGN Numbers of[15];
  HWY_ALIGN Numbers t, u, v;

  template <class Triangle, class Ray>
  HWY_INLINE CaseLanes(D d, const Triangle& triangle, const Ray& ray) {
    std::size_t k = 0;
    const auto store = [&](const auto& p) HWY_ATTR {
      hn::Store(p.x.In(d), d, of[k++]);
      hn::Store(p.y.In(d), d, of[k++]);
      hn::Store(p.z.In(d), d, of[k++]);
    };
    store(triangle.a);
    store(triangle.b);
    store(triangle.c);
    store(ray.origin);
    store(ray.direction);
  }

  HWY_INLINE RayAndTriangle Case(std::size_t i) const {
    return {{of[0][i], of[1][i], of[2][i]},
            {of[3][i], of[4][i], of[5][i]},
            {of[6][i], of[7][i], of[8][i]},
            {of[9][i], of[10][i], of[11][i]},
            {of[12][i], of[13][i], of[14][i]}};
  }
};

HWY_INLINE PointLanes<Broadcast<double>> FirstOf(const double (&p)[3]) {
  return {Broadcast<double>(p[0]), Broadcast<double>(p[1]),
          Broadcast<double>(p[2])};
}

// The f32 lanes that are left are mostly decided by f64.
template <class T>
HWY_INLINE bool DecideOne(Boundary boundary, const RayAndTriangle& of, T least,
                          T most) {
  if constexpr (sizeof(T) == 4) {
    const OneLane<double> one;
    const TriangleLanes<Broadcast<double>> triangle{
        FirstOf(of.a), FirstOf(of.b), FirstOf(of.c)};
    const RayLanes<Broadcast<double>> ray{FirstOf(of.origin),
                                          FirstOf(of.direction)};
    const RayFilter<OneLane<double>, kFilterFma> filter(one, triangle);
    const ExactRange<double> range(static_cast<double>(least),
                                   static_cast<double>(most));
    auto u = Zero(one);
    auto v = u, t = u, det = u, bound = u, of_det = u, of_t = u;
    filter.Cross(one, ray, u, v, t, det, bound, of_det, of_t);
    auto hit = Gt(u, u);
    auto miss = hit;
    filter.Decide(one, u, v, t, det, bound, of_det, of_t, range, hit, miss);
    if (hn::AllTrue(one, hit)) return true;
    if (hn::AllTrue(one, miss)) return false;
  }
  return RayExactlyHits(boundary, of, static_cast<double>(least),
                        static_cast<double>(most));
}

// Which of the lanes `left` hit.
template <class T, class D>
static HWY_NOINLINE std::uint64_t HitsOfLeft(D, const CaseLanes<D>& lanes,
                                             std::uint64_t left,
                                             Boundary boundary, T least,
                                             T most) {
  std::uint64_t hits = 0;
  for (; left != 0; left &= left - 1) {
    const auto i = hwy::Num0BitsBelowLS1Bit_Nonzero64(left);
    if (DecideOne<T>(boundary, lanes.Case(i), least, most)) {
      hits |= std::uint64_t{1} << i;
    }
  }
  return hits;
}

// The same, and their t, u and v, which are those of T.
template <class T, class D>
static HWY_NOINLINE std::uint64_t TuvOfLeft(D d, CaseLanes<D>& lanes,
                                            std::uint64_t left,
                                            Boundary boundary, T least,
                                            T most) {
  const std::uint64_t hits =
      HitsOfLeft<T>(d, lanes, left, boundary, least, most);
  for (std::uint64_t rest = hits; rest != 0; rest &= rest - 1) {
    const auto i = hwy::Num0BitsBelowLS1Bit_Nonzero64(rest);
    const RayTuv<T> tuv = RoundedTuv<T>(lanes.Case(i));
    lanes.t[i] = static_cast<TFromD<D>>(tuv.t);
    lanes.u[i] = static_cast<TFromD<D>>(tuv.u);
    lanes.v[i] = static_cast<TFromD<D>>(tuv.v);
  }
  return hits;
}

template <class E>
HWY_INLINE Mask<E> MaskOf(E e, std::uint64_t bits) {
  return hn::LoadMaskBits(e, reinterpret_cast<const std::uint8_t*>(&bits));
}

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

#endif  // include guard that Highway toggles
