// Far from the origin: a unit square whose corner is at (2^ratio, 2^ratio).
#include <cmath>

#include "harness/scenes/families.h"

namespace pitbench {
namespace {

template <class T>
struct Offset {
  double corner;

  Point<double> Moved(const Point<double>& p) const {
    return {p.x + corner, p.y + corner};
  }
  Triangle<T> DrawTriangle(Random& random) const {
    const Triangle<double> t = WellShaped(random);
    return Rounded<T>(Triangle<double>{Moved(t.a), Moved(t.b), Moved(t.c)});
  }
  Point<T> DrawPoint(Random& random) const {
    return Rounded<T>(Moved(InUnitSquare(random)));
  }
  Point<T> PointFor(Random& random, const Triangle<T>&) const {
    return DrawPoint(random);
  }
  Triangle<T> TriangleFor(Random& random, const Point<T>&) const {
    return DrawTriangle(random);
  }
};

}  // namespace

template <class T>
Scene<T> OffsetScene(const SceneSpec& spec, Loop loop, SceneSize size,
                     std::uint64_t seed) {
  const auto ratio = static_cast<int>(spec.Number("ratio", 0, 60));
  return Assemble<T>(Offset<T>{std::ldexp(1.0, ratio)}, spec, loop, size, seed);
}

template Scene<float> OffsetScene(const SceneSpec&, Loop, SceneSize,
                                  std::uint64_t);
template Scene<double> OffsetScene(const SceneSpec&, Loop, SceneSize,
                                   std::uint64_t);

}  // namespace pitbench
