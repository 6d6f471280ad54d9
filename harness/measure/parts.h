// What is much longer than a slice (slices.h) is timed in parts, one behind the
// other, and of each part the fastest pass counts: no pass over all of it is
// undisturbed from beginning to end.
//
// The sum of the parts is then less than any pass took. So whatever is held
// against such a time, the bandwidth of memory above all, has to be taken in
// the same way: from parts no longer, and at least as many passes.
#ifndef PITBENCH_HARNESS_MEASURE_PARTS_H_
#define PITBENCH_HARNESS_MEASURE_PARTS_H_

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace pitbench {

// What reads so much takes milliseconds.
inline constexpr double kBytesOfLongCall = 0x1p24;
// How many items a part of a call has. Of points in f32 it reads 512 KiB, and
// of all else more.
inline constexpr std::size_t kItemsOfPart = std::size_t{1} << 16;
inline constexpr std::size_t kBytesOfShortestPart =
    2 * sizeof(float) * kItemsOfPart;

// Of calls long and short.
inline constexpr double kMostPasses = 8;

// Long calls read from memory that all cores share, where two passes are rarely
// alike. So there are as many passes as of other calls, unless a repetition
// would take that many times as long as theirs.
inline std::size_t PassesOfParts(double call_seconds, double seconds) {
  const double passes =
      std::min(kMostPasses, kMostPasses * seconds / call_seconds);
  return static_cast<std::size_t>(std::max(std::floor(passes), 1.0));
}

// The passes over one call, each of as many parts.
class PartTimes {
 public:
  void AddPass(const std::vector<double>& seconds) {
    fastest_.resize(seconds.size(), std::numeric_limits<double>::infinity());
    for (std::size_t k = 0; k < seconds.size(); ++k) {
      fastest_[k] = std::min(fastest_[k], seconds[k]);
      sum_ += seconds[k];
    }
    ++passes_;
  }

  // Seconds of the call by the fastest pass over each part.
  double Fastest() const {
    double sum = 0;
    for (const double part : fastest_) sum += part;
    return sum;
  }
  double Sum() const { return sum_; }  // of all passes
  std::size_t Passes() const { return passes_; }

 private:
  std::vector<double> fastest_;
  double sum_ = 0;
  std::size_t passes_ = 0;
};

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_PARTS_H_
