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

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

template <class D, bool kFma>
class CrossProductDet {
 public:
  HWY_INLINE CrossProductDet(D d, const Triangles<D>& t)
      : CrossProductDet(d, t, Winding(d, DoubleArea(t))) {}

  template <class E>
  HWY_INLINE Mask<E> Inside(E e, Vec<E> x, Vec<E> y) const {
    return AllNonNegative(
        e, Cross(ex0_.In(e), ey0_.In(e), Sub(x, ax_.In(e)), Sub(y, ay_.In(e))),
        Cross(ex1_.In(e), ey1_.In(e), Sub(x, bx_.In(e)), Sub(y, by_.In(e))),
        Cross(ex2_.In(e), ey2_.In(e), Sub(x, cx_.In(e)), Sub(y, cy_.In(e))));
  }

 private:
  HWY_INLINE CrossProductDet(D d, const Triangles<D>& t, Vec<D> winding)
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

  // ex·dy − ey·dx
  template <class V>
  static HWY_INLINE V Cross(V ex, V ey, V dx, V dy) {
    if constexpr (kFma) {
      return MulSub(ex, dy, Mul(ey, dx));
    } else {
      return Sub(Mul(ex, dy), Mul(ey, dx));
    }
  }

  Held<D> ax_, ay_, bx_, by_, cx_, cy_;
  Held<D> ex0_, ey0_, ex1_, ey1_, ex2_, ey2_;
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
