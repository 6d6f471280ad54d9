// Rays that pass an edge at a chosen number of representable numbers.
//
// The target is a random place of a random edge of a well-shaped triangle in
// the unit cube, rounded, and then moved by ±ulps numbers along the axis that
// is most across the edge. The ray goes there, as its direction rounds: within
// two or three ulps of 1; truth says where it is.
//
// Half of the triangles are on the grid and have their targets at sixteenths of
// an edge. From an origin on the grid such a ray is exact, so before it is
// moved it meets the edge.
#include <cmath>
#include <cstdint>

#include "harness/scenes/rays/ray_families.h"

namespace pitbench {
namespace {

template <class T>
struct NearEdge {
  std::int64_t ulps;
  bool on_grid = false;

  Triangle3<T> DrawTriangle(Random& random) {
    on_grid = random.Below(2) == 0;
    return WellShapedOnGrid<T>(random, on_grid);
  }
  Point3<T> Target(Random& random, const Triangle3<T>& t) const {
    const Vector3 v[] = {Widened(t.a), Widened(t.b), Widened(t.c)};
    const std::size_t k = random.Below(3);
    const double unit = random.Unit();
    const double s = on_grid ? OnGrid(unit, 4) : unit;
    return BesideEdge<T>(v[k], v[(k + 1) % 3], v[(k + 2) % 3], s,
                         EitherSign(random, ulps));
  }
};

}  // namespace

template <class T>
RayScene<T> RaysNearEdgeScene(const SceneSpec& spec, RayLoop loop,
                              SceneSize size, std::uint64_t seed) {
  const Aimed<T, NearEdge<T>> family{{spec.Number("ulps", 0, 1 << 16)}};
  return AssembleRays<T>(family, spec, loop, size, seed);
}

PITBENCH_INSTANTIATE_RAYS(RaysNearEdgeScene);

}  // namespace pitbench
