#include "kernels/counting/counting.h"

#include <initializer_list>
#include <vector>

namespace pitbench {

// counted/ is written by CMake from both methods.inc.
namespace counting {
#define PITBENCH_METHOD(key) std::span<const Kernel> key();
#include "counted/methods.inc"
#undef PITBENCH_METHOD
#define PITBENCH_METHOD(key) std::span<const RayKernel> ray_##key();
#include "counted/rays/methods.inc"
#undef PITBENCH_METHOD
}  // namespace counting

namespace {

template <class K>
std::vector<K> Joined(std::initializer_list<std::span<const K>> parts) {
  std::vector<K> all;
  for (const auto rows : parts) all.insert(all.end(), rows.begin(), rows.end());
  return all;
}

}  // namespace

std::span<const Kernel> CountingKernels() {
#define PITBENCH_METHOD(key) counting::key(),
  static const std::vector<Kernel> all = Joined<Kernel>({
#include "counted/methods.inc"
  });
#undef PITBENCH_METHOD
  return all;
}

std::span<const RayKernel> CountingRayKernels() {
#define PITBENCH_METHOD(key) counting::ray_##key(),
  static const std::vector<RayKernel> all = Joined<RayKernel>({
#include "counted/rays/methods.inc"
  });
#undef PITBENCH_METHOD
  return all;
}

}  // namespace pitbench
