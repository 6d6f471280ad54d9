// Point in triangle by the cross product of two coordinate vectors, divided by
// its first component (Im Yongsik's blog of 2022, as written). Kept to show
// what it does.
//
//   s = (xa, xb, xc) × (ya, yb, yc), coordinates relative to P;
//   inside iff s_b/s_a and s_c/s_a lie in [0, 1]
//
// Set-up: none of its own; the contract's check for a triangle that is
// degenerate or not finite. Per point: 9 subtractions, 6 multiplications, 2
// divisions, 4 compares.
// Boundary: closed, of what it accepts. Winding: any. Degenerate: contains
// nothing.
// Fails: accepts only the third of the triangle nearest A, where w_b ≤ w_a and
// w_c ≤ w_a: (0, 0) (4, 0) (0, 4) does not contain (2, 1).

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/methods/cross_solve_published.cc"
#include <hwy/foreach_target.h>

#include "kernels/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

template <class D>
class CrossSolvePublished {
 public:
  HWY_INLINE CrossSolvePublished(D d, const Triangles<D>& t)
      : ax_(d, ValidOrNaN(d, DoubleArea(t), t.Ax())),
        ay_(d, ValidOrNaN(d, DoubleArea(t), t.Ay())),
        bx_(d, t.Bx()),
        by_(d, t.By()),
        cx_(d, t.Cx()),
        cy_(d, t.Cy()) {}

  // 0/0 and ∞/∞ are NaN and fail both compares.
  template <class E>
  HWY_INLINE Mask<E> Inside(E e, Vec<E> x, Vec<E> y) const {
    const auto xa = Sub(ax_.In(e), x);
    const auto ya = Sub(ay_.In(e), y);
    const auto xb = Sub(bx_.In(e), x);
    const auto yb = Sub(by_.In(e), y);
    const auto xc = Sub(cx_.In(e), x);
    const auto yc = Sub(cy_.In(e), y);
    const auto sa = Sub(Mul(xb, yc), Mul(xc, yb));
    const auto sb = Div(Sub(Mul(xc, ya), Mul(xa, yc)), sa);
    const auto sc = Div(Sub(Mul(xa, yb), Mul(xb, ya)), sa);
    const auto zero = Zero(e);
    const auto one = Set(e, TFromD<E>{1});
    return AndLe(AndGe(AndLe(Ge(sb, zero), sb, one), sc, zero), sc, one);
  }

 private:
  Held<D> ax_, ay_, bx_, by_, cx_, cy_;
};

constexpr Method kCrossSolvePublished{
    .key = "cross_solve_published",
    .source = "Im Yongsik's blog 2022, as written",
    .formula =
        "s_b/s_a and s_c/s_a in [0, 1], s = (xa, xb, xc) × "
        "(ya, yb, yc), relative to P",
    .accepts = Accepts::kThirdNearVertexA,
};

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

PITBENCH_KERNELS(cross_solve_published,
                 FloatRows<CrossSolvePublished>(kCrossSolvePublished));
