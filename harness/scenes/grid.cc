// The scene of qTriangle's own program: random triangles with whole vertices
// on a grid of 80 × 50 pixels, each against every pixel.
#include "harness/scenes/families.h"

namespace pitbench {

Scene<std::int32_t> GridScene(const SceneSpec& spec, std::uint64_t seed) {
  constexpr std::size_t kTrianglesPerCall = 32;  // 16 kB of bits: in L1
  constexpr std::size_t kFreshCalls = 64;
  Scene<std::int32_t> scene{
      .name = spec.name, .loop = Loop::kGrid, .width = 80, .height = 50};
  const std::size_t calls = spec.Fresh() ? kFreshCalls : 1;
  Random random(SeedFor(spec.family, seed));
  const auto vertex = [&]() -> Point<std::int32_t> {
    const auto x = static_cast<std::int32_t>(random.Below(scene.width));
    return {x, static_cast<std::int32_t>(random.Below(scene.height))};
  };
  for (std::size_t call = 0; call < calls; ++call) {
    scene.calls.push_back({scene.ax.size(), 0, kTrianglesPerCall});
    for (std::size_t i = 0; i < kTrianglesPerCall; ++i) {
      const Point<std::int32_t> a = vertex();
      const Point<std::int32_t> b = vertex();
      scene.Add(Triangle<std::int32_t>{a, b, vertex()});
    }
  }
  return scene;
}

}  // namespace pitbench
