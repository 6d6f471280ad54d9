// Point in triangle by three cross products, compared without subtracting
// (qTriangle, 2019 text).
//
//   ex·(y − vy) ≥ ey·(x − vx) for each edge e from its vertex v
//
// Set-up: 3 edges. Per point: 6 subtractions, 6 multiplications, 3 compares,
// and one multiply-add that makes an infinite y NaN.
// Boundary: closed. Winding: fixed by the set-up. Degenerate: contains nothing.
// Fails: x − vx rounds, so a point within a few ulps of an edge may fall on
// its other side, and two neighbours, which start their common edge at
// different vertices, may both lose it. Comparing the rounded products is
// proof against contraction to FMA.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/methods/cross_product.cc"
#include <hwy/foreach_target.h>

#include "kernels/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

template <class D>
class CrossProduct {
 public:
  HWY_INLINE CrossProduct(D d, const Triangles<D>& t)
      : CrossProduct(d, t, Winding(d, DoubleArea(t))) {}

  template <class E>
  HWY_INLINE Mask<E> Inside(E e, Vec<E> x, Vec<E> y) const {
    const auto dy0 = Sub(y, ay_.In(e));
    const auto dy1 = Sub(y, by_.In(e));
    const auto dy2 = Sub(y, cy_.In(e));
    // Two infinite products compare as equal, so a point whose coordinates are
    // both infinite could pass. 0·dy is NaN for it, and 0 for every other.
    const auto left0 = MulAdd(Zero(e), dy0, Mul(ex0_.In(e), dy0));
    const auto in0 = Ge(left0, Mul(ey0_.In(e), Sub(x, ax_.In(e))));
    const auto in1 =
        AndGe(in0, Mul(ex1_.In(e), dy1), Mul(ey1_.In(e), Sub(x, bx_.In(e))));
    return AndGe(in1, Mul(ex2_.In(e), dy2), Mul(ey2_.In(e), Sub(x, cx_.In(e))));
  }

 private:
  HWY_INLINE CrossProduct(D d, const Triangles<D>& t, Vec<D> winding)
      : ax_(d, t.Ax()),
        ay_(d, t.Ay()),
        bx_(d, t.Bx()),
        by_(d, t.By()),
        cx_(d, t.Cx()),
        cy_(d, t.Cy()),
        ex0_(d, Mul(Sub(t.Bx(), t.Ax()), winding)),
        ey0_(d, Mul(Sub(t.By(), t.Ay()), winding)),
        ex1_(d, Mul(Sub(t.Cx(), t.Bx()), winding)),
        ey1_(d, Mul(Sub(t.Cy(), t.By()), winding)),
        ex2_(d, Mul(Sub(t.Ax(), t.Cx()), winding)),
        ey2_(d, Mul(Sub(t.Ay(), t.Cy()), winding)) {}

  Held<D> ax_, ay_, bx_, by_, cx_, cy_;
  Held<D> ex0_, ey0_, ex1_, ey1_, ex2_, ey2_;
};

constexpr Method kCrossProduct{
    .key = "cross_product",
    .source = "qTriangle, 2019 text",
    .formula = "ex·(y − vy) ≥ ey·(x − vx) for each edge e from its vertex v",
};

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

PITBENCH_KERNELS(cross_product, FloatRows<CrossProduct>(kCrossProduct));
