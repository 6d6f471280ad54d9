// Point in triangle by orientations in double-double arithmetic, as JTS and
// GEOS compute them (CGAlgorithmsDD, DD); float-float for f32.
//
//   (w − v) × (P − w) ≥ 0 for each edge vw, every number a sum of two
//
// JTS puts a floating-point filter before it, which answers for nearly all
// points and changes no answer; here it is bare, every point by the same
// instructions.
// Set-up: the orientation of the triangle and three edges in double-double. Per
// point and edge: two exact differences (6 operations each), two products (20),
// one difference (20), 1 compare. No FMA: products by Dekker's split.
// Boundary: closed. Winding: fixed by the set-up. Degenerate: contains nothing.
// Right where both differences of an edge are exact in one number (all
// coordinates multiples of one power of two, of at most 23 bits in f32, 52 in
// f64): then so are their products in two. And the range is that of
// shewchuk_adaptive.
// Fails: elsewhere the products round, to twice the bits: the edge from
// A = (-0x1.eee9fd621371ap+0, -0x1.0045116be2025p-1) to −A has
// (0x1.a1cc7b7044fafp-44, 0x1.b0ad90f7c737p-46) on its other side.
// Worst known f32 inputs, A B C p (tests/worst_inputs.csv has f64 as well):
//   double_double: none found
// by `pitbench hunt`, whose coordinates are 2^-30 to 1, those of P at least
// 1/2; report/recipes.csv has inputs elsewhere.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/methods/double_double.cc"
#include <hwy/foreach_target.h>

#include "kernels/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

// Numbers are high + low; a class or struct may not hold scalable vectors.

// a − b exactly: DD.selfAdd of a single number to another.
template <class V>
HWY_INLINE void Difference(V a, V b, V& high, V& low) {
  high = Sub(a, b);
  const V of_b = Sub(high, a);
  low = Sub(Sub(a, Sub(high, of_b)), Add(b, of_b));
}

// DD.selfMultiply(double, double), step by step.
template <class D>
HWY_INLINE void Multiply(D d, Vec<D> a, Vec<D> a_low, Vec<D> b, Vec<D> b_low,
                         Vec<D>& high, Vec<D>& low) {
  using T = TFromD<D>;
  constexpr int kHalf = (std::numeric_limits<T>::digits + 1) / 2;
  const auto splitter = Set(d, T{1 << kHalf} + 1);
  const auto ca = Mul(splitter, a);
  const auto ha = Sub(ca, Sub(ca, a));
  const auto ta = Sub(a, ha);
  const auto cb = Mul(splitter, b);
  const auto hb = Sub(cb, Sub(cb, b));
  const auto tb = Sub(b, hb);
  const auto product = Mul(a, b);
  const auto error =
      Add(Add(Add(Sub(Mul(ha, hb), product), Mul(ha, tb)), Mul(ta, hb)),
          Mul(ta, tb));
  const auto rest = Add(error, Add(Mul(a, b_low), Mul(a_low, b)));
  high = Add(product, rest);
  low = Add(rest, Sub(product, high));
}

// The upper number of a − b, whose sign is that of the difference
// (DD.selfAdd(double, double), whose last step leaves a lower number of 0 where
// the upper one is).
template <class V>
HWY_INLINE V Subtract(V a, V a_low, V b, V b_low) {
  const V sum = Sub(a, b);
  const V sum_low = Sub(a_low, b_low);
  const V e = Sub(sum, a);
  const V f = Sub(sum_low, a_low);
  const V s = Sub(Sub(a, Sub(sum, e)), Add(b, e));
  const V t = Sub(Sub(a_low, Sub(sum_low, f)), Add(b_low, f));
  const V first = Add(s, sum_low);
  const V high = Add(sum, first);
  const V low = Add(first, Sub(sum, high));
  return Add(high, Add(t, low));
}

// The edge from v to w as JTS takes it: w − v, and w, from which P is seen.
template <class D>
class DoubleDoubleEdge {
 public:
  HWY_INLINE DoubleDoubleEdge(D d, Vec<D> vx, Vec<D> vy, Vec<D> wx, Vec<D> wy,
                              Vec<D> winding)
      : wx_(d, wx),
        wy_(d, wy),
        ex_(d, Mul(High(wx, vx), winding)),
        ex_low_(d, Mul(Low(wx, vx), winding)),
        ey_(d, Mul(High(wy, vy), winding)),
        ey_low_(d, Mul(Low(wy, vy), winding)) {}

  // A number with the sign of (w − v) × (P − w).
  template <class E>
  HWY_INLINE Vec<E> Orientation(E e, Vec<E> x, Vec<E> y) const {
    auto dx = x;
    auto dx_low = x;
    auto dy = y;
    auto dy_low = y;
    Difference(x, wx_.In(e), dx, dx_low);
    Difference(y, wy_.In(e), dy, dy_low);
    auto left = x;
    auto left_low = x;
    auto right = x;
    auto right_low = x;
    Multiply(e, ex_.In(e), ex_low_.In(e), dy, dy_low, left, left_low);
    Multiply(e, ey_.In(e), ey_low_.In(e), dx, dx_low, right, right_low);
    return Subtract(left, left_low, right, right_low);
  }

 private:
  static HWY_INLINE Vec<D> High(Vec<D> a, Vec<D> b) { return Sub(a, b); }
  static HWY_INLINE Vec<D> Low(Vec<D> a, Vec<D> b) {
    auto high = a;
    auto low = a;
    Difference(a, b, high, low);
    return low;
  }

  Held<D> wx_, wy_;
  Held<D> ex_, ex_low_, ey_, ey_low_;
};

template <class D>
class DoubleDouble {
 public:
  HWY_INLINE DoubleDouble(D d, const Triangles<D>& t)
      : DoubleDouble(d, t, Winding(d, Area(d, t))) {}

  template <class E>
  HWY_INLINE Mask<E> Inside(E e, Vec<E> x, Vec<E> y) const {
    return AllNonNegative(e, ab_.Orientation(e, x, y), bc_.Orientation(e, x, y),
                          ca_.Orientation(e, x, y));
  }

 private:
  HWY_INLINE DoubleDouble(D d, const Triangles<D>& t, Vec<D> winding)
      : ab_(d, t.Ax(), t.Ay(), t.Bx(), t.By(), winding),
        bc_(d, t.Bx(), t.By(), t.Cx(), t.Cy(), winding),
        ca_(d, t.Cx(), t.Cy(), t.Ax(), t.Ay(), winding) {}

  static HWY_INLINE Vec<D> Area(D d, const Triangles<D>& t) {
    const DoubleDoubleEdge<D> ab(d, t.Ax(), t.Ay(), t.Bx(), t.By(),
                                 Set(d, TFromD<D>{1}));
    return ab.Orientation(d, t.Cx(), t.Cy());
  }

  DoubleDoubleEdge<D> ab_, bc_, ca_;
};

constexpr Method kDoubleDouble{
    .key = "double_double",
    .source = "JTS and GEOS, CGAlgorithmsDD",
    .formula = "(w − v) × (P − w) ≥ 0 for each edge vw, in double-double",
};

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

PITBENCH_KERNELS(double_double, FloatRows<DoubleDouble>(kDoubleDouble));
