// Moving by representable numbers: to a point's neighbours, and off an edge.
#ifndef PITBENCH_HARNESS_SCENES_STEP_H_
#define PITBENCH_HARNESS_SCENES_STEP_H_

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "harness/truth/truth.h"

namespace pitbench {

// The number that is `steps` representable numbers above x (below for negative
// steps). x must be finite; where the result would not be, it is any number or
// none. −0 and +0 are one number.
template <class T>
T Step(T x, std::int64_t steps) {
  using Ordered =
      std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>;
  constexpr Ordered kLow = std::numeric_limits<Ordered>::min();
  // Bits of negative numbers count downwards: map both signs on one scale.
  Ordered ordered = std::bit_cast<Ordered>(x);
  if (ordered < 0) ordered = static_cast<Ordered>(kLow - ordered);
  using Unsigned = std::make_unsigned_t<Ordered>;  // wraps
  ordered = static_cast<Ordered>(static_cast<Unsigned>(ordered) +
                                 static_cast<Unsigned>(steps));
  if (ordered < 0) ordered = static_cast<Ordered>(kLow - ordered);
  return std::bit_cast<T>(ordered);
}

// The point at v + s·(w − v), rounded to T, and then moved by `steps`
// representable numbers along the axis that is more across vw.
template <class T>
Point<T> BesideEdge(const Point<T>& v, const Point<T>& w, double s,
                    std::int64_t steps) {
  const double ex = static_cast<double>(w.x) - static_cast<double>(v.x);
  const double ey = static_cast<double>(w.y) - static_cast<double>(v.y);
  Point<T> p{static_cast<T>(static_cast<double>(v.x) + s * ex),
             static_cast<T>(static_cast<double>(v.y) + s * ey)};
  T& across = std::abs(ex) > std::abs(ey) ? p.y : p.x;
  across = Step(across, steps);
  return p;
}

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_SCENES_STEP_H_
