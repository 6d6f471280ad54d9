// Point in triangle by three cross products whose edge vectors are computed
// anew for every point: what cross_product gains by having them before.
//
//   (wx − vx)·(y − vy) ≥ (wy − vy)·(x − vx) for each edge vw
//
// Set-up: the winding. Per point: 12 subtractions, 6 multiplications, 3
// compares, and an addition and a multiply-add that make an infinite
// coordinate NaN. Boundary: closed. Winding: fixed by the set-up. Degenerate:
// contains nothing. (Loops one_point and pairs have every edge once anyhow.)
// Fails: as cross_product. (It exchanges B and C of a clockwise triangle, so
// its edges start at other vertices there and round otherwise.)
// A compiler sees that the edges do not depend on the point and takes them out
// of the loop; it is kept from knowing that (Opaque).
// Worst known f32 inputs, A B C p (tests/worst_inputs.csv has f64 as well):
//   cross_product_unhoisted, said inside, is 9.99e+06 ulps outside:
//     (0x1.098738p-1, 0x1.187dfcp-2) (0x1.ac2e4p-1, 0x1.b2d2cp-1)
//     (0x1.8d5acp-3, -0x1.41796ep-2) (-0x1.7faec6p-4, -0x1.ab82p-1)

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/methods/cross_product_unhoisted.cc"
#include <hwy/foreach_target.h>

#include "kernels/opaque-inl.h"
#include "kernels/rows-inl.h"
#include "kernels/triangle-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

template <class D>
class CrossProductUnhoisted {
 public:
  HWY_INLINE CrossProductUnhoisted(D d, const Triangles<D>& t)
      : vertices_(CounterClockwise(d, t, DoubleArea(t))) {}

  template <class E>
  HWY_INLINE Mask<E> Inside(E e, Vec<E> x, Vec<E> y) const {
    const auto ax = Opaque(vertices_.ax.In(e));
    const auto ay = Opaque(vertices_.ay.In(e));
    const auto bx = Opaque(vertices_.bx.In(e));
    const auto by = Opaque(vertices_.by.In(e));
    const auto cx = Opaque(vertices_.cx.In(e));
    const auto cy = Opaque(vertices_.cy.In(e));
    const auto dx0 = Sub(x, ax);
    const auto dy0 = Sub(y, ay);
    // 0·(dx + dy) keeps infinite points out: see cross_product.
    const auto left0 = MulAdd(Zero(e), Add(dx0, dy0), Mul(Sub(bx, ax), dy0));
    const auto in0 = Ge(left0, Mul(Sub(by, ay), dx0));
    const auto in1 =
        AndGe(in0, Mul(Sub(cx, bx), Sub(y, by)), Mul(Sub(cy, by), Sub(x, bx)));
    return AndGe(in1, Mul(Sub(ax, cx), Sub(y, cy)),
                 Mul(Sub(ay, cy), Sub(x, cx)));
  }

 private:
  Vertices<D> vertices_;
};

constexpr Method kCrossProductUnhoisted{
    .key = "cross_product_unhoisted",
    .source = "qTriangle, before its loop was tuned",
    .formula = "(wx − vx)·(y − vy) ≥ (wy − vy)·(x − vx) for each edge vw",
};

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

PITBENCH_KERNELS(cross_product_unhoisted,
                 FloatRows<CrossProductUnhoisted>(kCrossProductUnhoisted));
