// Needles in space: triangles of length 1 and altitude 2^-aspect, in any
// direction.
#include <cmath>
#include <cstdint>

#include "harness/scenes/rays/ray_families.h"

namespace pitbench {
namespace {

template <class T>
struct Needle {
  double altitude;

  Triangle3<T> DrawTriangle(Random& random) const {
    const Vector3 a = InUnitCube(random);
    const Vector3 along = AnyDirection(random);
    Vector3 across = Cross(along, AnyDirection(random));
    while (Dot(across, across) < 0.01) {
      across = Cross(along, AnyDirection(random));
    }
    const double s = random.In(0.2, 0.8);
    return Rounded<T>(Triangle3<double>{
        a, a + along, a + s * along + altitude * Unit(across)});
  }
  // In the frame of the needle, as it was rounded: along it and across, in
  // units of its length and altitude.
  Point3<T> Target(Random& random, const Triangle3<T>& rounded) const {
    const Triangle3<double> t = Widened(rounded);
    const Vector3 along = t.b - t.a;
    const Vector3 third = t.c - t.a;
    const double foot = Dot(third, along) / Dot(along, along);
    const Vector3 across = third - foot * along;
    const double s = random.In(-0.1, 1.1);
    return Rounded<T>(t.a + s * along + random.In(-1, 2) * across);
  }
};

}  // namespace

template <class T>
RayScene<T> RaysNeedleScene(const SceneSpec& spec, RayLoop loop, SceneSize size,
                            std::uint64_t seed) {
  const auto aspect = static_cast<int>(spec.Number("aspect", 0, 60));
  const Aimed<T, Needle<T>> family{{std::ldexp(1.0, -aspect)}};
  return AssembleRays<T>(family, spec, loop, size, seed);
}

PITBENCH_INSTANTIATE_RAYS(RaysNeedleScene);

}  // namespace pitbench
