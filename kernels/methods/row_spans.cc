// Triangle on a grid by row spans: of each row only where it begins and ends.
//
//   from ⌈x of its left edge⌉ to ⌊x of its right edge⌋ in each row
//
// row_spans sets up one triangle after the other, row_spans_batched as many as
// the ISA has lanes of 32 bits; the rows of a triangle are lanes of 16 bits in
// both. Why the integer arithmetic is exact, and where it holds, is proved in
// kernels/loops/row_spans-inl.h.
// Set-up: vertices sorted by row, 2 multiplications for the winding, 3 edges of
// 4 multiplications and a look-up. Per row: 2 divisions, each as a
// multiplication, an addition and a multiplication by the reciprocal. Per
// pixel: its bit.
// Boundary: closed. Winding: does not matter. Degenerate: contains nothing.
// Range: vertices in the grid, and grids of up to 128 × 64 pixels. Whatever is
// beyond is answered by stepped edge functions: right, but slower.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/methods/row_spans.cc"
#include <hwy/foreach_target.h>

#include "kernels/loops/span_bits-inl.h"
#include "kernels/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

constexpr Method kRowSpans{
    .key = "row_spans",
    .source = "rasterisers' scan lines",
    .formula = "⌈x of the left edge⌉ ≤ x ≤ ⌊x of the right edge⌋ in each row",
};
constexpr Method kRowSpansBatched{
    .key = "row_spans_batched",
    .source = "rasterisers' scan lines, many triangles set up at once",
    .formula = kRowSpans.formula,
};

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

PITBENCH_KERNELS(row_spans,
                 GridFunctionRow(kRowSpans, RowSpans<false>) +
                     GridFunctionRow(kRowSpansBatched, RowSpans<true>));
