// Point in triangle in f64 for f32 input: three cross products of the vertices
// relative to the point.
//
//   (v − P) × (w − P) ≥ 0 for each edge vw, all in f64
//
// Set-up: the area in f64, by whose sign B and C are exchanged. Per point: as
// cross_product_centered (with FMA or by Kahan's difference of products, if
// so), on twice the vectors; and 8 promotions, 6 of them hoisted where the
// triangle stays.
// Boundary: closed. Winding: fixed by the set-up. Degenerate: contains nothing.
// Right where the determinant is exact: all coordinates multiples of one power
// of two, of at most 25 bits. By Kahan's difference already where the
// differences are exact: at most 52 bits, that is, exponents that spread over
// at most 28 binades. f64 does not overflow or underflow on products of f32.
// Fails: where the coordinates have more bits than that. While the differences
// are exact, a point near an edge may look as if it were on it, but not beyond,
// or with FMA on either side; where they round, anything.
// Worst known f32 inputs, A B C p (tests/worst_inputs.csv has f64 as well):
//   promoted_f64: none found
//   promoted_f64_fma: none found
//   promoted_f64_kahan: none found
// by `pitbench hunt`, whose coordinates are 2^-30 to 1, those of P at least
// 1/2; report/recipes.csv has inputs elsewhere.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/methods/promoted_f64.cc"
#include <hwy/foreach_target.h>

#include "kernels/rows-inl.h"
#include "kernels/triangle-inl.h"
#include "kernels/wide-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

struct PlainCross {
  template <class V>
  HWY_INLINE V operator()(V a, V b, V c, V d) const {
    return DifferenceOfProducts<false>(a, b, c, d);
  }
};
struct FmaCross {
  template <class V>
  HWY_INLINE V operator()(V a, V b, V c, V d) const {
    return DifferenceOfProducts<true>(a, b, c, d);
  }
};
struct KahanCross {
  template <class V>
  HWY_INLINE V operator()(V a, V b, V c, V d) const {
    return KahanDifference(a, b, c, d);
  }
};

// Cross: how a·b − c·d is computed.
template <class D, class Cross>
class PromotedF64 {
 public:
  HWY_INLINE PromotedF64(D d, const Triangles<D>& t)
      : vertices_(CounterClockwise(d, t, InHalves(d, AreaIs<kValid>{t}),
                                   InHalves(d, AreaIs<kClockwise>{t}))) {}

  template <class E>
  HWY_INLINE Mask<E> Inside(E e, Vec<E> x, Vec<E> y) const {
    const auto& v = vertices_;
    return InHalves(e, [&](auto half) HWY_ATTR {
      const auto px = half(x);
      const auto py = half(y);
      const auto xa = Sub(half(v.ax), px);
      const auto ya = Sub(half(v.ay), py);
      const auto xb = Sub(half(v.bx), px);
      const auto yb = Sub(half(v.by), py);
      const auto xc = Sub(half(v.cx), px);
      const auto yc = Sub(half(v.cy), py);
      const Cross cross;
      return AllNonNegative(Wide<E>(), cross(xb, yc, xc, yb),
                            cross(xc, ya, xa, yc), cross(xa, yb, xb, ya));
    });
  }

 private:
  enum Question { kValid, kClockwise };

  // Answered for one half of the lanes.
  template <Question kQuestion>
  struct AreaIs {
    const Triangles<D>& t;
    template <class Half>
    HWY_INLINE Mask<Wide<D>> operator()(Half half) const {
      const Wide<D> w;
      const auto ax = half(t.Ax());
      const auto ay = half(t.Ay());
      const auto ux = Sub(half(t.Bx()), ax);
      const auto uy = Sub(half(t.By()), ay);
      const auto vx = Sub(half(t.Cx()), ax);
      const auto vy = Sub(half(t.Cy()), ay);
      // Not contracted: see DoubleArea.
      const auto area =
          kKahan ? KahanCross()(ux, vy, uy, vx) : PlainCross()(ux, vy, uy, vx);
      return kQuestion == kValid ? IsValidArea(w, area) : Lt(area, Zero(w));
    }
  };
  static constexpr bool kKahan = std::is_same_v<Cross, KahanCross>;

  Vertices<D> vertices_;
};

template <class D>
using PromotedPlain = PromotedF64<D, PlainCross>;
template <class D>
using PromotedFma = PromotedF64<D, FmaCross>;
template <class D>
using PromotedKahan = PromotedF64<D, KahanCross>;

constexpr Method kPromotedF64{
    .key = "promoted_f64",
    .source = "common practice",
    .formula = "(v − P) × (w − P) ≥ 0 for each edge vw, in f64",
};
constexpr Method kPromotedF64Fma{
    .key = "promoted_f64_fma",
    .source = kPromotedF64.source,
    .formula = kPromotedF64.formula,
    .fma = true,
};
constexpr Method kPromotedF64Kahan{
    .key = "promoted_f64_kahan",
    .source = "common practice, with Kahan's difference of products",
    .formula = "(v − P) × (w − P) ≥ 0 for each edge vw, in f64, within 1.5 ulp",
    .fma = true,
};

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

PITBENCH_KERNELS(promoted_f64,
                 F32Rows<PromotedPlain>(kPromotedF64) +
                     F32FmaRows<PromotedFma>(kPromotedF64Fma) +
                     F32FmaRows<PromotedKahan>(kPromotedF64Kahan));
