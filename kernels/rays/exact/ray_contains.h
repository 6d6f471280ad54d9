// Whether and where a ray meets a triangle, decided by exact arithmetic: what
// is left to do for the rays that a kernel's filter cannot decide.
//
// Never allocates, throws, overflows or underflows; right for all finite
// coordinates, subnormal ones and the largest included. The coordinates of f32
// are given as doubles, which they are.
#ifndef PITBENCH_KERNELS_RAYS_EXACT_RAY_CONTAINS_H_
#define PITBENCH_KERNELS_RAYS_EXACT_RAY_CONTAINS_H_

#include "kernels/kernels.h"

namespace pitbench {

// Triangle abc and the points origin + t·direction.
struct RayAndTriangle {
  double a[3], b[3], c[3];
  double origin[3], direction[3];
};

// Whether the ray meets the triangle under the boundary rule at a t from t_min
// to t_max, ends included; t_max may be infinite.
//   Boundary::kClosed     edges and vertices belong to the triangle
//   Boundary::kPerturbed  they belong to it if the ray hits it when its
//                         direction is turned by (ε, ε², ε³), ε as small as
//                         need be (Edelsbrunner & Mücke 1990)
// A triangle of area 0, a direction of length 0 or along the triangle's plane,
// and NaN or infinity anywhere else mean a miss.
bool RayExactlyHits(Boundary boundary, const RayAndTriangle& of, double t_min,
                    double t_max);

template <class T>
struct RayTuv {
  T t, u, v;
};

// t, u and v of where the ray's line meets the triangle's plane,
// origin + t·direction = (1 − u − v)·a + u·b + v·c, each rounded once, to the
// nearest T (of two the even one; what is above the largest: infinite).
// Precondition: the ray hits the triangle.
template <class T>
RayTuv<T> RoundedTuv(const RayAndTriangle& of);

// Whether a ray meets triangle x at a smaller t than triangle y. Precondition:
// it hits both, and is the same ray.
bool IsExactlyNearer(const RayAndTriangle& x, const RayAndTriangle& y);

}  // namespace pitbench

#endif  // PITBENCH_KERNELS_RAYS_EXACT_RAY_CONTAINS_H_
