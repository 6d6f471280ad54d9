// Whether a point is in a triangle, decided by exact arithmetic: what is left
// to do for the points that a kernel's filter cannot decide.
//
// Never allocates, throws, overflows or underflows; right for all finite
// coordinates, subnormal ones and the largest included.
#ifndef PITBENCH_KERNELS_EXACT_CONTAINS_H_
#define PITBENCH_KERNELS_EXACT_CONTAINS_H_

#include "kernels/kernels.h"

namespace pitbench {

// Coordinates of a triangle's vertices.
template <class T>
struct Corners {
  T ax, ay, bx, by, cx, cy;
};

// The sign of the area of triangle abc: +1 counter-clockwise, −1 clockwise, 0
// collinear, or not finite. T is float or double.
template <class T>
int ExactOrientation(const Corners<T>& abc);

// Whether the triangle contains (x, y) under the boundary rule. A triangle of
// area 0 contains nothing, and NaN or infinity anywhere means outside. T is
// float or double.
template <class T>
bool ExactlyContains(Boundary boundary, const Corners<T>& triangle, T x, T y);

}  // namespace pitbench

#endif  // PITBENCH_KERNELS_EXACT_CONTAINS_H_
