// From the name of a scene to its arrays.
//
// The same name, loop, scalar and seed give the same bits on every platform:
// the generators use only +, −, ×, ÷, square root and comparisons on doubles,
// without contraction, and round once to T.
#ifndef PITBENCH_HARNESS_SCENES_GENERATE_H_
#define PITBENCH_HARNESS_SCENES_GENERATE_H_

#include <cstdint>

#include "harness/scenes/scene.h"
#include "harness/scenes/spec.h"

namespace pitbench {

inline constexpr std::uint64_t kDefaultSeed = 1;

// How much a scene holds: `groups` calls of `size` items each, one call where
// its sets are fixed. Scenes that name their own size (uniform, grid_80x50) do
// not use it.
struct SceneSize {
  std::size_t groups = 1;
  std::size_t size = 1;
};

// Throws SceneError if the scene has no meaning for this loop and scalar:
// T is std::int32_t for loop grid, an integer for the points of
// grid_points_80x50, float or double for the others.
template <class T>
Scene<T> MakeScene(const SceneSpec& spec, Loop loop, SceneSize size,
                   std::uint64_t seed);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_SCENES_GENERATE_H_
