// Kernels broken on purpose, to see what notices.
#ifndef PITBENCH_TESTS_SPOILED_KERNEL_H_
#define PITBENCH_TESTS_SPOILED_KERNEL_H_

#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string_view>

#include "harness/scenes/scene.h"
#include "kernels/kernels.h"

namespace pitbench {

// The scalar f32 kernel of the method for the loop.
inline const Kernel& ScalarKernel(std::string_view method, Loop loop,
                                  Output output) {
  for (const Kernel& kernel : AllKernels()) {
    if (kernel.method.key == method && kernel.isa == Isa::kScalar &&
        kernel.scalar == Scalar::kF32 && kernel.loop == loop &&
        kernel.output == output) {
      return kernel;
    }
  }
  throw std::logic_error("no such kernel");
}
inline const Kernel& OneTriangleKernel(std::string_view method, Output output) {
  return ScalarKernel(method, Loop::kOneTriangle, output);
}

// barycentric_determinant_closed, and then `kSpoil(batch, result)`.
template <Output kOutput, auto kSpoil>
Kernel SpoiledKernel() {
  static const Kernel right =
      OneTriangleKernel("barycentric_determinant_closed", kOutput);
  Kernel spoiled = right;
  spoiled.f32 = [](const Batch<float>& batch, const Result<float>& result) {
    right.f32(batch, result);
    kSpoil(batch, result);
  };
  return spoiled;
}

// One triangle, (0, 0) (4, 0) (0, 4), with nine points, and then a degenerate
// one with the same points.
enum HandMadePoint : std::size_t {
  kInNearA,
  kInNearB,
  kOutBehindBc,
  kOnBc,
  kOnA,
  kOutLeft,
  kInNearC,
  kNotANumber,
  kOutFar,
};
inline Scene<float> HandMadeScene() {
  Scene<float> scene{.name = "own", .loop = Loop::kOneTriangle};
  scene.Add(Triangle<float>{{0, 0}, {4, 0}, {0, 4}});
  scene.Add(Triangle<float>{{0, 0}, {1, 1}, {2, 2}});
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const Point<float>& p :
       {Point<float>{1, 1}, Point<float>{2, 1}, Point<float>{3, 3},
        Point<float>{2, 2}, Point<float>{0, 0}, Point<float>{-1, 1},
        Point<float>{1, 2}, Point<float>{nan, 1}, Point<float>{5, 5}}) {
    scene.Add(p);
  }
  scene.calls = {{0, 0, scene.px.size()}, {1, 0, scene.px.size()}};
  return scene;
}

inline void Set(std::uint8_t* bits, std::size_t i, bool inside) {
  const auto bit = static_cast<std::uint8_t>(1u << (i % 8));
  bits[i / 8] = static_cast<std::uint8_t>(inside ? bits[i / 8] | bit
                                                 : bits[i / 8] & ~bit);
}

}  // namespace pitbench

#endif  // PITBENCH_TESTS_SPOILED_KERNEL_H_
