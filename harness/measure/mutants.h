// Random changes of an input that a hunt (climb.h) tries, of points in the
// plane as of rays in space; and what every hunt confines its inputs to.
#ifndef PITBENCH_HARNESS_MEASURE_MUTANTS_H_
#define PITBENCH_HARNESS_MEASURE_MUTANTS_H_

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "harness/scenes/random.h"
#include "harness/scenes/step.h"

namespace pitbench {

inline constexpr double kLeastMagnitude = 0x1p-30;

// Whether every coordinate is 0 or has a magnitude from kLeastMagnitude to 1.
template <class T, std::size_t kCount>
bool AreConfined(const std::array<T, kCount>& c) {
  for (const T x : c) {
    const double magnitude = std::abs(static_cast<double>(x));
    if (!(magnitude <= 1)) return false;
    if (magnitude != 0 && magnitude < kLeastMagnitude) return false;
  }
  return true;
}

// 2^0 to 2^(digits − 1), either sign.
template <class T>
std::int64_t AnyUlps(Random& random) {
  const auto shift = random.Below(std::numeric_limits<T>::digits);
  const auto ulps = std::int64_t{1} << shift;
  return random.Below(2) == 0 ? ulps : -ulps;
}

// 2^0 down to 2^(1 − digits).
template <class T>
double AnyLength(Random& random) {
  return std::ldexp(
      1.0, -static_cast<int>(random.Below(std::numeric_limits<T>::digits)));
}

// `steps` numbers away, but not to what is not finite.
template <class T>
T Moved(T x, std::int64_t steps) {
  const T moved = Step(x, steps);
  return std::isfinite(moved) ? moved : x;
}

// c with one to three coordinates changed, mostly by a power of two of ulps.
// Coordinates k, k + kDimensions, … are along one axis.
template <std::size_t kDimensions, class T, std::size_t kCount>
std::array<T, kCount> MutantOf(std::array<T, kCount> c, Random& random) {
  const std::uint64_t changes = 1 + random.Below(3);
  for (std::uint64_t k = 0; k < changes; ++k) {
    const std::size_t at = random.Below(kCount);
    T& x = c[at];
    switch (random.Below(8)) {
      case 0: {  // by a length, whatever the ulp
        const double sign = random.Below(2) == 0 ? 1 : -1;
        x = static_cast<T>(static_cast<double>(x) +
                           sign * AnyLength<T>(random));
        break;
      }
      case 1:  // to one like another point's
        x = c[(at +
               kDimensions * (1 + random.Below(kCount / kDimensions - 1))) %
              kCount];
        break;
      default:
        x = Moved(x, AnyUlps<T>(random));
    }
  }
  return c;
}

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_MUTANTS_H_
