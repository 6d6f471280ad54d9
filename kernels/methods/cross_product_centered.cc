// Point in triangle by three cross products of the vertices relative to the
// point: Shewchuk's orient2d (1997) before he makes it adaptive.
//
//   (v − P) × (w − P) ≥ 0 for each edge vw, counter-clockwise
//
// Set-up: B and C exchanged where one triangle is clockwise, or any with FMA or
// for top-left; of others the three signs are turned with the answer. Per
// point: 9 subtractions, 6 multiplications, 3 compares; with FMA 6
// subtractions, 3 multiplications, 3 multiply-subtracts.
// Boundary: closed, or top-left: each edge is compared with 0 or with the
// smallest number above it. Winding: fixed by the set-up. Degenerate: contains
// nothing.
// Fails: differences from P round, so near an edge the sign may be wrong; but
// two neighbours compute the same magnitudes with opposite signs, so closed
// neighbours leave no hole and top-left ones share no point. With FMA they
// round different products, and both is lost.
// Worst known f32 inputs, A B C p (tests/worst_inputs.csv has f64 as well):
//   cross_product_centered, said inside, is 4.62e+07 ulps outside:
//     (0x1.ea0d58p-1, -0x1.e1ad7p-1) (0x1.ea0d5p-1, -0x1.e1ad68p-1)
//     (0x1.ea0d5p-1, -0x1.e1ad66p-1) (-0x1.fffp-1, 0x1.ff8p-1)
//   cross_product_centered_top_left, said inside, is 3.85e+07 ulps outside:
//     (0x1.5b7746p-1, -0x1.30d9a6p-1) (0x1.5b7748p-1, -0x1.30d9a8p-1)
//     (0x1.5b7748p-1, -0x1.30d9a4p-1) (-0x1.f5cb5cp-1, 0x1.fa5b3cp-1)
//   cross_product_centered_fma, said inside, is 3.46e+07 ulps outside:
//     (0x1.0df9dp-1, -0x1.86ca6p-2) (0x1.0df9d4p-1, -0x1.86ca68p-2)
//     (0x1.0df9dp-1, -0x1.86ca64p-2) (-0x1.fff7fcp-1, 0x1.ffffd8p-1)
//   cross_product_centered_top_left_fma, said inside, is 3.77e+07 ulps outside:
//     (-0x1.debffp-2, 0x1.6a899cp-1) (-0x1.debff8p-2, 0x1.6a899ap-1)
//     (-0x1.debff4p-2, 0x1.6a899cp-1) (0x1.ffa81ep-1, -0x1.fee554p-1)

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/methods/cross_product_centered.cc"
#include <hwy/foreach_target.h>

#include "kernels/rows-inl.h"
#include "kernels/triangle-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

template <class D, bool kFma, Boundary kBoundary>
class CrossProductCentered {
 public:
  HWY_INLINE CrossProductCentered(D d, const Triangles<D>& t)
      : CrossProductCentered(d, t, DoubleArea(t)) {}

  // An infinite coordinate of P makes one of the three NaN, or two of them
  // infinite with opposite signs: outside, as it has to be.
  template <class E>
  HWY_INLINE Mask<E> Inside(E e, Vec<E> x, Vec<E> y) const {
    auto on_bc = x;
    auto on_ca = x;
    auto on_ab = x;
    CrossFromPoint<kFma>(vertices_, e, x, y, on_bc, on_ca, on_ab);
    if constexpr (kTurnsLater) {
      const auto area = area_.In(e);
      return AllNonNegativeOfValid(e, TurnedBy(e, on_bc, area),
                                   TurnedBy(e, on_ca, area),
                                   TurnedBy(e, on_ab, area), area);
    } else if constexpr (kBoundary == Boundary::kClosed) {
      return AllNonNegative(e, on_bc, on_ca, on_ab);
    } else {
      return AllAtLeast(on_bc, least_bc_.In(e), on_ca, least_ca_.In(e), on_ab,
                        least_ab_.In(e));
    }
  }

