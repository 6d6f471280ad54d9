// Points a chosen number of representable numbers away from a vertex.
//
// One coordinate is that many numbers above or below the vertex's, the other
// as many or fewer.
#include <cstdint>
#include <utility>

#include "harness/scenes/families.h"
#include "harness/scenes/step.h"

namespace pitbench {
namespace {

template <class T>
struct NearVertex {
  std::int64_t ulps;

  Triangle<T> DrawTriangle(Random& random) const {
    return Rounded<T>(WellShaped(random));
  }
  Point<T> DrawPoint(Random& random) const {
    return Rounded<T>(InUnitSquare(random));
  }

  Point<T> Beside(Random& random, const Point<T>& vertex) const {
    std::int64_t x = random.Below(2) == 0 ? ulps : -ulps;
    std::int64_t y = static_cast<std::int64_t>(random.Below(
                         static_cast<std::uint64_t>(2 * ulps + 1))) -
                     ulps;
    if (random.Below(2) == 0) std::swap(x, y);
    return {Step(vertex.x, x), Step(vertex.y, y)};
  }

  Point<T> PointFor(Random& random, const Triangle<T>& t) const {
    const Point<T> vertices[] = {t.a, t.b, t.c};
    const std::size_t k = random.Below(3);
    return Beside(random, vertices[k]);
  }

  // A triangle of which a vertex is that near to p. The others are at most 1.5
  // away from it.
  Triangle<T> TriangleFor(Random& random, const Point<T>& p) const {
    const Triangle<double> shape = WellShaped(random);
    const Point<T> near = Beside(random, p);
    const auto placed = [&](const Point<double>& v) {
      return Rounded<T>(
          Point<double>{static_cast<double>(near.x) + (v.x - shape.a.x),
                        static_cast<double>(near.y) + (v.y - shape.a.y)});
    };
    const Point<T> vertices[] = {near, placed(shape.b), placed(shape.c)};
    const std::size_t first = random.Below(3);
    return {vertices[first], vertices[(first + 1) % 3],
            vertices[(first + 2) % 3]};
  }
};

}  // namespace

template <class T>
Scene<T> NearVertexScene(const SceneSpec& spec, Loop loop, SceneSize size,
                         std::uint64_t seed) {
  const NearVertex<T> family{spec.Number("ulps", 0, 1 << 16)};
  return Assemble<T>(family, spec, loop, size, seed);
}

template Scene<float> NearVertexScene(const SceneSpec&, Loop, SceneSize,
                                      std::uint64_t);
template Scene<double> NearVertexScene(const SceneSpec&, Loop, SceneSize,
                                       std::uint64_t);

}  // namespace pitbench
