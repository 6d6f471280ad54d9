// A ray method that is right for every finite input: the filter decides, and
// what it leaves goes lane by lane to exact arithmetic.
#if defined(PITBENCH_KERNELS_RAYS_EXACT_EXACT_METHOD_INL_H_) == \
    defined(HWY_TARGET_TOGGLE)
#ifdef PITBENCH_KERNELS_RAYS_EXACT_EXACT_METHOD_INL_H_
#undef PITBENCH_KERNELS_RAYS_EXACT_EXACT_METHOD_INL_H_
#else
#define PITBENCH_KERNELS_RAYS_EXACT_EXACT_METHOD_INL_H_
#endif

#include "kernels/loops/bits-inl.h"
#include "kernels/rays/exact/exact_lanes-inl.h"
#include "kernels/rays/turn-inl.h"
#include "kernels/wide-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

// t of a hit is within this share of itself, u and v are within this, of what
// they are exactly, and then rounded to T.
inline constexpr double kTuvError = 0x1p-32;

// f64 lanes as they are.
template <class E>
struct AsItIs {
  template <class D>
  HWY_INLINE Vec<E> operator()(const Held<D>& held) const {
    return held.In(E());
  }
};
// All lanes of E as f64, where it has no more than one or they are f64.
template <class E>
using InHalf =
    std::conditional_t<sizeof(TFromD<E>) == 8, AsItIs<E>, LowerHalfOf<E>>;

// A vertex, or all, as f64: P is LowerHalfOf, UpperHalfOf or AsItIs.
template <class W, class P, class Point>
HWY_INLINE PointLanes<Held<W>> Promoted(const P& half, const Point& p) {
  const W w;
  return {Held<W>(w, half(p.x)), Held<W>(w, half(p.y)), Held<W>(w, half(p.z))};
}
template <class W, class P, class Triangle>
HWY_INLINE TriangleLanes<Held<W>> PromotedTriangle(const P& half,
                                                   const Triangle& t) {
  return {Promoted<W>(half, t.a), Promoted<W>(half, t.b),
          Promoted<W>(half, t.c)};
}
// Where a ray's numbers are not Held they are promoted as vectors.
template <class E>
struct InVector {
  template <class P, class H>
  static HWY_INLINE Vec<Wide<E>> Of(const P& half, const H& number) {
    return half(number.In(E()));
  }
};
template <class E, class P, class Ray>
HWY_INLINE RayLanes<Held<Wide<E>>> PromotedRay(const P& half, const Ray& ray) {
  using W = Wide<E>;
  const W w;
  const auto point = [&](const auto& p) HWY_ATTR {
    return PointLanes<Held<W>>{Held<W>(w, InVector<E>::Of(half, p.x)),
                               Held<W>(w, InVector<E>::Of(half, p.y)),
                               Held<W>(w, InVector<E>::Of(half, p.z))};
  };
  return {point(ray.origin), point(ray.direction)};
}

// The filter for t, u and v: in f64, and not contracted, so that all ISAs leave
// the same lanes to exact arithmetic and give the same bits of the others. It
// is set up once for one triangle, and for a vector of them when it is wanted.
template <class D, bool kOneTriangle = std::is_same_v<D, OneLane<TFromD<D>>>>
class TuvFilter {
 public:
  template <class Triangle>
  HWY_INLINE TuvFilter(D, const Triangle&) {}

  // For those of the triangles that `half` promotes.
  template <class W, class P, class Triangle>
  HWY_INLINE RayFilter<W, false> Of(W w, const P& half,
                                    const Triangle& t) const {
    return RayFilter<W, false>(w, PromotedTriangle<W>(half, t));
  }
};
template <class D>
class TuvFilter<D, true> {
  using One = OneLane<double>;

 public:
  template <class Triangle>
  HWY_INLINE TuvFilter(D, const Triangle& t)
      : filter_(One(), PromotedTriangle<One>(InHalf<D>(), t)) {}

  template <class W, class P, class Triangle>
  HWY_INLINE const RayFilter<One, false>& Of(W, const P&,
                                             const Triangle&) const {
    return filter_;
  }

 private:
  RayFilter<One, false> filter_;
};

template <class D, Boundary kBoundary>
class Exact {
  using T = TFromD<D>;
  using Vertex = Held<D>;

 public:
  static constexpr Turn kTurn = Turn::kNone;
  static constexpr bool kTakesEveryTriangle = true;
  using RangeOfT = ExactRange<T>;

  template <class Triangle>
  HWY_INLINE Exact(D d, const Triangle& t)
      : triangle_{HeldPoint(d, t.a), HeldPoint(d, t.b), HeldPoint(d, t.c)},
        filter_(d, t),
        tuv_filter_(d, triangle_) {}

  template <class E, class Ray>
  HWY_INLINE Mask<E> HitAlone(E e, const Ray& ray,
                              const ExactRange<T>& range) const {
    auto u = Zero(e);
    auto v = u;
    auto t = u;
    auto det = u;
    auto bound = u;
    auto of_det = u;
    auto of_t = u;
    filter_.Cross(e, ray, u, v, t, det, bound, of_det, of_t);
    auto hit = Gt(u, u);
    auto miss = hit;
    filter_.Decide(e, u, v, t, det, bound, of_det, of_t, range, hit, miss);
    const auto decided = Or(hit, miss);
    if (HWY_UNLIKELY(!hn::AllTrue(e, decided))) {
      const CaseLanes<E> lanes(e, triangle_, ray);
      const std::uint64_t left = BitsOfLanes(e, hn::Not(decided));
      hit = Or(hit, MaskOf(e, HitsOfLeft<T>(e, lanes, left, kBoundary,
                                            range.least, range.most)));
    }
    return hit;
  }

