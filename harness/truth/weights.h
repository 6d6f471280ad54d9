// How right a weight is, and how near a point lies to a triangle's boundary:
// computed from exact arithmetic (GMP), so for all finite coordinates.
#ifndef PITBENCH_HARNESS_TRUTH_WEIGHTS_H_
#define PITBENCH_HARNESS_TRUTH_WEIGHTS_H_

#include <gmpxx.h>

#include <array>

#include "harness/truth/truth.h"

namespace pitbench {

// The barycentric weights of A, B and C: w_a + w_b + w_c = 1 and
// w_a·A + w_b·B + w_c·C = p, both exactly.
// Precondition: coordinates finite, area not 0. T is float, double or
// std::int32_t.
template <class T>
std::array<mpq_class, 3> ExactWeights(const Triangle<T>& triangle,
                                      const Point<T>& p);

// |computed − exact| in ulps, where an ulp is the spacing of T's numbers at
// `exact`: 2^(⌊log2|exact|⌋ + 1 − digits of T), at least the smallest
// subnormal. Truncated to double (relative error < 2^-52). Infinite if
// `computed` is NaN or infinite. T is float or double.
template <class T>
double UlpError(T computed, const mpq_class& exact);

// The Euclidean distance from p to the nearest point of the triangle's
// boundary (the three closed segments, whatever its area), in ulps of p's
// coordinate of larger magnitude; for std::int32_t an ulp is 1.
// Relative error < 2^-50. Infinite only where the quotient exceeds double,
// as it can for f64 at p = (0, 0), where an ulp is 2^-1074.
// Precondition: coordinates finite. T is float, double or std::int32_t.
template <class T>
double BoundaryDistanceInUlps(const Triangle<T>& triangle, const Point<T>& p);

// Whether rounding, and not a broken kernel, may be why a kernel whose
// arithmetic is T misjudges this point: whether some exact weight is within
//   slack · u · (M/h)²
// of 0, where u is T's unit roundoff (2^-24, 2^-53), M the largest magnitude
// among the coordinates of triangle and point, and h the triangle's smallest
// altitude (twice its area over its longest edge). The comparison is exact.
//
// Why (M/h)²: an edge function is summed from terms of size M² and errs by a
// few u·M²; a weight is an edge function over twice the area, which is at
// least h². A method that squares the edges (Gram) loses (L/h)² instead, for
// a longest edge L ≤ 2√2·M. It says nothing of overflow and underflow.
//
// A triangle of area 0 has no weights, and rounding may always decide there.
// std::int32_t does not round (u = 0): always false.
// Precondition: coordinates finite, slack ≥ 0 and finite.
template <class T>
bool RoundingMayDecide(const Triangle<T>& triangle, const Point<T>& p,
                       double slack);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_TRUTH_WEIGHTS_H_
