// Point in triangle by three cross products of the vertices relative to the
// point, each by Kahan's difference of products.
//
//   a·b − c·d: w = c·d, (a·b − w) + (w − c·d), both brackets by FMA
//
// The second bracket is the rounding error of w, exactly, so the result is
// within 1.5 ulp (Jeannerod, Louvet and Muller 2013) and has the sign of the
// exact value of what it is given: the rounded differences.
// Set-up: B and C exchanged where the triangle is clockwise. Per point: 6
// subtractions, 3 multiplications, 6 multiply-adds, 3 additions, 3 compares.
// Boundary: closed. Winding: fixed by the set-up. Degenerate: contains nothing.
// Right where the differences v − P are exact (all coordinates multiples of one
// power of two, of at most 23 bits in f32, 52 in f64), in the range of
// shewchuk_adaptive.
// Fails: elsewhere the differences round, as in cross_product_centered, and the
// sign is that of a slightly different triangle. Both neighbours see the same
// rounded differences: no holes.
// Worst known f32 inputs, A B C p (tests/worst_inputs.csv has f64 as well):
//   cross_product_kahan, said inside, is 1.95e+07 ulps outside:
//     (0x1.f54484p-2, 0x1.01f32ep-1) (0x1.f5448p-2, 0x1.01f32cp-1)
//     (0x1.f54482p-2, 0x1.01f32cp-1) (-0x1.e7898p-6, -0x1.11c9eep-1)

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/methods/cross_product_kahan.cc"
#include <hwy/foreach_target.h>

#include "kernels/rows-inl.h"
#include "kernels/triangle-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

template <class D>
class CrossProductKahan {
 public:
  HWY_INLINE CrossProductKahan(D d, const Triangles<D>& t)
      : vertices_(CounterClockwise(
            d, t,
            KahanDifference(Sub(t.Bx(), t.Ax()), Sub(t.Cy(), t.Ay()),
                            Sub(t.By(), t.Ay()), Sub(t.Cx(), t.Ax())))) {}

  // An infinite product is followed by ∞ − ∞: a point that is not finite is
  // NaN to at least one edge.
  template <class E>
  HWY_INLINE Mask<E> Inside(E e, Vec<E> x, Vec<E> y) const {
    const auto& v = vertices_;
    const auto xa = Sub(v.ax.In(e), x);
    const auto ya = Sub(v.ay.In(e), y);
    const auto xb = Sub(v.bx.In(e), x);
    const auto yb = Sub(v.by.In(e), y);
    const auto xc = Sub(v.cx.In(e), x);
    const auto yc = Sub(v.cy.In(e), y);
    return AllNonNegative(e, KahanDifference(xb, yc, xc, yb),
                          KahanDifference(xc, ya, xa, yc),
                          KahanDifference(xa, yb, xb, ya));
  }

 private:
  Vertices<D> vertices_;
};

constexpr Method kCrossProductKahan{
    .key = "cross_product_kahan",
    .source = "Kahan; Jeannerod, Louvet and Muller 2013",
    .formula = "(v − P) × (w − P) ≥ 0 for each edge vw, within 1.5 ulp",
    .fma = true,
};

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

PITBENCH_KERNELS(cross_product_kahan,
                 FmaRows<CrossProductKahan>(kCrossProductKahan));