 private:
  // Triangles for one answer each are not turned: the signs of the three are,
  // and whether the triangle is valid is asked with the answer. Contracted, it
  // is not the same which of two products is rounded.
  static constexpr bool kTurnsLater = !std::is_same_v<D, OneLane<TFromD<D>>> &&
                                      !kFma && kBoundary == Boundary::kClosed;

  HWY_INLINE CrossProductCentered(D d, const Triangles<D>& t, Vec<D> area)
      : CrossProductCentered(
            d, kTurnsLater ? AsTheyAre(d, t) : CounterClockwise(d, t, area),
            area) {}

  HWY_INLINE CrossProductCentered(D d, const Vertices<D>& v, Vec<D> area)
      : vertices_(v),
        area_(d, area),
        least_bc_(Of(d, v.bx, v.by, v.cx, v.cy)),
        least_ca_(Of(d, v.cx, v.cy, v.ax, v.ay)),
        least_ab_(Of(d, v.ax, v.ay, v.bx, v.by)) {}

  static HWY_INLINE Least<D, kBoundary> Of(D d, const Held<D>& from_x,
                                           const Held<D>& from_y,
                                           const Held<D>& to_x,
                                           const Held<D>& to_y) {
    return {d, Sub(to_x.In(d), from_x.In(d)), Sub(to_y.In(d), from_y.In(d))};
  }

  template <class E>
  static HWY_INLINE Mask<E> AllNonNegativeOfValid(E e, Vec<E> u, Vec<E> v,
                                                  Vec<E> w, Vec<E> area) {
    if constexpr (kHasClasses<E>) {
      return AllNonNegative(e, u, v, ValidOrNaN(e, area, w));
    } else {
      return And(AllNonNegative(e, u, v, NaNUnlessFinite(e, w, area)),
                 hn::Ne(area, Zero(e)));
    }
  }

  Vertices<D> vertices_;
  Held<D> area_;
  [[no_unique_address]] Least<D, kBoundary> least_bc_;
  [[no_unique_address]] Least<D, kBoundary> least_ca_;
  [[no_unique_address]] Least<D, kBoundary> least_ab_;
};

template <class D>
using Closed = CrossProductCentered<D, false, Boundary::kClosed>;
template <class D>
using ClosedFma = CrossProductCentered<D, true, Boundary::kClosed>;
template <class D>
using TopLeft = CrossProductCentered<D, false, Boundary::kTopLeft>;
template <class D>
using TopLeftFma = CrossProductCentered<D, true, Boundary::kTopLeft>;

constexpr Method kClosed{
    .key = "cross_product_centered",
    .source = "Shewchuk 1997, orient2d without adaptivity",
    .formula = "(v − P) × (w − P) ≥ 0 for each edge vw",
};
constexpr Method kClosedFma{
    .key = "cross_product_centered_fma",
    .source = kClosed.source,
    .formula = kClosed.formula,
    .fma = true,
};
constexpr Method kTopLeft{
    .key = "cross_product_centered_top_left",
    .source = "Shewchuk 1997, with the rasterisers' rule",
    .formula =
        "(v − P) × (w − P) ≥ 0 for each top or left edge vw, > 0 for the "
        "others",
    .boundary = Boundary::kTopLeft,
};

constexpr Method kTopLeftFma{
    .key = "cross_product_centered_top_left_fma",
    .source = kTopLeft.source,
    .formula = kTopLeft.formula,
    .boundary = Boundary::kTopLeft,
    .fma = true,
};

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

PITBENCH_KERNELS(cross_product_centered, FloatRows<Closed>(kClosed) +
                                             FmaRows<ClosedFma>(kClosedFma) +
                                             FloatRows<TopLeft>(kTopLeft) +
                                             FmaRows<TopLeftFma>(kTopLeftFma));
