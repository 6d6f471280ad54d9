// Point in triangle by three cross products, with a way out after each edge:
// cross_product as people write it with && or with early returns.
//
//   ex·(y − vy) ≥ ey·(x − vx) for one edge e after the other; the first that
//   fails ends it
//
// Set-up: 3 edges. Per point: 2 to 6 subtractions, 2 to 6 multiplications, 1
// to 3 compares and as many branches. In a vector the way out is taken where
// no lane is left. Boundary, winding, degenerate: as cross_product.
// Fails: as cross_product, whose answers these are.
// What is saved in arithmetic is paid in branches: on points that come once
// half of the edges' answers are a guess. The compiler may not turn the
// branches into arithmetic, since a comparison can trap; the test
// early_out_is_compiled_as_branches looks.
// Worst known f32 inputs, A B C p (tests/worst_inputs.csv has f64 as well):
//   cross_product_early_out, said inside, is 1.5e+07 ulps outside:
//     (-0x1.b92e6cp-1, -0x1.cb0ddp-1) (0x1.cc69c8p-3, 0x1.7d37p-7)
//     (-0x1.0b28p-1, -0x1.399524p-1) (0x1.d27836p-1, 0x1.2babdp-1)

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/methods/cross_product_early_out.cc"
#include <hwy/foreach_target.h>

#include "kernels/rows-inl.h"
#include "kernels/triangle-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

template <class D>
class CrossProductEarlyOut {
 public:
  HWY_INLINE CrossProductEarlyOut(D d, const Triangles<D>& t) : edges_(d, t) {}

  template <class E>
  HWY_INLINE Mask<E> Inside(E e, Vec<E> x, Vec<E> y) const {
    const auto& [ab, bc, ca] = edges_;
    const auto dy0 = Sub(y, ab.vy.In(e));
    const auto dx0 = Sub(x, ab.vx.In(e));
    // 0·(dx + dy) keeps infinite points out: see cross_product.
    const auto left0 = MulAdd(Zero(e), Add(dx0, dy0), Mul(ab.ex.In(e), dy0));
    const auto in0 = Ge(left0, Mul(ab.ey.In(e), dx0));
    if (hn::AllFalse(e, in0)) return in0;
    const auto in1 = AndGe(in0, Mul(bc.ex.In(e), Sub(y, bc.vy.In(e))),
                           Mul(bc.ey.In(e), Sub(x, bc.vx.In(e))));
    if (hn::AllFalse(e, in1)) return in1;
    return AndGe(in1, Mul(ca.ex.In(e), Sub(y, ca.vy.In(e))),
                 Mul(ca.ey.In(e), Sub(x, ca.vx.In(e))));
  }

 private:
  Edges<D> edges_;
};

constexpr Method kCrossProductEarlyOut{
    .key = "cross_product_early_out",
    .source = "common advice",
    .formula = "ex·(y − vy) ≥ ey·(x − vx), edge by edge until one fails",
};

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

PITBENCH_KERNELS(cross_product_early_out,
                 FloatRows<CrossProductEarlyOut>(kCrossProductEarlyOut));
