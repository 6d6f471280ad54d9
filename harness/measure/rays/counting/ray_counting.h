// The ray kernels once more, compiled to count their operations, as
// kernels/counting/counting.h has the 2D kernels.
#ifndef PITBENCH_HARNESS_MEASURE_RAYS_COUNTING_RAY_COUNTING_H_
#define PITBENCH_HARNESS_MEASURE_RAYS_COUNTING_RAY_COUNTING_H_

#include <span>

#include "kernels/counting/tape.h"
#include "kernels/rays/ray_kernels.h"

namespace pitbench {

// One for every method, scalar and loop that AVX-512 has, with isa kCounting,
// in the order of AllRayKernels(); but for the exact methods, which compute
// with numbers, and not with vectors, once a filter is undecided. Each call
// writes what it did on counting::CurrentTape().
std::span<const RayKernel> CountingRayKernels();

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_RAYS_COUNTING_RAY_COUNTING_H_
