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
