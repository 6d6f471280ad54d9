// Points a chosen number of representable numbers away from an edge.
//
// A point is rounded onto a random place of a random edge of a well-shaped
// triangle in the unit square and then moved by ±ulps representable numbers
// along the axis that is more across the edge. Rounding leaves it within about
// one ulp of where it should be; truth says where it is.
//
// edge_share: only some percent of the points are such, the others anywhere.
#include <cmath>

#include "harness/scenes/families.h"
#include "harness/scenes/step.h"

namespace pitbench {
namespace {

template <class T>
struct NearEdge {
  std::int64_t ulps;

  Triangle<T> DrawTriangle(Random& random) const {
    return Rounded<T>(WellShaped(random));
  }
  Point<T> DrawPoint(Random& random) const {
    return Rounded<T>(InUnitSquare(random));
  }

  std::int64_t Steps(Random& random) const {
    return random.Below(2) == 0 ? ulps : -ulps;
  }

  Point<T> PointFor(Random& random, const Triangle<T>& t) const {
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
    const Triangle<double> shape = WellShaped(random);
    const double s = random.In(0.1, 0.9);
    const double ex = shape.b.x - shape.a.x;
    const double ey = shape.b.y - shape.a.y;
    Point<T> aim = p;
    T& across = std::abs(ex) > std::abs(ey) ? aim.y : aim.x;
    across = Step(across, Steps(random));
    const Point<double> a{static_cast<double>(aim.x) - s * ex,
                          static_cast<double>(aim.y) - s * ey};
    Point<T> vertices[] = {
        Rounded<T>(a), Rounded<T>(Point<double>{a.x + ex, a.y + ey}),
        Rounded<T>(Point<double>{a.x + (shape.c.x - shape.a.x),
                                 a.y + (shape.c.y - shape.a.y)})};
    const std::size_t first = random.Below(3);
    return {vertices[first], vertices[(first + 1) % 3],
            vertices[(first + 2) % 3]};
  }
};

template <class T>
struct EdgeShare {
  std::uint64_t percent;
  NearEdge<T> near{0};

  Triangle<T> DrawTriangle(Random& random) const {
    return near.DrawTriangle(random);
  }
  Point<T> DrawPoint(Random& random) const { return near.DrawPoint(random); }
  Point<T> PointFor(Random& random, const Triangle<T>& t) const {
    return random.Below(100) < percent ? near.PointFor(random, t)
                                       : DrawPoint(random);
  }
  Triangle<T> TriangleFor(Random& random, const Point<T>& p) const {
    return random.Below(100) < percent ? near.TriangleFor(random, p)
                                       : DrawTriangle(random);
  }
};

}  // namespace

template <class T>
Scene<T> EdgeShareScene(const SceneSpec& spec, Loop loop, SceneSize size,
                        std::uint64_t seed) {
  const auto percent =
      static_cast<std::uint64_t>(spec.Number("percent", 0, 100));
  return Assemble<T>(EdgeShare<T>{percent}, spec, loop, size, seed);
}

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

template Scene<float> EdgeShareScene(const SceneSpec&, Loop, SceneSize,
                                     std::uint64_t);
template Scene<double> EdgeShareScene(const SceneSpec&, Loop, SceneSize,
                                      std::uint64_t);

}  // namespace pitbench
