// Which rays surely hit a triangle and which surely miss it, by floating-point
// arithmetic of which the rounding is bounded.
//
//   S = O − A, E1 = B − A, E2 = C − A, n = E1 × E2, R = D × S
//   δ = D·n, u·δ = E2·R, v·δ = −E1·R, w·δ = δ − u·δ − v·δ, t·δ = −S·n
//
// The bounds. Let ε be T's unit roundoff, s, d and E the largest magnitudes of
// coordinates of S and D and of E1 and E2 as computed. S, E1 and E2 are off by
// ε of each coordinate; a coordinate of R by 4ε·ds for its own rounding and
// 2ε·ds for that of S, and R's are at most 2ds; one of n likewise by 4ε·E² + 4ε
// ·E², and n's are at most 2E². A dot product of three terms, each at most m,
// is off by 8ε·m. So
//   u·δ, v·δ:  (18 + 6 + 16)ε·Eds = 40ε·Eds
//   δ:         (24 + 16)ε·dE² = 40ε·dE²
//   t·δ:       (24 + 6 + 16)ε·sE² = 46ε·sE²
//   w·δ:       40ε(dE² + 2Eds), and 12ε·dE² + 18ε·Eds for its own subtractions,
// all of them at most 98ε·Ed(s + E), and 112ε pays for terms of order ε² and
// for what rounding takes from the bound itself. Contracted they err less.
//
// Signs. All three weights times |δ| above the bound make δ larger than its
// error, so that its sign is right, and the ray's line goes through the
// triangle. One of them below minus the bound, and it does not: where δ has the
// wrong sign, |δ| is within 80ε·dE², so that the weight is larger than |δ|, and
// another weight is negative in its place. For t, δ's sign has to be sure.
//
// The ends of the range. t ≥ a is asked as t·δ − a·δ ≥ 0, or, where |a| > 1, as
// t·δ/|a| − δ·sign(a) ≥ 0, so that no end is too large to be compared with;
// with α and β the factors of δ and t·δ it is off by 40ε·|α|·dE² + 46ε·|β|·sE²
// for these, by 6ε of each for the product, for 1/|a| and for the subtraction:
// at most 64ε(|α|·dE² + |β|·sE²), and 80ε pays for the rest.
//
// Underflow. A product that underflows is off by half the least subnormal η.
// E ≥ e, and e is added to d and in t's bound to s, for an e such that the
// bounds are then more than 9η(1 + E + d + s), which is more than what
// underflows: 112ε·e³ ≥ 9η and e² ≥ η/ε.
//
// Overflow. The bounds are made of 4ds, 16Eds, 16dE² and 16sE², which are no
// smaller than anything computed on the way to what they bound; so where that
// has overflowed the bound is infinite or NaN, and nothing is decided. Nor is
// it where a coordinate is infinite or NaN and the answer is not a miss anyway:
// each is part of w·δ.
#if defined(PITBENCH_KERNELS_RAYS_EXACT_RAY_FILTER_INL_H_) == \
    defined(HWY_TARGET_TOGGLE)
#ifdef PITBENCH_KERNELS_RAYS_EXACT_RAY_FILTER_INL_H_
#undef PITBENCH_KERNELS_RAYS_EXACT_RAY_FILTER_INL_H_
#else
#define PITBENCH_KERNELS_RAYS_EXACT_RAY_FILTER_INL_H_
#endif

#include "kernels/rays/ray_method-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

// An end a of the range of t, as the factors with which δ and t·δ are compared.
template <class T>
struct RangeEnd {
  T of_det, of_t;
  T bound_of_det, bound_of_t;  // 80ε = 5ε·16 of each

  explicit HWY_INLINE RangeEnd(T end) {
    constexpr T kFiveUnits = T{2.5} * std::numeric_limits<T>::epsilon();
    const T magnitude = end < 0 ? -end : end;
    const bool small = magnitude <= 1;
    of_det = small ? end : end < 0 ? T{-1} : T{1};
    of_t = small ? T{1} : T{1} / magnitude;  // 0 of infinity; NaN of NaN
    bound_of_det = kFiveUnits * (of_det < 0 ? -of_det : of_det);
    // 1/|a| may underflow, and then be off by half of η; and no factor of the
    // bound should be subnormal, which takes processors a hundred cycles.
    bound_of_t = kFiveUnits * HWY_MAX(of_t, static_cast<T>(0x1p-60));
  }
};

