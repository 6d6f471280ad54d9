// How far a ray is from where its answer changes, as a length.
#ifndef PITBENCH_HARNESS_TRUTH_RAY_DISTANCE_H_
#define PITBENCH_HARNESS_TRUTH_RAY_DISTANCE_H_

#include "harness/truth/ray_truth.h"

namespace pitbench {

// The distance of the ray's line from the triangle's boundary (the three closed
// segments, whatever its area); where the line goes through the triangle's
// interior, ahead of the origin or behind it, the distance of the origin from
// the triangle's plane if that is less. In ulps of the largest coordinate among
// those of triangle and origin. Relative error < 2^-50.
//
// If the answer for t from 0 to infinity is wrong the ray has to be moved at
// least as far for it to be right. A miss taken for a hit: the ray is no nearer
// to the triangle than its line is, and one that begins behind the plane no
// nearer than its origin is to that. A hit taken for a miss: the ray misses
// once its line has passed an edge or its origin the plane, and no sooner, so
// it is just this far. Seen along the ray the distances are those of the plane,
// so an angle makes no error look larger than it is: a ray that grazes a
// triangle meets its plane far from where a parallel one does, but passes all
// its edges closely. Turned over, the triangle changes sides only once a vertex
// has moved as far as well: the line is at most half as far from the boundary
// as a vertex is from the opposite edge, seen along the ray.
//
// Precondition: finite, D not 0, a coordinate of triangle or origin not 0.
template <class T>
double AnswerDistanceInUlps(const Triangle3<T>& triangle, const Ray<T>& ray);

// About the same, to choose by: computed with at least 11 bits more than T has,
// so it errs by some 2^-8 ulps where all coordinates are of one size.
template <class T>
double AnswerDistanceEstimate(const Triangle3<T>& triangle, const Ray<T>& ray);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_TRUTH_RAY_DISTANCE_H_
