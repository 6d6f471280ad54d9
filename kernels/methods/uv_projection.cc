// Point in triangle by projection on two edges (qTriangle 2019; the course
// note's normal equations).
//
//   (u, v) = G⁻¹ · ((P − A)·(B − A), (P − A)·(C − A)),  G the Gram matrix of
//   the two edges;   inside iff u ≥ 0, v ≥ 0 and u + v ≤ 1
//
// Set-up: Gram matrix and its inverse, one division; the contract's check for
// a degenerate triangle, whose Gram determinant may round to more than 0. Per
// point: 2 subtractions, 8 multiplications, 5 additions, 3 compares; with FMA 4
// multiplications, 4 multiply-adds and 1 addition.
// Boundary: closed. Winding: any. Degenerate: contains nothing.
// Fails: the Gram determinant is the square of the area, so it vanishes on
// needles where the area does not: f32 (0, 0) (1, 0) (1, 0x1p-13). It
// underflows and overflows at the fourth root of the range.
// Worst known f32 inputs, A B C p (tests/worst_inputs.csv has f64 as well):
//   uv_projection, said inside, is 4.52e+07 ulps outside:
//     (0x1.e0ca0ep-1, 0x1.cc4a4cp-1) (0x1.df2492p-1, 0x1.cba85ep-1)
//     (0x1.e22aaap-1, 0x1.ccd1c4p-1) (-0x1.ffbp-1, -0x1.f4bfdp-1)
//   uv_projection_fma, said inside, is 3.62e+07 ulps outside:
//     (-0x1.bc9c5ap-1, -0x1.cabba8p-1) (-0x1.dd31b8p-4, -0x1.e58ffcp-1)
//     (0x1.8d06p-6, -0x1.ea9594p-1) (0x1.d9e148p-1, 0x1.ffea2p-1)

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/methods/uv_projection.cc"
#include <hwy/foreach_target.h>

#include "kernels/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

template <class D, bool kFma>
class UvProjection {
  using T = TFromD<D>;

 public:
  HWY_INLINE UvProjection(D d, const Triangles<D>& t)
      : UvProjection(d, t, Sub(t.Bx(), t.Ax()), Sub(t.By(), t.Ay()),
                     Sub(t.Cx(), t.Ax()), Sub(t.Cy(), t.Ay())) {}

  template <class E>
  HWY_INLINE Mask<E> Inside(E e, Vec<E> x, Vec<E> y) const {
    auto u = x;
    auto v = x;
    Project(e, x, y, u, v);
    const auto zero = Zero(e);
    return AndLe(Ge(MinOrSecond(u, v), zero), Add(u, v), Set(e, TFromD<E>{1}));
  }

  template <class E>
  HWY_INLINE void Weights(E e, Vec<E> x, Vec<E> y, Vec<E>& wa, Vec<E>& wb,
                          Vec<E>& wc) const {
    Project(e, x, y, wb, wc);
    wa = Sub(Set(e, TFromD<E>{1}), Add(wb, wc));
  }

 private:
  HWY_INLINE UvProjection(D d, const Triangles<D>& t, Vec<D> bx, Vec<D> by,
                          Vec<D> cx, Vec<D> cy)
      : UvProjection(d, t, bx, by, cx, cy, Dot(bx, by, bx, by),
                     Dot(bx, by, cx, cy), Dot(cx, cy, cx, cy)) {}

  HWY_INLINE UvProjection(D d, const Triangles<D>& t, Vec<D> bx, Vec<D> by,
                          Vec<D> cx, Vec<D> cy, Vec<D> bb, Vec<D> bc, Vec<D> cc)
      : UvProjection(d, t, bx, by, cx, cy, bb, bc, cc,
                     ValidOrNaN(d, DoubleArea(t),
                                Inverse(d, DifferenceOfProducts<kFma>(
                                               bb, cc, bc, bc)))) {}

  HWY_INLINE UvProjection(D d, const Triangles<D>& t, Vec<D> bx, Vec<D> by,
                          Vec<D> cx, Vec<D> cy, Vec<D> bb, Vec<D> bc, Vec<D> cc,
                          Vec<D> inverse)
      : ax_(d, t.Ax()),
        ay_(d, t.Ay()),
        bx_(d, bx),
        by_(d, by),
        cx_(d, cx),
        cy_(d, cy),
        g00_(d, Mul(cc, inverse)),
        g01_(d, Mul(Sub(Zero(d), bc), inverse)),
        g11_(d, Mul(bb, inverse)) {}

  template <class V>
  static HWY_INLINE V Dot(V ax, V ay, V bx, V by) {
    return SumOfProducts<kFma>(ax, bx, ay, by);
  }

  static HWY_INLINE Vec<D> Inverse(D d, Vec<D> determinant) {
    return ValidOrNaN(d, determinant, Div(Set(d, T{1}), determinant));
  }

  template <class E>
  HWY_INLINE void Project(E e, Vec<E> x, Vec<E> y, Vec<E>& u, Vec<E>& v) const {
    const auto dx = Sub(x, ax_.In(e));
    const auto dy = Sub(y, ay_.In(e));
    const auto on_b = Dot(dx, dy, bx_.In(e), by_.In(e));
    const auto on_c = Dot(dx, dy, cx_.In(e), cy_.In(e));
    u = SumOfProducts<kFma>(g00_.In(e), on_b, g01_.In(e), on_c);
    v = SumOfProducts<kFma>(g01_.In(e), on_b, g11_.In(e), on_c);
  }

  Held<D> ax_, ay_;
  Held<D> bx_, by_, cx_, cy_;
  Held<D> g00_, g01_, g11_;
};

template <class D>
using UvProjectionPlain = UvProjection<D, false>;
template <class D>
using UvProjectionFma = UvProjection<D, true>;

constexpr Method kUvProjection{
    .key = "uv_projection",
    .source = "qTriangle, 2019 text; ray/triangle course note",
    .formula =
        "u ≥ 0, v ≥ 0, u + v ≤ 1, (u, v) = G⁻¹ · dot products with the "
        "edges from A",
};
constexpr Method kUvProjectionFma{
    .key = "uv_projection_fma",
    .source = kUvProjection.source,
    .formula = kUvProjection.formula,
    .fma = true,
};

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

PITBENCH_KERNELS(uv_projection, FloatRows<UvProjectionPlain>(kUvProjection) +
                                    FmaRows<UvProjectionFma>(kUvProjectionFma));
