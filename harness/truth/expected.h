// What a method should say of a point, by exact arithmetic and what it
// declares of itself.
#ifndef PITBENCH_HARNESS_TRUTH_EXPECTED_H_
#define PITBENCH_HARNESS_TRUTH_EXPECTED_H_

#include <algorithm>
#include <array>
#include <utility>

#include "harness/truth/orientation.h"
#include "harness/truth/truth.h"
#include "harness/truth/weights.h"
#include "kernels/kernels.h"

namespace pitbench {

// Whether a point of the boundary of a triangle with area counts as inside.
template <class T>
bool BoundaryCounts(Boundary rule, const Triangle<T>& t, const Point<T>& p) {
  switch (rule) {
    case Boundary::kClosed:
      return true;
    case Boundary::kOpen:
      return false;
    case Boundary::kHalfOpen:
      return Orientation(t.b, t.c, p) != 0;
    case Boundary::kTopLeft:
    case Boundary::kBottomLeft:
    case Boundary::kPerturbed:  // no rule of 2D
      break;
  }
  // Counter-clockwise with y upwards, left edges go down, top edges left and
  // bottom edges right.
  std::array<Point<T>, 3> v = {t.a, t.b, t.c};
  if (Orientation(t.a, t.b, t.c) < 0) std::swap(v[1], v[2]);
  for (std::size_t k = 0; k < 3; ++k) {
    const Point<T>& from = v[k];
    const Point<T>& to = v[(k + 1) % 3];
    const bool counts =
        to.y < from.y ||
        (to.y == from.y && (to.x < from.x) == (rule == Boundary::kTopLeft));
    if (Orientation(from, to, p) == 0 && !counts) return false;
  }
  return true;
}

template <class T>
bool Expected(const Method& method, const Triangle<T>& t, const Point<T>& p) {
  const Position position = Classify(t, p);
  if (position != Position::kInside && position != Position::kBoundary) {
    return false;
  }
  if (position == Position::kBoundary &&
      !BoundaryCounts(method.boundary, t, p)) {
    return false;
  }
  if (method.accepts == Accepts::kTriangle) return true;
  const std::array<mpq_class, 3> w = ExactWeights(t, p);
  return w[0] >= w[1] && w[0] >= w[2];
}

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_TRUTH_EXPECTED_H_
