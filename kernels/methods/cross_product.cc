// Point in triangle by three cross products, compared without subtracting
// (qTriangle, 2019 text).
//
//   ex·(y − vy) ≥ ey·(x − vx) for each edge e from its vertex v
//
// Set-up: 3 edges. Per point: 6 subtractions, 6 multiplications, 3 compares,
// and an addition and a multiply-add that make an infinite coordinate NaN.
// Boundary: closed. Winding: fixed by the set-up. Degenerate: contains nothing.
// Fails: x − vx rounds, so a point within a few ulps of an edge may fall on
// its other side, and two neighbours, which start their common edge at
// different vertices, may both lose it. Comparing the rounded products is
// proof against contraction to FMA.
// Worst known f32 inputs, A B C p (tests/worst_inputs.csv has f64 as well):
//   cross_product, said inside, is 1.5e+07 ulps outside:
//     (-0x1.b92e6cp-1, -0x1.cb0ddp-1) (0x1.cc69c8p-3, 0x1.7d37p-7)
//     (-0x1.0b28p-1, -0x1.399524p-1) (0x1.d27836p-1, 0x1.2babdp-1)

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/methods/cross_product.cc"
#include <hwy/foreach_target.h>

#include "kernels/rows-inl.h"
#include "kernels/triangle-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

template <class D>
class CrossProduct {
 public:
  HWY_INLINE CrossProduct(D d, const Triangles<D>& t) : edges_(d, t) {}

  template <class E>
  HWY_INLINE Mask<E> Inside(E e, Vec<E> x, Vec<E> y) const {
    const auto& [ab, bc, ca] = edges_;
    const auto dy0 = Sub(y, ab.vy.In(e));
    const auto dy1 = Sub(y, bc.vy.In(e));
    const auto dy2 = Sub(y, ca.vy.In(e));
    const auto dx0 = Sub(x, ab.vx.In(e));
    // Two infinite products compare as equal, so a point with an infinite
    // coordinate could pass where the other product overflows or is infinite as
    // well. 0·(dx + dy) is NaN for it, and else 0 (or NaN by overflow).
    const auto left0 = MulAdd(Zero(e), Add(dx0, dy0), Mul(ab.ex.In(e), dy0));
    const auto in0 = Ge(left0, Mul(ab.ey.In(e), dx0));
    const auto in1 = AndGe(in0, Mul(bc.ex.In(e), dy1),
                           Mul(bc.ey.In(e), Sub(x, bc.vx.In(e))));
    return AndGe(in1, Mul(ca.ex.In(e), dy2),
                 Mul(ca.ey.In(e), Sub(x, ca.vx.In(e))));
  }

 private:
  Edges<D> edges_;
};

constexpr Method kCrossProduct{
    .key = "cross_product",
    .source = "qTriangle, 2019 text",
    .formula = "ex·(y − vy) ≥ ey·(x − vx) for each edge e from its vertex v",
};

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

PITBENCH_KERNELS(cross_product, FloatRows<CrossProduct>(kCrossProduct) +
                                    AosRows<CrossProduct>(kCrossProduct));
