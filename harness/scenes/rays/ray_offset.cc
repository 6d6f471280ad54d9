// Far from the origin of the coordinates: well-shaped triangles in a unit cube
// whose corner is at (2^ratio, 2^ratio, 2^ratio), and rays from near by.
#include <cmath>
#include <cstdint>

#include "harness/scenes/rays/ray_families.h"

namespace pitbench {
namespace {

template <class T>
struct Offset {
  Vector3 corner;

  Triangle3<T> DrawTriangle(Random& random) const {
    const Triangle3<double> t = WellShaped3(random);
    return Rounded<T>(
        Triangle3<double>{corner + t.a, corner + t.b, corner + t.c});
  }
  Ray<T> DrawRay(Random& random) const {
    const Vector3 from = corner + 2 * InUnitCube(random);
    const Vector3 along = AnyWay(random, 1, 3);
    return RayAlong(Rounded<T>(from), Rounded<T>(along));
  }
  Ray<T> RayFor(Random& random, const Triangle3<T>& rounded) const {
    const Triangle3<double> t = Widened(rounded);
    const Vector3 target = InOrAround(random, t);
    return RayTo(OriginBefore(random, t, target), Rounded<T>(target));
  }
  Triangle3<T> TriangleFor(Random& random, const Ray<T>& ray) const {
    const Triangle3<double> t = WellShaped3(random);
    const Vector3 move =
        Widened(ray.origin) + Widened(ray.direction) - InOrAround(random, t);
    return Rounded<T>(Triangle3<double>{t.a + move, t.b + move, t.c + move});
  }
};

}  // namespace

template <class T>
RayScene<T> RaysOffsetScene(const SceneSpec& spec, RayLoop loop, SceneSize size,
                            std::uint64_t seed) {
  const double far =
      std::ldexp(1.0, static_cast<int>(spec.Number("ratio", 0, 60)));
  return AssembleRays<T>(Offset<T>{{far, far, far}}, spec, loop, size, seed);
}

PITBENCH_INSTANTIATE_RAYS(RaysOffsetScene);

}  // namespace pitbench
