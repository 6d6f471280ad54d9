// BoundaryDistanceInUlps in a few nanoseconds, to choose by which answers are
// worth the exact one.
#ifndef PITBENCH_HARNESS_MEASURE_DISTANCE_ESTIMATE_H_
#define PITBENCH_HARNESS_MEASURE_DISTANCE_ESTIMATE_H_

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <type_traits>

#include "harness/truth/truth.h"

namespace pitbench {

// The square of the distance from (px, py) to the segment from (ax, ay) to
// (bx, by).
template <class Wide>
Wide SquareFromSegment(Wide ax, Wide ay, Wide bx, Wide by, Wide px, Wide py) {
  const Wide ex = bx - ax;
  const Wide ey = by - ay;
  const Wide dx = px - ax;
  const Wide dy = py - ay;
  const Wide along = ex * dx + ey * dy;
  const Wide length = ex * ex + ey * ey;
  if (along <= 0) return dx * dx + dy * dy;
  if (along >= length) {
    return (px - bx) * (px - bx) + (py - by) * (py - by);
  }
  const Wide cross = ex * dy - ey * dx;
  return cross * cross / length;
}

// About the distance from p to the triangle's boundary in ulps of p's larger
// coordinate. Computed with at least 11 bits more than T has and a range in
// which nothing overflows, so it errs by some 2^-10 ulps of the largest
// coordinate. 0 where a coordinate is NaN or infinite.
template <class T>
double DistanceEstimate(const Triangle<T>& t, const Point<T>& p) {
  using Wide =
      std::conditional_t<std::is_same_v<T, double>, long double, double>;
  if (!IsFinite(t, p)) return 0;
  const auto from = [&p](const Point<T>& v, const Point<T>& w) {
    return SquareFromSegment<Wide>(
        static_cast<Wide>(v.x), static_cast<Wide>(v.y), static_cast<Wide>(w.x),
        static_cast<Wide>(w.y), static_cast<Wide>(p.x), static_cast<Wide>(p.y));
  };
  const Wide square =
      std::min({from(t.a, t.b), from(t.b, t.c), from(t.c, t.a)});
  int ulp_exponent = 0;
  if constexpr (std::floating_point<T>) {
    using Limits = std::numeric_limits<T>;
    const T largest = std::max(std::abs(p.x), std::abs(p.y));
    const int smallest = Limits::min_exponent - 1;
    const int log2 = largest == 0 ? smallest : std::ilogb(largest);
    ulp_exponent = std::max(log2, smallest) - (Limits::digits - 1);
  }
  return static_cast<double>(std::ldexp(std::sqrt(square), -ulp_exponent));
}

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_DISTANCE_ESTIMATE_H_
