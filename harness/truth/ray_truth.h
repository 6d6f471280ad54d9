// The exact answer for a ray and a triangle in space, whatever their
// coordinates: GMP on the binary values given, with a proven filter before it.
#ifndef PITBENCH_HARNESS_TRUTH_RAY_TRUTH_H_
#define PITBENCH_HARNESS_TRUTH_RAY_TRUTH_H_

#include <gmpxx.h>

#include <array>
#include <string_view>

namespace pitbench {

template <class T>
struct Point3 {
  T x;
  T y;
  T z;
};

template <class T>
struct Triangle3 {
  Point3<T> a;
  Point3<T> b;
  Point3<T> c;
};

// The points O + t·D with t_min ≤ t ≤ t_max.
template <class T>
struct Ray {
  Point3<T> origin;
  Point3<T> direction;
  T t_min;
  T t_max;
};

enum class RayPosition {
  kHit,         // through the interior, at a t within the range
  kBoundary,    // through an edge or a vertex, at a t within the range
  kMiss,        // also where a number is NaN or infinite (t_max may be +inf)
  kCoplanar,    // D is parallel to the triangle's plane: counts as a miss,
                // whether or not the ray lies in the plane
  kDegenerate,  // the triangle has no area, or D is 0: counts as a miss
};

std::string_view Name(RayPosition position);

template <class T>
bool IsFinite(const Triangle3<T>& triangle, const Ray<T>& ray);

// Never overflows, underflows or throws. T is float or double.
template <class T>
RayPosition Classify(const Triangle3<T>& triangle, const Ray<T>& ray);

// The same by GMP alone, without the filter.
template <class T>
RayPosition ClassifyExactly(const Triangle3<T>& triangle, const Ray<T>& ray);

// Whether the ray comes from the side from which the vertices go
// counter-clockwise: D·((B − A)×(C − A)) < 0. Precondition: finite.
template <class T>
bool IsFrontFacing(const Triangle3<T>& triangle, const Ray<T>& ray);

// t, u, v of where the ray's line meets the triangle's plane:
// O + t·D = (1 − u − v)·A + u·B + v·C.
// Precondition: finite, neither kCoplanar nor kDegenerate.
template <class T>
std::array<mpq_class, 3> ExactTuv(const Triangle3<T>& triangle,
                                  const Ray<T>& ray);

// How near the ray passes to the lines through the triangle's edges, as a
// number that no angle changes: the least of |u|, |v|, |1 − u − v| over the ulp
// (of T) of 1. Rounded to double. Precondition as for ExactTuv.
template <class T>
double EdgeDistanceInUlps(const Triangle3<T>& triangle, const Ray<T>& ray);

// Whether rounding, and not a broken kernel, may be why a kernel whose
// arithmetic is T misjudges this ray: whether some exact weight is within
//   slack · u · (M/h)² / sin
// of 0, or |t − end| · |D| within h times as much of 0 for an end of the range
// of t. u is T's unit roundoff (2^-24, 2^-53), h the triangle's smallest
// altitude, sin the sine of the angle between ray and plane, and M the largest
// magnitude among the coordinates of triangle, origin and t·D. The comparison
// is exact.
//
// Why: with L the longest edge, D·N = 2·area·|D|·sin = h·L·|D|·sin for the
// normal N = (B − A) × (C − A). A method works with lengths of up to M: what it
// divides by D·N is a sum of terms of size M·L·|D|, where it takes differences
// first, or M²·|D|, and errs by a few u of that, hence the weight by
// u·M²/(h·L·sin). One that computes the point O + t·D errs there by u·M·L/h/sin
// along D, since the direction of N does by u·L/h, and the weight by that over
// h. Both are below the bound, as L ≥ h and M is about L or more. The error of
// D·N itself is u·M/(h·sin) of it and errs as much of each weight, which are
// M/h at most, as t·D reaches that far at most. t·|D| errs as the point does.
// It says nothing of overflow and underflow.
//
// Where D is parallel to the plane, or the triangle has no area, rounding may
// always decide; where D is 0, never: then every product with it is 0.
// Precondition: finite, slack ≥ 0 and finite.
template <class T>
bool RoundingMayDecide(const Triangle3<T>& triangle, const Ray<T>& ray,
                       double slack);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_TRUTH_RAY_TRUTH_H_
