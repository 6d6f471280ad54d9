// The plain loop of cross_product_det compiled with -ffast-math: kept to show
// what that flag does.
//
//   ex·(y − vy) − ey·(x − vx) ≥ 0 for each edge e from its vertex v
//
// Set-up and cost: as cross_product_det, less what the compiler saves by
// contracting and by taking terms in another order.
// Boundary: closed. Winding: fixed by the set-up. Degenerate: contains nothing,
// if the compiler lets NaN through, which it need not.
// Fails: as cross_product_det_fma, though the source has no multiply-add: its
// own vertices and points of its edges are thrown out, and neighbours leave
// holes. And nothing promises that NaN and infinity are outside: with this flag
// the compiler may take it that there are none.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/methods/cross_product_fast_math.cc"
#include <hwy/foreach_target.h>

#include "kernels/rows-inl.h"
#include "kernels/triangle-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

#if !defined(__FAST_MATH__)
#error "this file is only for the objects that are compiled with -ffast-math"
#endif

template <class D>
class CrossProductFastMath {
 public:
  HWY_INLINE CrossProductFastMath(D d, const Triangles<D>& t) : edges_(d, t) {}

  template <class E>
  HWY_INLINE Mask<E> Inside(E e, Vec<E> x, Vec<E> y) const {
    return AllNonNegative(e, EdgeCross<false>(edges_.ab, e, x, y),
                          EdgeCross<false>(edges_.bc, e, x, y),
                          EdgeCross<false>(edges_.ca, e, x, y));
  }

 private:
  Edges<D> edges_;
};

constexpr Method kCrossProductFastMath{
    .key = "cross_product_fast_math",
    .source = "cross_product_det, compiled with -ffast-math",
    .formula =
        "ex·(y − vy) − ey·(x − vx) ≥ 0 for each edge e from its vertex "
        "v",
    .fma = true,
    .warning =
        "-ffast-math: contracted and reordered as the compiler likes; NaN and "
        "infinity are not provided for",
};

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

PITBENCH_KERNELS(cross_product_fast_math,
                 FloatRows<CrossProductFastMath>(kCrossProductFastMath));
