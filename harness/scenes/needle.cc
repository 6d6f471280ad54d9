// Needles: triangles of length 1 and altitude 2^-aspect, in any direction.
#include <cmath>

#include "harness/scenes/families.h"

namespace pitbench {
namespace {

template <class T>
struct Needle {
  double altitude;

  // A direction (cos, sin) from the rational parametrization of the circle,
  // which needs no library function; angles are nearly uniform.
  static Point<double> Direction(Random& random) {
    const double s = random.In(-1, 1);
    const double sign = random.Below(2) == 0 ? 1 : -1;
    const double r = sign / (1 + s * s);
    return {(1 - s * s) * r, 2 * s * r};
  }

  // The needle from `a` along `along`, its third vertex to the left.
  Triangle<T> At(Random& random, const Point<double>& a,
                 const Point<double>& along) const {
    const double s = random.In(0.2, 0.8);
    return Rounded<T>(
        Triangle<double>{a,
                         {a.x + along.x, a.y + along.y},
                         {a.x + s * along.x - altitude * along.y,
                          a.y + s * along.y + altitude * along.x}});
  }

  Triangle<T> DrawTriangle(Random& random) const {
    const Point<double> a = InUnitSquare(random);
    return At(random, a, Direction(random));
  }
  Point<T> DrawPoint(Random& random) const {
    return Rounded<T>(InUnitSquare(random));
  }

  // Where a point lies in the frame of a needle: along it and across, in units
  // of its length and altitude.
  static Point<double> Local(Random& random) {
    const double along = random.In(-0.1, 1.1);
    return {along, random.In(-1, 2)};
  }

  Point<T> PointFor(Random& random, const Triangle<T>& t) const {
    const double ex = static_cast<double>(t.b.x) - static_cast<double>(t.a.x);
    const double ey = static_cast<double>(t.b.y) - static_cast<double>(t.a.y);
    const Point<double> local = Local(random);
    const double across = local.y * altitude;
    return Rounded<T>(
        Point<double>{static_cast<double>(t.a.x) + local.x * ex - across * ey,
                      static_cast<double>(t.a.y) + local.x * ey + across * ex});
  }

  Triangle<T> TriangleFor(Random& random, const Point<T>& p) const {
    const Point<double> along = Direction(random);
    const Point<double> local = Local(random);
    const double across = local.y * altitude;
    const Point<double> a{
        static_cast<double>(p.x) - local.x * along.x + across * along.y,
        static_cast<double>(p.y) - local.x * along.y - across * along.x};
    return At(random, a, along);
  }
};

}  // namespace

template <class T>
Scene<T> NeedleScene(const SceneSpec& spec, Loop loop, SceneSize size,
                     std::uint64_t seed) {
  const auto aspect = static_cast<int>(spec.Number("aspect", 0, 60));
  return Assemble<T>(Needle<T>{std::ldexp(1.0, -aspect)}, spec, loop, size,
                     seed);
}

template Scene<float> NeedleScene(const SceneSpec&, Loop, SceneSize,
                                  std::uint64_t);
template Scene<double> NeedleScene(const SceneSpec&, Loop, SceneSize,
                                   std::uint64_t);

}  // namespace pitbench