template <class T>
struct ExactRange {
  T least, most;
  RangeEnd<T> first, last;

  explicit HWY_INLINE ExactRange(const RayBatch<T>& b)
      : ExactRange(b.t_min, b.t_max) {}
  // Both are NaN where there is no such range.
  HWY_INLINE ExactRange(T t_min, T t_max)
      : least(t_min >= -std::numeric_limits<T>::max() && t_min <= t_max
                  ? t_min
                  : std::numeric_limits<T>::quiet_NaN()),
        most(least == least ? t_max : least),
        first(least),
        last(most) {}
};

// a·b + c
template <bool kFma, class V>
HWY_INLINE V SumWithProduct(V a, V b, V c) {
  if constexpr (kFma) {
    return MulAdd(a, b, c);
  } else {
    return Add(Mul(a, b), c);
  }
}

template <class V>
HWY_INLINE V LargestMagnitude(V x, V y, V z) {
  return hn::Max(hn::Max(Abs(x), Abs(y)), Abs(z));
}

// Set up from one triangle a lane. With kFma it is contracted.
template <class D, bool kFma>
class RayFilter {
  using T = TFromD<D>;

 public:
  template <class Triangle>
  HWY_INLINE RayFilter(D d, const Triangle& t)
      : RayFilter(d, t.a.x.In(d), t.a.y.In(d), t.a.z.In(d),
                  Sub(t.b.x.In(d), t.a.x.In(d)), Sub(t.b.y.In(d), t.a.y.In(d)),
                  Sub(t.b.z.In(d), t.a.z.In(d)), Sub(t.c.x.In(d), t.a.x.In(d)),
                  Sub(t.c.y.In(d), t.a.y.In(d)),
                  Sub(t.c.z.In(d), t.a.z.In(d))) {}

  // u·|δ|, v·|δ|, t·|δ| and |δ|. `bound` is that of u·δ, v·δ, w·δ and δ; in
  // of_det and of_t are 16dE² and 16sE².
  template <class E, class Ray>
  HWY_INLINE void Cross(E e, const Ray& ray, Vec<E>& u, Vec<E>& v, Vec<E>& t,
                        Vec<E>& det, Vec<E>& bound, Vec<E>& of_det,
                        Vec<E>& of_t) const {
    const auto dx = ray.direction.x.In(e);
    const auto dy = ray.direction.y.In(e);
    const auto dz = ray.direction.z.In(e);
    const auto sx = Sub(ray.origin.x.In(e), ax_.In(e));
    const auto sy = Sub(ray.origin.y.In(e), ay_.In(e));
    const auto sz = Sub(ray.origin.z.In(e), az_.In(e));
    auto rx = sx;
    auto ry = sx;
    auto rz = sx;
    pitbench::PITBENCH_ISA::Cross<kFma>(dx, dy, dz, sx, sy, sz, rx, ry, rz);
    const auto nx = nx_.In(e);
    const auto ny = ny_.In(e);
    const auto nz = nz_.In(e);
    const auto signed_det = Dot<kFma>(dx, dy, dz, nx, ny, nz);
    const auto sign = hn::And(signed_det, hn::SignBit(e));
    const auto opposite = hn::Xor(sign, hn::SignBit(e));
    det = Abs(signed_det);
    u = hn::Xor(Dot<kFma>(e2x_.In(e), e2y_.In(e), e2z_.In(e), rx, ry, rz),
                sign);
    v = hn::Xor(Dot<kFma>(e1x_.In(e), e1y_.In(e), e1z_.In(e), rx, ry, rz),
                opposite);
    t = hn::Xor(Dot<kFma>(sx, sy, sz, nx, ny, nz), opposite);
    const auto s = LargestMagnitude(sx, sy, sz);
    const auto four = Set(e, T{4});
    const auto d4 = SumWithProduct<kFma>(LargestMagnitude(dx, dy, dz), four,
                                         Set(e, 4 * kLeastSize));
    of_det = Mul(area4_.In(e), d4);
    const auto size = SumWithProduct<kFma>(edge4_.In(e), Mul(d4, s), of_det);
    constexpr T kSevenUnits = T{3.5} * std::numeric_limits<T>::epsilon();
    bound = Mul(size, Set(e, kSevenUnits));
    of_t = SumWithProduct<kFma>(area16_.In(e), s, least_of_t_.In(e));
  }

