// How fast the clock runs, and how much of the time was ours.
//
// A chain of dependent additions takes one cycle each on every CPU that
// pitbench knows, so its pace is the clock's. It does not see a busy neighbour
// that takes execution ports but not the clock; the throughput of independent
// operations does, and so do the A/A pair of each shard and the steal time.
#ifndef PITBENCH_HARNESS_MEASURE_CLOCK_H_
#define PITBENCH_HARNESS_MEASURE_CLOCK_H_

namespace pitbench {

struct Pace {
  double clock_ghz = 0;
  // Operations per nanosecond of a loop of independent ones that keeps the
  // ports for integers and for floating-point numbers full at once. What
  // matters is that it stays the same.
  double throughput_gops = 0;
};

// The pace of the core that this runs on, in samples of 32 µs or so each of
// clock and throughput, and of a fourteenth of that.
Pace SamplePace();
Pace GlancePace();

// Of each the greater.
Pace Best(const Pace& a, const Pace& b);

// In the best of samples of some 50 ms, as the times of kernels are (slices.h).
Pace MeasurePace();

// Seconds, summed over all CPUs since boot, that a hypervisor gave to others
// (the steal column of /proc/stat); 0 where that is not told.
double StealSeconds();

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_CLOCK_H_
