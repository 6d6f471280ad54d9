// Points a chosen number of representable numbers away from an edge.
//
// A point is rounded onto a random place of a random edge of a well-shaped
// triangle in the unit square and then moved by ±ulps representable numbers
// along the axis that is more across the edge, to either side as often.
// Rounding leaves it within about one ulp of where it should be; truth says
// where it is. So nearly none is exactly on the edge, and where ulps is 0, half
// of the triangles are such that it can be (exact_edge.h).
#include <cmath>

#include "harness/scenes/exact_edge.h"
#include "harness/scenes/families.h"
#include "harness/scenes/step.h"

namespace pitbench {
namespace {

template <class T>
struct NearEdge {
  std::int64_t ulps;
  ExactEdge<T> exact{};

  Triangle<T> DrawTriangle(Random& random) const {
    if (DrawsExact(random)) return exact.DrawTriangle(random);
    return Rounded<T>(WellShaped(random));
  }
  Point<T> DrawPoint(Random& random) const {
    if (DrawsExact(random)) return exact.DrawPoint(random);
    return Rounded<T>(InUnitSquare(random));
  }

  bool DrawsExact(Random& random) const {
    return ulps == 0 && random.Below(2) == 0;
  }
  std::int64_t Steps(Random& random) const {
    return random.Below(2) == 0 ? ulps : -ulps;
  }

  Point<T> PointFor(Random& random, const Triangle<T>& t) const {
    if (ulps == 0 && exact.Has(t)) return exact.PointFor(random, t);
    const Point<T> vertices[] = {t.a, t.b, t.c};
    const std::size_t k = random.Below(3);
    const Point<T>& v = vertices[k];
    const Point<T>& w = vertices[(k + 1) % 3];
    const double s = random.Unit();
    return BesideEdge(v, w, s, Steps(random));
  }

  // A triangle of which an edge runs through p or that many ulps of p beside
  // it. Its vertices are at most 1.5 away from p.
  Triangle<T> TriangleFor(Random& random, const Point<T>& p) const {
    if (ulps == 0 && exact.Has(p)) return exact.TriangleFor(random, p);
    const Triangle<double> shape = WellShaped(random);
    const double s = random.In(0.1, 0.9);
    const double ex = shape.b.x - shape.a.x;
    const double ey = shape.b.y - shape.a.y;
    Point<T> aim = p;
    T& across = std::abs(ex) > std::abs(ey) ? aim.y : aim.x;
    across = Step(across, Steps(random));
    return ShapeThrough(random, shape, s, aim);
  }
};

}  // namespace

template <class T>
Scene<T> NearEdgeScene(const SceneSpec& spec, Loop loop, SceneSize size,
                       std::uint64_t seed) {
  const NearEdge<T> family{spec.Number("ulps", 0, 1 << 16)};
  return Assemble<T>(family, spec, loop, size, seed);
}

template Scene<float> NearEdgeScene(const SceneSpec&, Loop, SceneSize,
                                    std::uint64_t);
template Scene<double> NearEdgeScene(const SceneSpec&, Loop, SceneSize,
                                     std::uint64_t);

}  // namespace pitbench