  // Which lanes hit and which miss for sure, of what Cross has found.
  template <class E>
  static HWY_INLINE void Decide(E e, Vec<E> u, Vec<E> v, Vec<E> t, Vec<E> det,
                                Vec<E> bound, Vec<E> of_det, Vec<E> of_t,
                                const ExactRange<T>& range, Mask<E>& hit,
                                Mask<E>& miss) {
    const auto w = Sub(Sub(det, u), v);
    // NaN where u or v is, for w is then.
    const auto least = MinOrSecond(MinOrSecond(u, v), w);
    const auto margin = [&](const RangeEnd<T>& end) HWY_ATTR {
      return DifferenceOfProducts<kFma>(t, Set(e, end.of_t), det,
                                        Set(e, end.of_det));
    };
    const auto bound_of = [&](const RangeEnd<T>& end) HWY_ATTR {
      return SumOfProducts<kFma>(of_t, Set(e, end.bound_of_t), of_det,
                                 Set(e, end.bound_of_det));
    };
    const auto zero = Zero(e);
    const auto from_first = margin(range.first);
    const auto from_last = Sub(zero, margin(range.last));
    const auto first_bound = bound_of(range.first);
    const auto last_bound = bound_of(range.last);
    hit = And(Gt(least, bound), Gt(MinOrSecond(Sub(from_first, first_bound),
                                               Sub(from_last, last_bound)),
                                   zero));
    const auto out_of_range =
        MinOrSecond(Add(from_first, first_bound), Add(from_last, last_bound));
    miss = Or(Lt(Add(least, bound), zero),
              And(Lt(out_of_range, zero), Gt(det, bound)));
  }

 private:
  static constexpr T kLeastSize =
      sizeof(T) == 4 ? static_cast<T>(0x1p-42) : static_cast<T>(0x1p-340);

  HWY_INLINE RayFilter(D d, Vec<D> ax, Vec<D> ay, Vec<D> az, Vec<D> e1x,
                       Vec<D> e1y, Vec<D> e1z, Vec<D> e2x, Vec<D> e2y,
                       Vec<D> e2z)
      : RayFilter(d, ax, ay, az, e1x, e1y, e1z, e2x, e2y, e2z,
                  hn::Max(hn::Max(LargestMagnitude(e1x, e1y, e1z),
                                  LargestMagnitude(e2x, e2y, e2z)),
                          Set(d, kLeastSize))) {}
  HWY_INLINE RayFilter(D d, Vec<D> ax, Vec<D> ay, Vec<D> az, Vec<D> e1x,
                       Vec<D> e1y, Vec<D> e1z, Vec<D> e2x, Vec<D> e2y,
                       Vec<D> e2z, Vec<D> size)
      : ax_(d, ax),
        ay_(d, ay),
        az_(d, az),
        e1x_(d, e1x),
        e1y_(d, e1y),
        e1z_(d, e1z),
        e2x_(d, e2x),
        e2y_(d, e2y),
        e2z_(d, e2z),
        nx_(d, DifferenceOfProducts<kFma>(e1y, e2z, e1z, e2y)),
        ny_(d, DifferenceOfProducts<kFma>(e1z, e2x, e1x, e2z)),
        nz_(d, DifferenceOfProducts<kFma>(e1x, e2y, e1y, e2x)),
        edge4_(d, Mul(Set(d, T{4}), size)),
        area4_(d, Mul(Mul(Set(d, T{4}), size), size)),
        area16_(d, Mul(Mul(Set(d, T{16}), size), size)),
        least_of_t_(
            d, Mul(Mul(Mul(Set(d, T{16}), size), size), Set(d, kLeastSize))) {}

  Held<D> ax_, ay_, az_;
  Held<D> e1x_, e1y_, e1z_;
  Held<D> e2x_, e2y_, e2z_;
  Held<D> nx_, ny_, nz_;
  Held<D> edge4_, area4_, area16_, least_of_t_;
};

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

#endif  // include guard that Highway toggles
