// Point in triangle by the cross product of two coordinate vectors (Im
// Yongsik's blog of 2022, mended: signs only, no division).
//
//   (s_a, s_b, s_c) = (xa, xb, xc) × (ya, yb, yc), coordinates relative to P;
//   inside iff all three have the same sign, 0 allowed
//
// Set-up: none of its own; the contract's check for a triangle that is
// degenerate or not finite. Per point: 9 subtractions, 6 multiplications, 6
// compares.
// Boundary: closed. Winding: any. Degenerate: contains nothing.
// Fails: differences from P round, so near an edge the sign may be wrong, but
// both neighbours see the same numbers for their common edge: no holes
// without FMA.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/methods/cross_solve.cc"
#include <hwy/foreach_target.h>

#include "kernels/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

template <class D>
class CrossSolve {
 public:
  HWY_INLINE CrossSolve(D d, const Triangles<D>& t)
      : ax_(d, ValidOrNaN(d, DoubleArea(t), t.Ax())),
        ay_(d, ValidOrNaN(d, DoubleArea(t), t.Ay())),
        bx_(d, t.Bx()),
        by_(d, t.By()),
        cx_(d, t.Cx()),
        cy_(d, t.Cy()) {}

  // An infinite coordinate of P makes one of the three NaN, or two of them
  // infinite with opposite signs: outside, as it has to be.
  template <class E>
  HWY_INLINE Mask<E> Inside(E e, Vec<E> x, Vec<E> y) const {
    auto sa = x;
    auto sb = x;
    auto sc = x;
    Solve(e, x, y, sa, sb, sc);
    const auto zero = Zero(e);
    return Or(AllNonNegative(e, sa, sb, sc),
              AndLe(AndLe(Le(sa, zero), sb, zero), sc, zero));
  }

  template <class E>
  HWY_INLINE void Weights(E e, Vec<E> x, Vec<E> y, Vec<E>& wa, Vec<E>& wb,
                          Vec<E>& wc) const {
    Solve(e, x, y, wa, wb, wc);
    const auto inverse_sum = Div(Set(e, TFromD<E>{1}), Add(Add(wa, wb), wc));
    wa = Mul(wa, inverse_sum);
    wb = Mul(wb, inverse_sum);
    wc = Mul(wc, inverse_sum);
  }

 private:
  template <class E>
  HWY_INLINE void Solve(E e, Vec<E> x, Vec<E> y, Vec<E>& sa, Vec<E>& sb,
                        Vec<E>& sc) const {
    const auto xa = Sub(ax_.In(e), x);
    const auto ya = Sub(ay_.In(e), y);
    const auto xb = Sub(bx_.In(e), x);
    const auto yb = Sub(by_.In(e), y);
    const auto xc = Sub(cx_.In(e), x);
    const auto yc = Sub(cy_.In(e), y);
    sa = Sub(Mul(xb, yc), Mul(xc, yb));
    sb = Sub(Mul(xc, ya), Mul(xa, yc));
    sc = Sub(Mul(xa, yb), Mul(xb, ya));
  }

  Held<D> ax_, ay_, bx_, by_, cx_, cy_;
};

constexpr Method kCrossSolve{
    .key = "cross_solve",
    .source = "Im Yongsik's blog 2022, mended",
    .formula = "(xa, xb, xc) × (ya, yb, yc), relative to P, of one sign",
};

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

PITBENCH_KERNELS(cross_solve, FloatRows<CrossSolve>(kCrossSolve));
