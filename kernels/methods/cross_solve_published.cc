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
// Worst known f32 inputs, A B C p (tests/worst_inputs.csv has f64 as well):
//   cross_solve_published, said inside, is 3.77e+07 ulps outside:
//     (0x1.fce164p-1, 0x1.95554p-3) (0x1.fce17p-1, 0x1.95556p-3)
//     (0x1.fce168p-1, 0x1.95554p-3) (-0x1.d8p-1, -0x1.f52d98p-1)
//   cross_solve_published_fma, said inside, is 3.56e+07 ulps outside:
//     (-0x1.59512p-1, -0x1.3b56f8p-2) (-0x1.59512p-1, -0x1.3b56f4p-2)
//     (-0x1.59511ep-1, -0x1.3b56f8p-2) (0x1.ffep-1, 0x1.fff87cp-1)

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/methods/cross_solve_published.cc"
#include <hwy/foreach_target.h>

#include "kernels/rows-inl.h"
#include "kernels/triangle-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

template <class D, bool kFma>
class CrossSolvePublished {
 public:
  HWY_INLINE CrossSolvePublished(D d, const Triangles<D>& t)
      : vertices_(ValidVertices(d, t)) {}

  // 0/0 and ∞/∞ are NaN and fail both compares.
  template <class E>
  HWY_INLINE Mask<E> Inside(E e, Vec<E> x, Vec<E> y) const {
    auto sa = x;
    auto sb = x;
    auto sc = x;
    CrossFromPoint<kFma>(vertices_, e, x, y, sa, sb, sc);
    const auto b = Div(sb, sa);
    const auto c = Div(sc, sa);
    const auto zero = Zero(e);
    const auto one = Set(e, TFromD<E>{1});
    return AndLe(AndGe(AndLe(Ge(b, zero), b, one), c, zero), c, one);
  }

 private:
  Vertices<D> vertices_;
};

template <class D>
using PublishedPlain = CrossSolvePublished<D, false>;
template <class D>
using PublishedFma = CrossSolvePublished<D, true>;

constexpr Method kCrossSolvePublished{
    .key = "cross_solve_published",
    .source = "Im Yongsik's blog 2022, as written",
    .formula =
        "s_b/s_a and s_c/s_a in [0, 1], s = (xa, xb, xc) × "
        "(ya, yb, yc), relative to P",
    .accepts = Accepts::kThirdNearVertexA,
};

constexpr Method kCrossSolvePublishedFma{
    .key = "cross_solve_published_fma",
    .source = kCrossSolvePublished.source,
    .formula = kCrossSolvePublished.formula,
    .accepts = kCrossSolvePublished.accepts,
    .fma = true,
};

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

PITBENCH_KERNELS(cross_solve_published,
                 FloatRows<PublishedPlain>(kCrossSolvePublished) +
                     FmaRows<PublishedFma>(kCrossSolvePublishedFma));
