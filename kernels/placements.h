// Kernels compiled again with their code elsewhere, and nothing else changed.
//
// Where code lies against cache lines and branch buffers changes its time, by
// a third at worst, without any difference between the instructions. So the
// kernels of AllKernels() start on a cache line, and so do their loops; these
// copies of a few of them start `shift` bytes past one, and their loops are
// where that puts them. What a copy's time differs by is what chance decides
// in a program that does not align, and a difference between two methods that
// is smaller may be no more than that.
#ifndef PITBENCH_KERNELS_PLACEMENTS_H_
#define PITBENCH_KERNELS_PLACEMENTS_H_

#include <cstddef>
#include <span>

#include "kernels/kernels.h"

namespace pitbench {

// What functions and loops of AllKernels() are aligned to, in bytes.
inline constexpr std::size_t kAlignment = 64;

struct Placement {
  std::size_t shift;  // the kernel starts so many bytes past a cache line
  Kernel kernel;      // declares what the one in AllKernels() does
};

// Ordered by shift. Loop one_triangle and f32, on the ISAs whose loops are the
// shortest, so that it matters most where they lie; not all of them run here.
// None where the build has fewer kernels (PITBENCH_FEWER_KERNELS).
std::span<const Placement> Placements();

}  // namespace pitbench

#endif  // PITBENCH_KERNELS_PLACEMENTS_H_
