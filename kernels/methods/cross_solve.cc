// Point in triangle by the cross product of two coordinate vectors (Im
// Yongsik's blog of 2022, mended: signs only, no division).
//
//   (s_a, s_b, s_c) = (xa, xb, xc) × (ya, yb, yc), coordinates relative to P;
//   inside iff all three have the same sign, 0 allowed
//
// Set-up: none of its own; the contract's check for a triangle that is
// degenerate or not finite. Per point: 9 subtractions, 6 multiplications, 6
// compares; with FMA 6 subtractions, 3 multiplications, 3 multiply-subtracts.
// Boundary: closed. Winding: any. Degenerate: contains nothing.
// Fails: differences from P round, so near an edge the sign may be wrong, but
// both neighbours see the same numbers for their common edge: no holes
// without FMA. With it the two round different products of the same pair, and
// both may lose a point.
// Worst known f32 inputs, A B C p (tests/worst_inputs.csv has f64 as well):
//   cross_solve, said inside, is 4.43e+07 ulps outside:
//     (-0x1.734804p-1, -0x1.fe8a08p-1) (-0x1.73484cp-1, -0x1.fe8a5cp-1)
//     (-0x1.73482p-1, -0x1.fe8a28p-1) (0x1.ffffp-1, 0x1.fffcp-1)
//   cross_solve_fma, said inside, is 3.74e+07 ulps outside:
//     (0x1.4f1a52p-1, 0x1.fd40fp-2) (0x1.4f1a5p-1, 0x1.fd40eep-2)
//     (0x1.4f1a5p-1, 0x1.fd40fp-2) (-0x1.fffff8p-1, -0x1.fffep-1)

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/methods/cross_solve.cc"
#include <hwy/foreach_target.h>

#include "kernels/rows-inl.h"
#include "kernels/triangle-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

template <class D, bool kFma>
class CrossSolve {
 public:
  HWY_INLINE CrossSolve(D d, const Triangles<D>& t)
      : vertices_(ValidVertices(d, t)) {}

  // An infinite coordinate of P makes one of the three NaN, or two of them
  // infinite with opposite signs: outside, as it has to be.
  template <class E>
  HWY_INLINE Mask<E> Inside(E e, Vec<E> x, Vec<E> y) const {
    auto sa = x;
    auto sb = x;
    auto sc = x;
    CrossFromPoint<kFma>(vertices_, e, x, y, sa, sb, sc);
    const auto zero = Zero(e);
    return Or(AllNonNegative(e, sa, sb, sc),
              AndLe(AndLe(Le(sa, zero), sb, zero), sc, zero));
  }

  template <class E>
  HWY_INLINE void Weights(E e, Vec<E> x, Vec<E> y, Vec<E>& wa, Vec<E>& wb,
                          Vec<E>& wc) const {
    CrossFromPoint<kFma>(vertices_, e, x, y, wa, wb, wc);
    const auto inverse_sum = Div(Set(e, TFromD<E>{1}), Add(Add(wa, wb), wc));
    wa = Mul(wa, inverse_sum);
    wb = Mul(wb, inverse_sum);
    wc = Mul(wc, inverse_sum);
  }

 private:
  Vertices<D> vertices_;
};

template <class D>
using CrossSolvePlain = CrossSolve<D, false>;
template <class D>
using CrossSolveFma = CrossSolve<D, true>;

constexpr Method kCrossSolve{
    .key = "cross_solve",
    .source = "Im Yongsik's blog 2022, mended",
    .formula = "(xa, xb, xc) × (ya, yb, yc), relative to P, of one sign",
};
constexpr Method kCrossSolveFma{
    .key = "cross_solve_fma",
    .source = kCrossSolve.source,
    .formula = kCrossSolve.formula,
    .fma = true,
};

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

PITBENCH_KERNELS(cross_solve, FloatRows<CrossSolvePlain>(kCrossSolve) +
                                  FmaRows<CrossSolveFma>(kCrossSolveFma));
