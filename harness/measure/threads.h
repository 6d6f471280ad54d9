// Several CPUs at one call: how many, which, and who does what.
//
// Each thread is pinned to a CPU of its own and does its part of the items, so
// that together they read every byte of the scene once, as one thread would.
#ifndef PITBENCH_HARNESS_MEASURE_THREADS_H_
#define PITBENCH_HARNESS_MEASURE_THREADS_H_

#include <cstddef>
#include <vector>

#include "harness/scenes/scene.h"

namespace pitbench {

// 1, 2, 4, … and last the number of CPUs that this process was allowed when it
// began.
std::vector<int> ThreadCounts();

// Pins the calling thread: `index` 0 to the last of those CPUs, where
// PinToLastCpu pins the process, 1 to the last but one, and so on.
void PinThread(int index);

// The part of `call` of thread `index` of `count`, where the loop is
// one_triangle. Parts begin at whole cache lines of the points.
Call PartOf(const Call& call, std::size_t index, std::size_t count);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_THREADS_H_
