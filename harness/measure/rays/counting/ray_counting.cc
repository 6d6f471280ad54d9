#include "harness/measure/rays/counting/ray_counting.h"

#include <vector>

namespace pitbench {

// Written by CMake from kernels/rays/methods.inc.
#define PITBENCH_METHOD(key) std::span<const RayKernel> ray_##key();
namespace counting {
#include "counted_ray_methods.inc"
}
#undef PITBENCH_METHOD

std::span<const RayKernel> CountingRayKernels() {
  static const std::vector<RayKernel> all = [] {
    std::vector<RayKernel> joined;
    const auto add = [&joined](std::span<const RayKernel> rows) {
      joined.insert(joined.end(), rows.begin(), rows.end());
    };
#define PITBENCH_METHOD(key) add(counting::ray_##key());
#include "counted_ray_methods.inc"
#undef PITBENCH_METHOD
    return joined;
  }();
  return all;
}

}  // namespace pitbench
