// Rays of which a given share hits, whatever the triangle.
//
// All rays pass one point Q (a pinhole), so whether one hits depends on its
// direction alone: on a point (x, y) of a unit square that stands for the
// directions w + (2x − 1) p + (2y − 1) q, with w along (1, 1, 1) and p and q
// across it, so that each of the three axes is the longest of some of them. A
// triangle of that square that covers the share asked for (see uniform.cc) is
// one in space once each vertex is put somewhere along its direction from Q.
// Origins lie anywhere from Q back to where it is behind them by one length.
//
// The rays stay and the triangles change (fresh), as in uniform.cc.
#include <cmath>
#include <cstdint>

#include "harness/scenes/rays/ray_families.h"
#include "harness/scenes/uniform_sets.h"

namespace pitbench {
namespace {

constexpr Vector3 kPinhole{0.375, -0.25, 0.5};

Vector3 DirectionOf(const Point<double>& p) {
  const double x = p.x - 0.5;
  const double y = p.y - 0.5;
  // p = (1, −1, 0), q = (½, ½, −1).
  return {1 + x + y / 2, 1 - x + y / 2, 1 - y};
}

template <class T>
Ray<T> DrawUniformRay(Random& random) {
  const Vector3 along = DirectionOf(InUnitSquare(random));
  const double back = random.Unit();
  const double length = random.In(0.5, 2);
  return RayAlong(Rounded<T>(kPinhole - back * along),
                  Rounded<T>(length * along));
}

template <class T>
Triangle3<T> DrawUniformTriangle(Random& random, double share) {
  const Triangle<double> t = Covering(random, share);
  const auto place = [&random](const Point<double>& p) {
    return Rounded<T>(kPinhole + random.In(1, 2) * DirectionOf(p));
  };
  const Point3<T> a = place(t.a);
  const Point3<T> b = place(t.b);
  return {a, b, place(t.c)};
}

}  // namespace

template <class T>
RayScene<T> RaysUniformScene(const SceneSpec& spec, RayLoop loop,
                             SceneSize /*size*/, std::uint64_t seed) {
  const double share = static_cast<double>(spec.Number("hit", 0, 100)) / 100;
  RayScene<T> scene{.name = spec.name, .loop = loop};
  AddUniformSets(
      spec, seed, {.point = 6 * sizeof(T), .triangle = 9 * sizeof(T)},
      DrawUniformRay<T>,
      [share](Random& random) { return DrawUniformTriangle<T>(random, share); },
      scene);
  return scene;
}

PITBENCH_INSTANTIATE_RAYS(RaysUniformScene);

}  // namespace pitbench
