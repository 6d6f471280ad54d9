// The search for the rays and triangles on which a ray method is most wrong; as
// hunt.h has it for 2D, and climbing as that does.
//
// The distance is how far a ray would have to be moved at least for the answer
// to be right (AnswerDistanceInUlps). So that it says how wrong a method is and
// not how small an ulp, inputs are confined: every coordinate is 0 or has a
// magnitude from 2^-30 to 1; of triangle and origin together, and of the
// direction, the largest is at least 1/2. t goes from 0 to infinity.
#ifndef PITBENCH_HARNESS_MEASURE_RAYS_RAY_HUNT_H_
#define PITBENCH_HARNESS_MEASURE_RAYS_RAY_HUNT_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "harness/truth/ray_truth.h"
#include "kernels/rays/ray_kernels.h"

namespace pitbench {

template <class T>
struct WrongRay {
  Triangle3<T> triangle;
  Ray<T> ray;
  bool said_hit;
  // Never kBoundary. To a method that culls what is hit from behind is a miss.
  RayPosition truth;
  double distance_ulps;
};

// Classify, but kMiss where the method culls and the triangle is hit from
// behind.
template <class T>
RayPosition ClassifyFor(const RayMethod& method, const Triangle3<T>& triangle,
                        const Ray<T>& ray);

// As Hunt in hunt.h. Precondition: the kernel is one of loop ray_pairs that
// writes hits alone, for T, and runs here.
template <class T>
std::vector<WrongRay<T>> HuntRays(const RayKernel& kernel, double seconds,
                                  std::uint64_t seed, std::size_t keep);

// As HuntCsv in hunt.h, with the columns
//   method,scalar,ax,ay,az,bx,…,cz,ox,oy,oz,dx,dy,dz,said,truth,distance_ulps
// tests/rays/worst_rays.csv has such lines.
template <class T>
std::string HuntRaysCsv(const RayKernel& kernel,
                        const std::vector<WrongRay<T>>& found);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_RAYS_RAY_HUNT_H_
