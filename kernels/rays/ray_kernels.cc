#include "kernels/rays/ray_kernels.h"

#include <hwy/targets.h>

#include <vector>

namespace pitbench {

#define PITBENCH_KERNEL RayKernel
#define PITBENCH_FUNCTION(key) ray_##key
#define PITBENCH_METHODS "kernels/rays/methods.inc"
#include "kernels/join_kernels.inc"

std::span<const RayKernel> AllRayKernels() {
  static const std::vector<RayKernel> all = JoinKernels();
  return all;
}

std::string_view Name(RayLoop loop, RayOutput output) {
  const bool tuv = output == RayOutput::kTuv;
  switch (loop) {
    case RayLoop::kOneTriangleRays:
      return tuv ? "one_triangle_rays_tuv" : "one_triangle_rays";
    case RayLoop::kOneRay:
      return "one_ray";
    case RayLoop::kRayPairs:
      return tuv ? "ray_pairs_tuv" : "ray_pairs";
  }
  return "?";
}

}  // namespace pitbench
