// Point in triangle by the sign of three cross products (qTriangle, 2018
// text).
//
//   ex·(y − vy) − ey·(x − vx) ≥ 0 for each edge e from its vertex v
//
// Set-up: 3 edges. Per point: 9 subtractions, 6 multiplications, 3 compares;
// with FMA 6 subtractions, 3 multiplications, 3 multiply-subtracts.
// Boundary: closed. Winding: fixed by the set-up. Degenerate: contains nothing.
// Fails: as cross_product without FMA. With FMA one product is rounded and the
// other is not, so even a point that is exactly on an edge may be thrown out:
// cross(a, a) ≠ 0 for a = (0x1.99999ap-4, 0x1.333334p-2).
// Worst known f32 inputs, A B C p (tests/worst_inputs.csv has f64 as well):
//   cross_product_det, said inside, is 1.5e+07 ulps outside:
//     (-0x1.b92e6cp-1, -0x1.cb0ddp-1) (0x1.cc69c8p-3, 0x1.7d37p-7)
//     (-0x1.0b28p-1, -0x1.399524p-1) (0x1.d27836p-1, 0x1.2babdp-1)
//   cross_product_det_fma, said inside, is 7.54e+06 ulps outside:
//     (0x1.b6f098p-1, 0x1.64a7ep-1) (-0x1.db9bd8p-5, -0x1.9b2ap-2)
//     (0x1.6898e8p-1, 0x1.06abe8p-1) (-0x1.622ffap-2, -0x1.7e5f8ep-1)

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/methods/cross_product_det.cc"
#include <hwy/foreach_target.h>

#include "kernels/rows-inl.h"
#include "kernels/triangle-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

template <class D, bool kFma>
class CrossProductDet {
 public:
  HWY_INLINE CrossProductDet(D d, const Triangles<D>& t) : edges_(d, t) {}

  template <class E>
  HWY_INLINE Mask<E> Inside(E e, Vec<E> x, Vec<E> y) const {
    return AllNonNegative(e, EdgeCross<kFma>(edges_.ab, e, x, y),
                          EdgeCross<kFma>(edges_.bc, e, x, y),
                          EdgeCross<kFma>(edges_.ca, e, x, y));
  }

 private:
  Edges<D> edges_;
};

template <class D>
using CrossProductDetPlain = CrossProductDet<D, false>;
template <class D>
using CrossProductDetFma = CrossProductDet<D, true>;

constexpr Method kCrossProductDet{
    .key = "cross_product_det",
    .source = "qTriangle, 2018 text",
    .formula =
        "ex·(y − vy) − ey·(x − vx) ≥ 0 for each edge e from its vertex "
        "v",
};
constexpr Method kCrossProductDetFma{
    .key = "cross_product_det_fma",
    .source = kCrossProductDet.source,
    .formula = kCrossProductDet.formula,
    .fma = true,
};

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

PITBENCH_KERNELS(cross_product_det,
                 FloatRows<CrossProductDetPlain>(kCrossProductDet) +
                     FmaRows<CrossProductDetFma>(kCrossProductDetFma));
