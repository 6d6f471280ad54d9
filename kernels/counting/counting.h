// The kernels once more, compiled to count their operations.
#ifndef PITBENCH_KERNELS_COUNTING_COUNTING_H_
#define PITBENCH_KERNELS_COUNTING_COUNTING_H_

#include <span>

#include "kernels/counting/tape.h"
#include "kernels/kernels.h"
#include "kernels/rays/ray_kernels.h"

namespace pitbench {

// One for every method, scalar and loop that AVX-512 has, with isa kCounting;
// in the order of AllKernels(), in which none of them is. They keep the
// contract but for allocation and speed: each call writes what it did on
// counting::CurrentTape().
std::span<const Kernel> CountingKernels();

// The same of AllRayKernels(). Not noted is what an exact method does with
// integers for a ray that its filters leave.
std::span<const RayKernel> CountingRayKernels();

}  // namespace pitbench

#endif  // PITBENCH_KERNELS_COUNTING_COUNTING_H_
