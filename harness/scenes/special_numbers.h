// Special numbers for scenes of points and of rays.
#ifndef PITBENCH_HARNESS_SCENES_SPECIAL_NUMBERS_H_
#define PITBENCH_HARNESS_SCENES_SPECIAL_NUMBERS_H_

#include <cstdint>
#include <limits>

#include "harness/scenes/random.h"

namespace pitbench {

template <class T>
T EitherSign(Random& random, T x) {
  return random.Below(2) == 0 ? x : -x;
}

// NaN, or infinity of either sign.
template <class T>
T NotFinite(Random& random, bool nan) {
  if (nan) return std::numeric_limits<T>::quiet_NaN();
  return EitherSign(random, std::numeric_limits<T>::infinity());
}

// Eighths from −1 to 1, half of them zeros of either sign.
template <class T>
T EighthOrZero(Random& random) {
  const std::uint64_t eighths = random.Below(2) == 0 ? 0 : random.Below(9);
  return EitherSign(random, static_cast<T>(eighths) / 8);
}

// From −32 to 32 smallest numbers.
template <class T>
T SmallestNumbers(Random& random) {
  return (static_cast<T>(random.Below(65)) - 32) *
         std::numeric_limits<T>::denorm_min();
}

// A third at the limit itself, a third anywhere below it, a third of size 1.
template <class T>
T UpToLargest(Random& random) {
  constexpr T kLargest = std::numeric_limits<T>::max();
  const T unit = static_cast<T>(random.Unit());
  switch (random.Below(3)) {
    case 0:
      return EitherSign(random, kLargest);
    case 1:
      return EitherSign(random, unit * kLargest);
    default:
      return EitherSign(random, unit);
  }
}

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_SCENES_SPECIAL_NUMBERS_H_
