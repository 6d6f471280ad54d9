// Point in triangle by three determinants, two of them per point (qTriangle's
// program).
//
//   U = (P − A) × (C − A),  V = (B − A) × (P − A),  Area = (B − A) × (C − A)
//   inside iff U ≥ 0, V ≥ 0 and U + V < Area (closed form: ≤)
//
// Set-up: 2 edges, 2 multiplications. Per point: 4 subtractions, 4
// multiplications, 1 addition, 3 compares; with FMA 2 subtractions, 2
// multiplications, 2 multiply-subtracts, 1 addition.
// Boundary: half-open, BC is dropped, as in qTriangle's program; the closed
// form keeps it. Winding: fixed by the set-up. Degenerate: contains nothing.
// Fails: as cross_product_det; on BC with the rounding of three terms instead
// of one.
// Worst known f32 inputs, A B C p (tests/worst_inputs.csv has f64 as well):
//   barycentric_determinant, said inside, is 1.52e+07 ulps outside:
//     (-0x1.0c3434p-1, -0x1.b60948p-1) (0x1.3d54dp-4, -0x1.aef314p-2)
//     (0x1.ed903p-4, -0x1.8f1984p-2) (0x1.b48db6p-1, 0x1.1dc018p-3)
//   barycentric_determinant_closed, said inside, is 1.79e+07 ulps outside:
//     (-0x1.f8664cp-2, 0x1.b4c6eap-1) (0x1.b286bp-4, 0x1.a643p-7)
//     (0x1.4f148p-5, 0x1.ab7cp-4) (0x1.7302ecp-1, -0x1.b5de58p-1)
//   barycentric_determinant_fma, said inside, is 1.12e+07 ulps outside:
//     (0x1.cb026ep-1, -0x1.5e809ap-1) (0x1.0e7d3p-4, 0x1.541e7p-4)
//     (-0x1.ef70e4p-4, 0x1.06051p-2) (-0x1.3928dcp-1, 0x1.6b399ap-1)
//   barycentric_determinant_closed_fma, said inside, is 1.12e+07 ulps outside:
//     (0x1.cb026ep-1, -0x1.5e809ap-1) (0x1.0e7d3p-4, 0x1.541e7p-4)
//     (-0x1.ef70e4p-4, 0x1.06051p-2) (-0x1.3928dcp-1, 0x1.6b399ap-1)

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/methods/barycentric_determinant.cc"
#include <hwy/foreach_target.h>

#include "kernels/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

template <class D, Boundary kBoundary, bool kFma>
class BarycentricDeterminant {
 public:
  HWY_INLINE BarycentricDeterminant(D d, const Triangles<D>& t)
      : BarycentricDeterminant(d, t.Ax(), t.Ay(), FromA(t.BxUsedOnce(), t.Ax()),
                               FromA(t.ByUsedOnce(), t.Ay()),
                               FromA(t.CxUsedOnce(), t.Ax()),
                               FromA(t.CyUsedOnce(), t.Ay())) {}

  template <class E>
  HWY_INLINE Mask<E> Inside(E e, Vec<E> x, Vec<E> y) const {
    const auto u = U(e, x, y);
    const auto v = V(e, x, y);
    const auto sum = Add(u, v);
    const auto in = Ge(MinOrSecond(u, v), Zero(e));
    if constexpr (kOne) {
      return AndSumFits<E>(in, sum, size_.In(e));
    } else {
      return AndValidSumFits(e, in, sum);
    }
  }

  template <class E>
  HWY_INLINE void Weights(E e, Vec<E> x, Vec<E> y, Vec<E>& wa, Vec<E>& wb,
                          Vec<E>& wc) const {
    const auto one = Set(e, TFromD<E>{1});
    wb = Mul(U(e, x, y), inverse_size_.In(e));
    wc = Mul(V(e, x, y), inverse_size_.In(e));
    wa = Sub(one, Add(wb, wc));
  }

 private:
  // One triangle for many points has its winding in its vectors, and NaN where
  // it contains nothing. A triangle for one answer is cheaper otherwise: signs
  // are turned afterwards, and whether it is valid is asked with the answer.
  static constexpr bool kOne = std::is_same_v<D, OneLane<TFromD<D>>>;

  HWY_INLINE BarycentricDeterminant(D d, Vec<D> ax, Vec<D> ay, Vec<D> bx,
                                    Vec<D> by, Vec<D> cx, Vec<D> cy)
      : BarycentricDeterminant(d, ax, ay, bx, by, cx, cy,
                               DifferenceOfProducts<false>(bx, cy, by, cx),
                               DifferenceOfProducts<kFma>(bx, cy, by, cx)) {}

