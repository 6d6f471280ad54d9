// Rays that pass a vertex at a chosen number of representable numbers.
//
// The target is a vertex of a well-shaped triangle in the unit cube, moved by
// that many numbers along one axis and by as many or fewer along the others.
// The ray goes there, as its direction rounds; from an origin and to a vertex
// on the grid (a quarter of all) it does so exactly.
#include <cmath>
#include <cstdint>

#include "harness/scenes/rays/ray_families.h"

namespace pitbench {
namespace {

template <class T>
struct NearVertex {
  std::int64_t ulps;

  Triangle3<T> DrawTriangle(Random& random) const {
    const bool on_grid = random.Below(2) == 0;
    return WellShapedOnGrid<T>(random, on_grid);
  }
  Point3<T> Target(Random& random, const Triangle3<T>& t) const {
    const Point3<T> vertices[] = {t.a, t.b, t.c};
    const std::size_t k = random.Below(3);
    return BesideVertex(random, vertices[k], ulps);
  }
};

}  // namespace

template <class T>
RayScene<T> RaysNearVertexScene(const SceneSpec& spec, RayLoop loop,
                                SceneSize size, std::uint64_t seed) {
  const Aimed<T, NearVertex<T>> family{{spec.Number("ulps", 0, 1 << 16)}};
  return AssembleRays<T>(family, spec, loop, size, seed);
}

PITBENCH_INSTANTIATE_RAYS(RaysNearVertexScene);

}  // namespace pitbench
