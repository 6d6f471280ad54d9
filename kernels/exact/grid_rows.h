// The exact answer for a triangle of a grid, whatever its coordinates.
#ifndef PITBENCH_KERNELS_EXACT_GRID_ROWS_H_
#define PITBENCH_KERNELS_EXACT_GRID_ROWS_H_

#include <cstddef>
#include <cstdint>

#include "kernels/kernels.h"

namespace pitbench {

// Writes the rows of triangle `t` of a batch of loop grid, closed and as
// Result::bits has them, to `rows`: height · BitBytes(width) bytes. Slow; for
// triangles whose coordinates are beyond what a kernel computes with.
void WriteGridRowsExactly(const Batch<std::int32_t>& batch, std::size_t t,
                          std::uint8_t* rows);

}  // namespace pitbench

#endif  // PITBENCH_KERNELS_EXACT_GRID_ROWS_H_