  // `area` tells whether the triangle is degenerate, `contracted` is what the
  // method compares with.
  HWY_INLINE BarycentricDeterminant(D d, Vec<D> ax, Vec<D> ay, Vec<D> bx,
                                    Vec<D> by, Vec<D> cx, Vec<D> cy,
                                    Vec<D> area, Vec<D> contracted)
      : ax_(d, ax),
        ay_(d, ay),
        bx_(d, Turned(d, bx, area)),
        by_(d, Turned(d, by, area)),
        cx_(d, Turned(d, cx, area)),
        cy_(d, Turned(d, cy, area)),
        size_(d, Abs(contracted)),
        inverse_size_(
            d, ValidOrNaN(d, area, Div(Set(d, TFromD<D>{1}), Abs(contracted)))),
        area_(d, area) {}

  // `v` as seen from A. All six differences of a triangle for one answer are
  // negated, which no product of two of them shows: so what is subtracted may
  // be an operand in memory.
  template <class V>
  static HWY_INLINE V FromA(V v, V a) {
    return kOne ? Sub(v, a) : Sub(a, v);
  }

  static HWY_INLINE Vec<D> Turned(D d, Vec<D> v, Vec<D> area) {
    if constexpr (kOne) {
      return Mul(v, Winding(d, area));
    } else {
      (void)d;
      (void)area;
      return v;
    }
  }
  template <class E>
  HWY_INLINE Vec<E> TurnedLater(E e, Vec<E> v) const {
    if constexpr (kOne) {
      (void)e;
      return v;
    } else {
      return TurnedBy(e, v, area_.In(e));
    }
  }

  template <class E>
  static HWY_INLINE Mask<E> AndSumFits(Mask<E> in, Vec<E> sum, Vec<E> size) {
    return kBoundary == Boundary::kClosed ? AndLe(in, sum, size)
                                          : AndLt(in, sum, size);
  }

  // The same, and the triangle is valid; in the lanes `in` no u or v is
  // negative.
  template <class E>
  HWY_INLINE Mask<E> AndValidSumFits(E e, Mask<E> in, Vec<E> sum) const {
    const auto area = area_.In(e);
    const auto size = size_.In(e);
    if constexpr (kHasClasses<E>) {
      return AndSumFits<E>(in, sum, ValidOrNaN(e, area, size));
    } else {
      // Half-open the area is not 0 if the sum, which is not below 0, is less.
      if constexpr (kBoundary == Boundary::kClosed || kFma) {
        in = And(in, hn::Ne(area, Zero(e)));
      }
      // What waits for the area alone is known before the sum is.
      return AndSumFits<E>(in, sum, NaNUnlessFinite(e, size, area));
    }
  }

  template <class E>
  HWY_INLINE Vec<E> U(E e, Vec<E> x, Vec<E> y) const {
    return TurnedLater(
        e, DifferenceOfProducts<kFma>(FromA(x, ax_.In(e)), cy_.In(e),
                                      FromA(y, ay_.In(e)), cx_.In(e)));
  }

  template <class E>
  HWY_INLINE Vec<E> V(E e, Vec<E> x, Vec<E> y) const {
    return TurnedLater(
        e, DifferenceOfProducts<kFma>(bx_.In(e), FromA(y, ay_.In(e)), by_.In(e),
                                      FromA(x, ax_.In(e))));
  }

  Held<D> ax_, ay_;
  Held<D> bx_, by_, cx_, cy_;
  Held<D> size_, inverse_size_, area_;
};

template <class D>
using HalfOpen = BarycentricDeterminant<D, Boundary::kHalfOpen, false>;
template <class D>
using HalfOpenFma = BarycentricDeterminant<D, Boundary::kHalfOpen, true>;
template <class D>
using Closed = BarycentricDeterminant<D, Boundary::kClosed, false>;
template <class D>
using ClosedFma = BarycentricDeterminant<D, Boundary::kClosed, true>;

constexpr Method kHalfOpen{
    .key = "barycentric_determinant",
    .source = "qTriangle's program",
    .formula = "U ≥ 0, V ≥ 0, U + V < Area, by cross products from vertex A",
    .boundary = Boundary::kHalfOpen,
};
constexpr Method kHalfOpenFma{
    .key = "barycentric_determinant_fma",
    .source = kHalfOpen.source,
    .formula = kHalfOpen.formula,
    .boundary = kHalfOpen.boundary,
    .fma = true,
};
constexpr Method kClosed{
    .key = "barycentric_determinant_closed",
    .source = "qTriangle's program, with ≤",
    .formula = "U ≥ 0, V ≥ 0, U + V ≤ Area, by cross products from vertex A",
};
constexpr Method kClosedFma{
    .key = "barycentric_determinant_closed_fma",
    .source = kClosed.source,
    .formula = kClosed.formula,
    .fma = true,
};

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

PITBENCH_KERNELS(barycentric_determinant,
                 FloatRows<HalfOpen>(kHalfOpen) +
                     FmaRows<HalfOpenFma>(kHalfOpenFma) +
                     FloatRows<Closed>(kClosed) + AosRows<Closed>(kClosed) +
                     FmaRows<ClosedFma>(kClosedFma) +
                     AosFmaRows<ClosedFma>(kClosedFma));
