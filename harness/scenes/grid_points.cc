// The triangles of grid_80x50 with the pixels given as an array of points, in
// the order of the grid: what the same work costs where nothing is known of
// the points. A call is one triangle and all 4000 points.
#include "harness/scenes/families.h"

namespace pitbench {

template <class T>
Scene<T> GridPointsScene(const SceneSpec& spec, std::uint64_t seed) {
  SceneSpec of_grid = spec;
  of_grid.family = "grid_80x50";  // its triangles
  const Scene<std::int32_t> grid = GridScene(of_grid, seed);
  Scene<T> scene{.name = spec.name, .loop = Loop::kOneTriangle};
  const auto point = [](const Point<std::int32_t>& p) -> Point<T> {
    return {static_cast<T>(p.x), static_cast<T>(p.y)};
  };
  for (std::size_t y = 0; y < grid.height; ++y) {
    for (std::size_t x = 0; x < grid.width; ++x) {
      scene.Add(Point<T>{static_cast<T>(x), static_cast<T>(y)});
    }
  }
  for (std::size_t i = 0; i < grid.ax.size(); ++i) {
    const Triangle<std::int32_t> t = grid.TriangleAt(i);
    scene.calls.push_back({scene.ax.size(), 0, scene.px.size()});
    scene.Add(Triangle<T>{point(t.a), point(t.b), point(t.c)});
  }
  return scene;
}

template Scene<std::int32_t> GridPointsScene(const SceneSpec&, std::uint64_t);
template Scene<std::int16_t> GridPointsScene(const SceneSpec&, std::uint64_t);
template Scene<std::uint8_t> GridPointsScene(const SceneSpec&, std::uint64_t);

}  // namespace pitbench
