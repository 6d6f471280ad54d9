// How much of its CPU a measurement had.
//
// A neighbour on the same core is seen neither by a clock probe, which may well
// run in a slice of its own, nor by the steal time, which only tells what other
// virtual machines took. The scheduler knows: a process that never waits, as
// one that measures, uses all of the time that passes, and what is missing went
// to others.
#ifndef PITBENCH_HARNESS_MEASURE_OCCUPANCY_H_
#define PITBENCH_HARNESS_MEASURE_OCCUPANCY_H_

#include <chrono>

namespace pitbench {

struct Occupancy {
  double wall_seconds = 0;
  double cpu_seconds = 0;  // of all threads of the process
  long preemptions = 0;    // how often the CPU was taken from it
};

// Counts from its construction on.
class OccupancyMeter {
 public:
  OccupancyMeter();
  Occupancy Read() const;

 private:
  std::chrono::steady_clock::time_point start_;
  double cpu_seconds_;
  long preemptions_;
};

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_OCCUPANCY_H_
