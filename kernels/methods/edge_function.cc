// Point in triangle by three edge functions (Pineda 1988).
//
//   e_k(x, y) = A_k·x + B_k·y + C_k,   inside iff every e_k ≥ 0
//
// Set-up: 3 edges, 6 multiplications, 3 subtractions. Per point: 6
// multiplications, 6 additions (with FMA 6 multiply-adds), 3 compares.
// Boundary: closed, or top-left: each edge is compared with 0 or with the
// smallest number above it. Winding: fixed by the set-up. Degenerate: contains
// nothing.
// Fails: |C_k| grows with the distance from the origin, and with it the error;
// neighbours disagree on their common edge.
// Integers: exact while the coordinates of triangles and points differ by less
// than 2^15 (i32) or 2^7 (i16): every edge value is then at most 2·(2^15 − 1)²
// or 2·(2^7 − 1)² and fits; what wraps on the way to it does no harm. No NaN
// there: a degenerate triangle gets C = −1, A = B = 0.
// Worst known f32 inputs, A B C p (tests/worst_inputs.csv has f64 as well):
//   edge_function, said inside, is 1.83e+07 ulps outside:
//     (0x1.8p-1, -0x1.50a1c2p-1) (0x1.ep-1, -0x1.50a1c2p-1)
//     (0x1.8p-4, -0x1.50a1bep-1) (-0x1.ffffp-1, -0x1.50a1b8p-1)
//   edge_function_top_left, said inside, is 1.8e+07 ulps outside:
//     (-0x1.f0ee38p-1, -0x1.8p-1) (-0x1.f0ee38p-1, -0x1.6p-1)
//     (-0x1.f0ee3ap-1, -0x1.4cp-2) (-0x1.f0ee4p-1, 0x1.7ff8p-1)
//   edge_function_fma, said inside, is 1.6e+07 ulps outside:
//     (-0x1.e992aap-1, -0x1.d04p-2) (-0x1.e992acp-1, -0x1p+0)
//     (-0x1.e992aap-1, -0x1.ep-1) (-0x1.e992aap-1, 0x1.ffffep-2)
//   edge_function_top_left_fma, said inside, is 1.55e+07 ulps outside:
//     (0x1p+0, -0x1.f30948p-1) (0x1.c76a8cp-2, -0x1.f30948p-1)
//     (-0x1.35e3ep-4, -0x1.f30946p-1) (-0x1.ff8p-1, -0x1.f30946p-1)

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/methods/edge_function.cc"
#include <hwy/foreach_target.h>

#include "kernels/rows-inl.h"
#include "kernels/triangle-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

template <class D, bool kFma, Boundary kBoundary>
class EdgeFunction {
  using T = TFromD<D>;

 public:
  HWY_INLINE EdgeFunction(D d, const Triangles<D>& t)
      : EdgeFunction(d, t, Sign(d, DoubleArea(t))) {}

  template <class E>
  HWY_INLINE Mask<E> Inside(E e, Vec<E> x, Vec<E> y) const {
    const auto e0 = Edge(a0_.In(e), b0_.In(e), c0_.In(e), x, y);
    const auto e1 = Edge(a1_.In(e), b1_.In(e), c1_.In(e), x, y);
    const auto e2 = Edge(a2_.In(e), b2_.In(e), c2_.In(e), x, y);
    if constexpr (kBoundary == Boundary::kClosed) {
      return AllNonNegative(e, e0, e1, e2);
    } else {
      return AllAtLeast(e0, least0_.In(e), e1, least1_.In(e), e2,
                        least2_.In(e));
    }
  }

 private:
  HWY_INLINE EdgeFunction(D d, const Triangles<D>& t, Vec<D> sign)
      : a0_(d, Mul(Sub(t.Ay(), t.By()), sign)),
        b0_(d, Mul(Sub(t.Bx(), t.Ax()), sign)),
        c0_(d, Constant(d, a0_.In(d), b0_.In(d), t.Ax(), t.Ay(), sign)),
        a1_(d, Mul(Sub(t.By(), t.Cy()), sign)),
        b1_(d, Mul(Sub(t.Cx(), t.Bx()), sign)),
        c1_(d, Constant(d, a1_.In(d), b1_.In(d), t.Bx(), t.By(), sign)),
        a2_(d, Mul(Sub(t.Cy(), t.Ay()), sign)),
        b2_(d, Mul(Sub(t.Ax(), t.Cx()), sign)),
        c2_(d, Constant(d, a2_.In(d), b2_.In(d), t.Cx(), t.Cy(), sign)),
        least0_(d, b0_.In(d), Sub(Zero(d), a0_.In(d))),
        least1_(d, b1_.In(d), Sub(Zero(d), a1_.In(d))),
        least2_(d, b2_.In(d), Sub(Zero(d), a2_.In(d))) {}

