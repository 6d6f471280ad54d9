// Intervals for what is counted.
#ifndef PITBENCH_HARNESS_MEASURE_STATISTICS_H_
#define PITBENCH_HARNESS_MEASURE_STATISTICS_H_

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pitbench {

struct Interval {
  double low;
  double high;
};

// The 95 % interval of a rate of which `count` out of `of` were seen (Wilson
// 1927, without continuity correction). All of [0, 1] where `of` is 0.
inline Interval Wilson95(std::size_t count, std::size_t of) {
  if (of == 0) return {0, 1};
  constexpr double kZ = 1.959963984540054;  // the normal 97.5 % quantile
  const double n = static_cast<double>(of);
  const double rate = static_cast<double>(count) / n;
  const double scale = 1 + kZ * kZ / n;
  const double centre = (rate + kZ * kZ / (2 * n)) / scale;
  const double half =
      kZ * std::sqrt(rate * (1 - rate) / n + kZ * kZ / (4 * n * n)) / scale;
  // At the ends the bound is exactly 0 or 1; rounding would miss it.
  return {count == 0 ? 0 : std::max(0.0, centre - half),
          count == of ? 1 : std::min(1.0, centre + half)};
}

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_STATISTICS_H_
