// Rays from an origin 2^exponent away from a well-shaped triangle in the unit
// cube, at targets in it and around. Directions have length 1, so t is
// 2^exponent: an ulp of t is as long as the triangle where the exponent is that
// of T's digits.
#include <cmath>
#include <cstdint>

#include "harness/scenes/rays/ray_families.h"

namespace pitbench {
namespace {

template <class T>
struct FarOrigin {
  double distance;

  Triangle3<T> DrawTriangle(Random& random) const {
    return Rounded<T>(WellShaped3(random));
  }
  Ray<T> Through(const Vector3& target, const Vector3& away) const {
    const Point3<T> direction = Rounded<T>(Unit(target - away));
    return RayAlong(Rounded<T>(target - distance * Widened(direction)),
                    direction);
  }
  Ray<T> DrawRay(Random& random) const {
    const Vector3 target = InUnitCube(random);
    return Through(target, target + AnyDirection(random));
  }
  Ray<T> RayFor(Random& random, const Triangle3<T>& rounded) const {
    const Triangle3<double> t = Widened(rounded);
    const Vector3 target = InOrAround(random, t);
    return Through(target, OriginBefore(random, t, target));
  }
  // A ray at the unit cube: the triangle is moved so that its target is on it,
  // in the cube or next to it.
  Triangle3<T> TriangleFor(Random& random, const Ray<T>& ray) const {
    const Triangle3<double> t = WellShaped3(random);
    const Vector3 move = Widened(ray.origin) +
                         distance * Widened(ray.direction) -
                         InOrAround(random, t);
    return Rounded<T>(Triangle3<double>{t.a + move, t.b + move, t.c + move});
  }
};

}  // namespace

template <class T>
RayScene<T> RaysFarOriginScene(const SceneSpec& spec, RayLoop loop,
                               SceneSize size, std::uint64_t seed) {
  const auto exponent = static_cast<int>(spec.Number("exponent", 0, 60));
  const FarOrigin<T> family{std::ldexp(1.0, exponent)};
  return AssembleRays<T>(family, spec, loop, size, seed);
}

PITBENCH_INSTANTIATE_RAYS(RaysFarOriginScene);

}  // namespace pitbench
