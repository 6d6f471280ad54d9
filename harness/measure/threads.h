// Several CPUs at one call: how many, which, and who does what.
//
// Each thread is pinned to a CPU of its own and does its part of the items, so
// that together they read every byte of the scene once, as one thread would.
#ifndef PITBENCH_HARNESS_MEASURE_THREADS_H_
#define PITBENCH_HARNESS_MEASURE_THREADS_H_

#include <cstddef>
#include <functional>
#include <vector>

#include "harness/scenes/scene.h"

namespace pitbench {

// 1, 2, 4, … and last the number of CPUs that this process was allowed when it
// began.
std::vector<int> ThreadCounts();

// The CPU that this process is pinned to from here on: the last one that it is
// allowed to use, since the first serves most interrupts. −1 if it could not
// be pinned.
int PinToLastCpu();

// Whether it is one of those CPUs.
bool MayUse(int cpu);

// Pins the calling thread to a CPU; whether that could be done.
bool Pin(int cpu);

// Does work(0) here and work(1), work(2), … each in a thread of its own, all at
// once: 0 on the last of those CPUs, where PinToLastCpu pins the process, 1 on
// the last but one, and so on. Returns the seconds from the first start to the
// last end. Starting the threads is no part of them.
double SecondsOfThreads(std::size_t threads,
                        const std::function<void(std::size_t)>& work);

// The part `index` of `count` of a call of any loop but grid. Parts begin at
// whole cache lines of the arrays.
Call PartOf(const Call& call, Loop loop, std::size_t index, std::size_t count);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_THREADS_H_
