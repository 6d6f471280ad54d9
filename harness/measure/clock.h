// How fast the clock runs, and how much of the time was ours.
//
// A chain of dependent additions takes one cycle each on every CPU that
// pitbench knows, so its pace is the clock's. It does not see a busy neighbour
// that takes execution ports but not the clock; the throughput of independent
// operations does, and so do the A/A pair of each shard and the steal time.
#ifndef PITBENCH_HARNESS_MEASURE_CLOCK_H_
#define PITBENCH_HARNESS_MEASURE_CLOCK_H_

namespace pitbench {

// The clock of the core this runs on, in GHz: the median of 15 samples of
// about half a millisecond.
double ClockGhz();

// Operations per nanosecond of a loop of independent ones that keeps the ports
// for integers and for floating-point numbers full at once: the median of 15
// samples of about half a millisecond. What matters is that it stays the same.
double ThroughputGops();

// Seconds, summed over all CPUs since boot, that a hypervisor gave to others
// (the steal column of /proc/stat); 0 where that is not told.
double StealSeconds();

// The CPU that this process is pinned to from here on: the last one that it is
// allowed to use, since the first serves most interrupts. −1 if it could not
// be pinned.
int PinToLastCpu();

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_CLOCK_H_
