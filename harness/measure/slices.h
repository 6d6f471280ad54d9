// How long calls take when nothing disturbs them.
//
// Whatever disturbs a computer (another process, a neighbour on the same core,
// the hypervisor) makes a call slower, nothing makes it faster. The mean over
// some milliseconds, which is what a loop around a kernel gives, holds all of
// it, and no median of nine such means gets rid of what strikes most of them.
// On a shared machine where 3 ms on end were never undisturbed, of the
// stretches of 100 µs one in six was, and at bad times one in fifty. So:
//   - calls are timed in slices of about that length, between two looks at
//     whether it is quiet (quiet.h). Where it is not, the slice waits, and is
//     run again; for as long as its share of the patience lasts. The looks are
//     at other work, so they prefer no row to another;
//   - of several passes over the same calls, those run again among them, the
//     fastest counts;
//   - the slices of all repetitions of all rows are run in random order, so
//     that times that were bad for long are bad for all of them;
//   - "the same calls" are the same: where some calls take longer than others,
//     the fastest of different ones would be the luckiest. Of a round too long
//     for all passes, each repetition takes other calls, so the spread of the
//     repetitions holds that of the input too;
//   - before each slice the calls ahead of it run untimed, since others had the
//     caches and predictors meanwhile.
// What is left out is kept: the mean over all passes tells how disturbed the
// machine was. A call that is much longer than a slice is timed in parts
// (parts.h), and so is the memory that bounds it. Precision, on that machine:
// most medians are known to 1 or 2 %.
#ifndef PITBENCH_HARNESS_MEASURE_SLICES_H_
#define PITBENCH_HARNESS_MEASURE_SLICES_H_

#include <cstddef>
#include <functional>
#include <vector>

#include "harness/measure/quiet.h"

namespace pitbench {

inline constexpr double kSliceSeconds = 1e-4;

// Whatever does `count` calls, from the call `first` of a round on and round
// again, and returns the seconds they took.
using CallTimer = std::function<double(std::size_t first, std::size_t count)>;

// The seconds of each part of one call, always as many.
using PartsTimer =
    std::function<void(std::size_t call, std::vector<double>& seconds)>;

struct TimedCalls {
  std::size_t round;  // how many different calls there are
  CallTimer time;
  PartsTimer time_parts = nullptr;  // of calls that are timed so
};

// The calls that one repetition times: `window` on end, cut into `pieces` of
// about a slice, each of them `passes` times, each time behind `warm_up` calls
// that are not timed.
struct SlicePlan {
  std::size_t window;
  std::size_t pieces;
  std::size_t passes;
  std::size_t warm_up;
};

// For calls of `call_seconds`, `round` of them, so that a repetition times
// about `seconds`; one call at the least. Whole rounds where a round fits.
SlicePlan PlanSlices(double call_seconds, std::size_t round, double seconds);

struct Repetition {
  double call_seconds;       // of the fastest passes
  double mean_call_seconds;  // of all passes
  std::size_t calls;         // timed, in all passes
};

// What TimeInSlices wants to know of the machine.
struct Surroundings {
  // How quiet it is now. Takes much less than a slice.
  std::function<Quiet()> look;
  // Called some hundred times, evenly spread, with the part that is done by
  // then, in [0, 1).
  std::function<void(double done)> between;
};

struct SliceTimes {
  std::vector<std::vector<Repetition>> rows;  // by row, then repetition
  double quiet_share;  // of the slices: timed where both looks were no worse
                       // than Quiet::kSlower
};

struct SliceBudget {
  // Of a repetition of a row, warm-up aside; eight times that where calls are
  // timed in parts.
  double seconds;
  // How many times as long that may take where the machine is not quiet; half
  // of it may be spent on waiting for a faster clock alone.
  double patience = 3;
};

// Times each row `repetitions` times, all of them together.
SliceTimes TimeInSlices(const std::vector<TimedCalls>& rows,
                        const SliceBudget& budget, int repetitions,
                        const Surroundings& surroundings);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_SLICES_H_