  static HWY_INLINE Vec<D> Sign(D d, Vec<D> area) {
    if constexpr (std::is_integral_v<T>) {
      const auto one = Set(d, T{1});
      return hn::Max(hn::Min(area, one), Sub(Zero(d), one));
    } else {
      return Winding(d, area);
    }
  }

  // C such that the edge through (x, y) with normal (a, b) is 0 there.
  static HWY_INLINE Vec<D> Constant(D d, Vec<D> a, Vec<D> b, Vec<D> x, Vec<D> y,
                                    Vec<D> sign) {
    const auto c = Sub(Zero(d), Add(Mul(a, x), Mul(b, y)));
    if constexpr (std::is_integral_v<T>) {
      return IfThenElse(hn::Eq(sign, Zero(d)), Set(d, T{-1}), c);
    } else {
      (void)sign;
      return c;
    }
  }

  template <class V>
  static HWY_INLINE V Edge(V a, V b, V c, V x, V y) {
    if constexpr (kFma) {
      return MulAdd(a, x, MulAdd(b, y, c));
    } else {
      return Add(Add(Mul(a, x), Mul(b, y)), c);
    }
  }

  Held<D> a0_, b0_, c0_;
  Held<D> a1_, b1_, c1_;
  Held<D> a2_, b2_, c2_;
  [[no_unique_address]] Least<D, kBoundary> least0_;
  [[no_unique_address]] Least<D, kBoundary> least1_;
  [[no_unique_address]] Least<D, kBoundary> least2_;
};

template <class D>
using EdgeFunctionPlain = EdgeFunction<D, false, Boundary::kClosed>;
template <class D>
using EdgeFunctionFma = EdgeFunction<D, true, Boundary::kClosed>;
template <class D>
using EdgeFunctionTopLeft = EdgeFunction<D, false, Boundary::kTopLeft>;
template <class D>
using EdgeFunctionTopLeftFma = EdgeFunction<D, true, Boundary::kTopLeft>;

constexpr Method kEdgeFunction{
    .key = "edge_function",
    .source = "Pineda 1988",
    .formula = "A·x + B·y + C ≥ 0 for each edge",
};
constexpr Method kEdgeFunctionFma{
    .key = "edge_function_fma",
    .source = kEdgeFunction.source,
    .formula = kEdgeFunction.formula,
    .fma = true,
};
constexpr Method kEdgeFunctionTopLeft{
    .key = "edge_function_top_left",
    .source = "Pineda 1988, with the rasterisers' rule",
    .formula = "A·x + B·y + C ≥ 0 for a top or left edge, else > 0",
    .boundary = Boundary::kTopLeft,
};

constexpr Method kEdgeFunctionTopLeftFma{
    .key = "edge_function_top_left_fma",
    .source = kEdgeFunctionTopLeft.source,
    .formula = kEdgeFunctionTopLeft.formula,
    .boundary = Boundary::kTopLeft,
    .fma = true,
};

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

PITBENCH_KERNELS(edge_function,
                 FloatRows<EdgeFunctionPlain>(kEdgeFunction) +
                     GridRows<EdgeFunctionPlain>(kEdgeFunction) +
                     PointListRows<EdgeFunctionPlain>(kEdgeFunction) +
                     AosRows<EdgeFunctionPlain>(kEdgeFunction) +
                     FmaRows<EdgeFunctionFma>(kEdgeFunctionFma) +
                     AosFmaRows<EdgeFunctionFma>(kEdgeFunctionFma) +
                     FloatRows<EdgeFunctionTopLeft>(kEdgeFunctionTopLeft) +
                     FmaRows<EdgeFunctionTopLeftFma>(kEdgeFunctionTopLeftFma));
