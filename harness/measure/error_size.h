// Errors summed up for a JSON file.
#ifndef PITBENCH_HARNESS_MEASURE_ERROR_SIZE_H_
#define PITBENCH_HARNESS_MEASURE_ERROR_SIZE_H_

#include <algorithm>
#include <cstddef>
#include <limits>

namespace pitbench {

// The largest and the mean of what is added.
class ErrorSize {
 public:
  void Add(double error) {
    largest_ = std::max(largest_, error);
    sum_ += error;
    ++count_;
  }
  // A number in JSON is finite.
  double largest() const { return std::min(largest_, kMost); }
  double mean() const {
    return count_ == 0 ? 0
                       : std::min(sum_, kMost) / static_cast<double>(count_);
  }

 private:
  static constexpr double kMost = std::numeric_limits<double>::max();
  double largest_ = 0;
  double sum_ = 0;
  std::size_t count_ = 0;
};

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_ERROR_SIZE_H_
