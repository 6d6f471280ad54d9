// Calls of a size that a scene's name gives, with the same points at each
// (fresh: only the triangles change) or the other way round; for points and for
// rays.
#ifndef PITBENCH_HARNESS_SCENES_UNIFORM_SETS_H_
#define PITBENCH_HARNESS_SCENES_UNIFORM_SETS_H_

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

#include "harness/scenes/random.h"
#include "harness/scenes/scene.h"
#include "harness/scenes/spec.h"

namespace pitbench {

// What one point (or ray) and one triangle take in the arrays.
struct ItemBytes {
  std::size_t point;
  std::size_t triangle;
};

// Adds what `draw_point` and `draw_triangle` draw, and calls of as many items
// as the parameter `bytes` or `n` says.
template <class SceneType, class DrawPoint, class DrawTriangle>
void AddUniformSets(const SceneSpec& spec, std::uint64_t seed, ItemBytes bytes,
                    const DrawPoint& draw_point,
                    const DrawTriangle& draw_triangle, SceneType& scene) {
  using T = typename SceneType::Coordinate;
  const Loop shape = ShapeOf(scene.loop);
  const std::size_t item_bytes = shape == Loop::kOneTriangle ? bytes.point
                                 : shape == Loop::kOnePoint
                                     ? bytes.triangle
                                     : bytes.point + bytes.triangle;
  constexpr auto kMostBytes = std::int64_t{1} << 32;
  const bool counted = spec.parameters.contains("n");
  const auto size =
      static_cast<std::size_t>(counted ? spec.Number("n", 1, kMostBytes / 64)
                                       : spec.Number("bytes", 64, kMostBytes));
  const std::size_t n =
      counted ? size : std::max<std::size_t>(size / item_bytes, 1);
  // About a million different answers, or two sets where one is that large; so
  // few where a set is small that the triangles stay in the L2 cache.
  const std::size_t most = shape == Loop::kPairs ? 32 : counted ? 1024 : 256;
  const std::size_t sets =
      spec.Fresh()
          ? std::clamp<std::size_t>((std::size_t{1} << 20) / n, 2, most)
          : 1;

  // The fixed twin draws the same numbers, so its set is the first fresh one.
  std::string drawn(Name(shape));
  drawn.append("/").append(spec.Drawn());
  Random points(SeedFor(drawn + "/points", seed));
  Random triangles(SeedFor(drawn + "/triangles", seed));
  // Pairs: set k pairs the triangles with the points from k cache lines on.
  const std::size_t shift = shape == Loop::kPairs ? 64 / sizeof(T) : 0;
  const std::size_t point_count =
      shape == Loop::kOnePoint ? sets : n + shift * (sets - 1);
  const std::size_t triangle_count = shape == Loop::kOneTriangle ? sets : n;
  for (std::size_t i = 0; i < point_count; ++i) scene.Add(draw_point(points));
  for (std::size_t i = 0; i < triangle_count; ++i) {
    scene.Add(draw_triangle(triangles));
  }
  for (std::size_t k = 0; k < sets; ++k) {
    const std::size_t triangle = shape == Loop::kOneTriangle ? k : 0;
    const std::size_t point = shape == Loop::kOnePoint ? k : shift * k;
    scene.calls.push_back({triangle, point, n});
  }
}

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_SCENES_UNIFORM_SETS_H_
