#include "harness/scenes/generate.h"

#include <string_view>
#include <type_traits>

#include "harness/scenes/families.h"
#include "harness/scenes/rays/ray_scene.h"

namespace pitbench {
namespace {

template <class T>
struct Generator {
  std::string_view family;
  Scene<T> (*make)(const SceneSpec&, Loop, SceneSize, std::uint64_t);
};

template <class T>
constexpr Generator<T> kGenerators[] = {
    {"uniform", UniformScene<T>},
    {"near_edge", NearEdgeScene<T>},
    {"on_edge", OnEdgeScene<T>},
    {"on_boundary", OnBoundaryScene<T>},
    {"near_vertex", NearVertexScene<T>},
    {"needle", NeedleScene<T>},
    {"offset", OffsetScene<T>},
    {"scale", ScaleScene<T>},
    {"exponent_spread", ExponentSpreadScene<T>},
    {"cancellation", CancellationScene<T>},
    {"whole_numbers", WholeNumbersScene<T>},
    {"degenerate", DegenerateScene<T>},
    {"special", SpecialScene<T>},
    {"mesh_pair", MeshPairScene<T>},
    {"mesh_fan", MeshFanScene<T>},
    {"mesh_triangulation", MeshTriangulationScene<T>},
    {"corpus", CorpusScene<T>},
};

}  // namespace

template <class T>
Scene<T> MakeScene(const SceneSpec& spec, Loop loop, SceneSize size,
                   std::uint64_t seed) {
  loop = LoopOfScenes(loop);
  constexpr bool kInteger = std::is_integral_v<T>;
  const bool grid = spec.family == "grid_80x50";
  const bool grid_points = spec.family == "grid_points_80x50";
  if ((grid || grid_points) != kInteger || grid != (loop == Loop::kGrid) ||
      (grid && !std::is_same_v<T, std::int32_t>) ||
      (grid_points && loop != Loop::kOneTriangle)) {
    throw SceneError("scene '" + spec.name + "' has no meaning for loop " +
                     std::string(Name(loop)) + " and scalar " +
                     std::string(Name(ScalarOf<T>())));
  }
  if constexpr (kInteger) {
    if constexpr (std::is_same_v<T, std::int32_t>) {
      if (grid) return GridScene(spec, seed);
    }
    return GridPointsScene<T>(spec, seed);
  } else {
    for (const Generator<T>& generator : kGenerators<T>) {
      if (generator.family == spec.family) {
        return generator.make(spec, loop, size, seed);
      }
    }
    if (IsRayFamily(spec.family)) {
      throw SceneError("scene '" + spec.name + "' is one of rays, which loop " +
                       std::string(Name(loop)) + " does not take");
    }
    throw SceneError("scene '" + spec.name +
                     "' is not generated: it takes your own files");
  }
}

template Scene<float> MakeScene(const SceneSpec&, Loop, SceneSize,
                                std::uint64_t);
template Scene<double> MakeScene(const SceneSpec&, Loop, SceneSize,
                                 std::uint64_t);
template Scene<std::int32_t> MakeScene(const SceneSpec&, Loop, SceneSize,
                                       std::uint64_t);
template Scene<std::int16_t> MakeScene(const SceneSpec&, Loop, SceneSize,
                                       std::uint64_t);
template Scene<std::uint8_t> MakeScene(const SceneSpec&, Loop, SceneSize,
                                       std::uint64_t);

}  // namespace pitbench
