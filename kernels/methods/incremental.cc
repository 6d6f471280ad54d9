// Triangle on a grid by edge functions that are stepped, not evaluated.
//
//   e_k(x + 1, y) = e_k(x, y) + A_k,  e_k(x, y + 1) = e_k(x, y) + B_k
//
// grid_incremental visits every pixel, grid_clipped those of the triangle's
// bounding box. Lanes are columns, of 16 bits where that is exact.
// Set-up: 3 edges, 6 multiplications. Per pixel: 3 additions, 1 compare.
// Boundary: closed. Winding: fixed by the set-up. Degenerate: contains nothing.
// Range: 16 bits while grid and vertices lie in a window of 2^7 × 2^7, 32 bits
// in one of 2^15 × 2^15, exact arithmetic beyond.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/methods/incremental.cc"
#include <hwy/foreach_target.h>

#include "kernels/loops/incremental-inl.h"
#include "kernels/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

constexpr Method kIncremental{
    .key = "grid_incremental",
    .source = "Pineda 1988, stepped",
    .formula = "e + A ≥ 0 for each edge, from column to column",
};
constexpr Method kClipped{
    .key = "grid_clipped",
    .source = "Pineda 1988, stepped within the bounding box",
    .formula = kIncremental.formula,
};

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

PITBENCH_KERNELS(incremental,
                 GridFunctionRow(kIncremental, IncrementalGrid<false>) +
                     GridFunctionRow(kClipped, IncrementalGrid<true>));
