#include "harness/truth/truth.h"

#include <gmpxx.h>

#include <cmath>
#include <concepts>
#include <cstdint>
#include <string_view>

#include "harness/truth/orientation.h"

namespace pitbench {
namespace {

template <class T>
bool IsFinitePoint(const Point<T>& p) {
  if constexpr (std::floating_point<T>) {
    return std::isfinite(p.x) && std::isfinite(p.y);
  } else {
    return true;
  }
}

// Classify with orient2d given as `orientation`.
template <class T, class F>
Position ClassifyBy(F orientation, const Triangle<T>& triangle,
                    const Point<T>& p) {
  if (!IsFinite(triangle, p)) return Position::kOutside;
  const auto& [a, b, c] = triangle;
  const int winding = orientation(a, b, c);
  if (winding == 0) return Position::kDegenerate;
  // Inside lies on the winding's side of all three edges; a point on the line
  // of an edge and on the wrong side of none is on that edge.
  const int ab = winding * orientation(a, b, p);
  if (ab < 0) return Position::kOutside;
  const int bc = winding * orientation(b, c, p);
  if (bc < 0) return Position::kOutside;
  const int ca = winding * orientation(c, a, p);
  if (ca < 0) return Position::kOutside;
  return ab == 0 || bc == 0 || ca == 0 ? Position::kBoundary
                                       : Position::kInside;
}

}  // namespace

std::string_view Name(Position position) {
  switch (position) {
    case Position::kInside:
      return "inside";
    case Position::kBoundary:
      return "boundary";
    case Position::kOutside:
      return "outside";
    case Position::kDegenerate:
      return "degenerate";
  }
  return "unknown";
}

template <class T>
bool IsFinite(const Triangle<T>& triangle, const Point<T>& p) {
  return IsFinitePoint(triangle.a) && IsFinitePoint(triangle.b) &&
         IsFinitePoint(triangle.c) && IsFinitePoint(p);
}

template <class T>
Position Classify(const Triangle<T>& triangle, const Point<T>& p) {
  return ClassifyBy(Orientation<T>, triangle, p);
}

template <class T>
Position ClassifyExactly(const Triangle<T>& triangle, const Point<T>& p) {
  return ClassifyBy(OrientationExactly<T>, triangle, p);
}

template bool IsFinite(const Triangle<float>&, const Point<float>&);
template bool IsFinite(const Triangle<double>&, const Point<double>&);
template bool IsFinite(const Triangle<std::int32_t>&,
                       const Point<std::int32_t>&);
template bool IsFinite(const Triangle<std::int16_t>&,
                       const Point<std::int16_t>&);
template bool IsFinite(const Triangle<std::uint8_t>&,
                       const Point<std::uint8_t>&);
template Position Classify(const Triangle<float>&, const Point<float>&);
template Position Classify(const Triangle<double>&, const Point<double>&);
template Position Classify(const Triangle<std::int32_t>&,
                           const Point<std::int32_t>&);
template Position Classify(const Triangle<std::int16_t>&,
                           const Point<std::int16_t>&);
template Position Classify(const Triangle<std::uint8_t>&,
                           const Point<std::uint8_t>&);
template Position Classify(const Triangle<mpq_class>&, const Point<mpq_class>&);
template Position ClassifyExactly(const Triangle<float>&, const Point<float>&);
template Position ClassifyExactly(const Triangle<double>&,
                                  const Point<double>&);
template Position ClassifyExactly(const Triangle<std::int32_t>&,
                                  const Point<std::int32_t>&);
template Position ClassifyExactly(const Triangle<std::int16_t>&,
                                  const Point<std::int16_t>&);
template Position ClassifyExactly(const Triangle<std::uint8_t>&,
                                  const Point<std::uint8_t>&);

}  // namespace pitbench
