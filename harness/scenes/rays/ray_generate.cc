#include <limits>
#include <string_view>

#include "harness/scenes/rays/ray_families.h"

namespace pitbench {
namespace {

template <class T>
struct RayGenerator {
  std::string_view family;
  RayScene<T> (*make)(const SceneSpec&, RayLoop, SceneSize, std::uint64_t);
};

template <class T>
constexpr RayGenerator<T> kGenerators[] = {
    {"rays_uniform", RaysUniformScene<T>},
    {"rays_near_edge", RaysNearEdgeScene<T>},
    {"rays_near_vertex", RaysNearVertexScene<T>},
    {"rays_grazing", RaysGrazingScene<T>},
    {"rays_needle", RaysNeedleScene<T>},
    {"rays_far_origin", RaysFarOriginScene<T>},
    {"rays_offset", RaysOffsetScene<T>},
    {"rays_degenerate", RaysDegenerateScene<T>},
    {"rays_special", RaysSpecialScene<T>},
    {"rays_icosphere", RaysIcosphereScene<T>},
    {"rays_tiled_plane", RaysTiledPlaneScene<T>},
    {"rays_corpus", RaysCorpusScene<T>},
};

}  // namespace

bool IsRayFamily(std::string_view family) {
  return family.starts_with("rays_");
}

template <class T>
RayScene<T> MakeRayScene(const SceneSpec& spec, RayLoop loop, SceneSize size,
                         std::uint64_t seed) {
  for (const RayGenerator<T>& generator : kGenerators<T>) {
    if (generator.family != spec.family) continue;
    RayScene<T> scene = generator.make(spec, loop, size, seed);
    scene.t_min = 0;
    scene.t_max = std::numeric_limits<T>::infinity();
    return scene;
  }
  throw SceneError("scene '" + spec.name +
                   "' has no rays: the names of those that have begin with "
                   "rays_");
}

template RayScene<float> MakeRayScene(const SceneSpec&, RayLoop, SceneSize,
                                      std::uint64_t);
template RayScene<double> MakeRayScene(const SceneSpec&, RayLoop, SceneSize,
                                       std::uint64_t);

}  // namespace pitbench