  template <class E, class Ray>
  HWY_INLINE Mask<E> Hit(E e, const Ray& ray, const ExactRange<T>& range,
                         Vec<E>& t, Vec<E>& u, Vec<E>& v) const {
    if constexpr (sizeof(T) == 8) {
      return HitWide<T>(e, tuv_filter_.Of(e, AsItIs<E>(), triangle_), triangle_,
                        ray, range, range, t, u, v);
    } else {
      using W = Wide<E>;
      const W w;
      auto low_t = Zero(w);
      auto low_u = low_t;
      auto low_v = low_t;
      const auto low =
          HitHalf(e, LowerHalfOf<E>(), ray, range, low_t, low_u, low_v);
      if constexpr (kMaxLanes<E> == 1) {
        t = hn::DemoteTo(e, low_t);
        u = hn::DemoteTo(e, low_u);
        v = hn::DemoteTo(e, low_v);
        return MaskOf(e, BitsOfLanes(w, low));
      } else {
#if HWY_TARGET != HWY_SCALAR
        auto high_t = Zero(w);
        auto high_u = high_t;
        auto high_v = high_t;
        const auto high =
            HitHalf(e, UpperHalfOf<E>(), ray, range, high_t, high_u, high_v);
        const typename WideOf<E>::Narrow narrow;
        t = hn::Combine(e, hn::DemoteTo(narrow, high_t),
                        hn::DemoteTo(narrow, low_t));
        u = hn::Combine(e, hn::DemoteTo(narrow, high_u),
                        hn::DemoteTo(narrow, low_u));
        v = hn::Combine(e, hn::DemoteTo(narrow, high_v),
                        hn::DemoteTo(narrow, low_v));
        return JoinMasks(e, high, low);
#endif
      }
    }
  }

 private:
  template <class Point>
  static HWY_INLINE PointLanes<Vertex> HeldPoint(D d, const Point& p) {
    return {Vertex(d, p.x.In(d)), Vertex(d, p.y.In(d)), Vertex(d, p.z.In(d))};
  }

  // Hits of f64 lanes, which may be those of f32, and where they are. The
  // filter has to decide that t, u and v are near enough as well.
  template <class Scalar, class W, class Filter, class Triangle, class Ray>
  static HWY_INLINE Mask<W> HitWide(W w, const Filter& filter,
                                    const Triangle& triangle, const Ray& ray,
                                    const ExactRange<double>& range,
                                    const ExactRange<Scalar>& narrow_range,
                                    Vec<W>& t, Vec<W>& u, Vec<W>& v) {
    auto det = Zero(w);
    auto bound = det;
    auto of_det = det;
    auto of_t = det;
    filter.Cross(w, ray, u, v, t, det, bound, of_det, of_t);
    auto hit = Gt(det, det);
    auto miss = hit;
    filter.Decide(w, u, v, t, det, bound, of_det, of_t, range, hit, miss);
    // u·δ, v·δ and δ are off by 40/112 of the bound each and t·δ by 46/80 of
    // its own; 1/δ and the products round once more. 1/δ may underflow a
    // little, being at least 2^-1024, and must not overflow.
    constexpr double kFiveUnits = 2.5 * std::numeric_limits<double>::epsilon();
    const auto share = Set(w, kTuvError / 2);
    const auto near =
        And(Ge(Mul(det, share),
               hn::Max(bound, Set(w, std::numeric_limits<double>::min()))),
            Ge(Mul(Abs(t), share), Mul(of_t, Set(w, kFiveUnits))));
    hit = And(hit, near);
    const auto decided = Or(hit, miss);
    const auto inverse = Div(Set(w, 1.0), det);
    t = Mul(t, inverse);
    u = Mul(u, inverse);
    v = Mul(v, inverse);
    if (HWY_UNLIKELY(!hn::AllTrue(w, decided))) {
      CaseLanes<W> lanes(w, triangle, ray);
      hn::Store(t, w, lanes.t);
      hn::Store(u, w, lanes.u);
      hn::Store(v, w, lanes.v);
      const std::uint64_t left = BitsOfLanes(w, hn::Not(decided));
      hit = Or(hit, MaskOf(w, TuvOfLeft<Scalar>(w, lanes, left, kBoundary,
                                                narrow_range.least,
                                                narrow_range.most)));
      t = hn::Load(w, lanes.t);
      u = hn::Load(w, lanes.u);
      v = hn::Load(w, lanes.v);
    }
    return hit;
  }

  // The same of that half of f32 lanes which `half` promotes.
  template <class E, class P, class Ray>
  HWY_INLINE Mask<Wide<E>> HitHalf(E, const P& half, const Ray& ray,
                                   const ExactRange<T>& range, Vec<Wide<E>>& t,
                                   Vec<Wide<E>>& u, Vec<Wide<E>>& v) const {
    using W = Wide<E>;
    const W w;
    return HitWide<T>(w, tuv_filter_.Of(w, half, triangle_),
                      PromotedTriangle<W>(half, triangle_),
                      PromotedRay<E>(half, ray),
                      ExactRange<double>(static_cast<double>(range.least),
                                         static_cast<double>(range.most)),
                      range, t, u, v);
  }

  TriangleLanes<Vertex> triangle_;
  RayFilter<D, kFilterFma> filter_;
  TuvFilter<D> tuv_filter_;
};

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

#endif  // include guard that Highway toggles
