// Points so near to the middle of a long edge that nearly all of the products
// cancels.
//
// An edge goes from v to −v, so exactly through the origin. A point is v or −v
// times 2^-binades, which is on it, or up to two representable numbers off. The
// determinant is then about 2^-(binades + digits) of the products that it is
// the difference of, and the differences before them have as many bits as
// binades + digits. Of f32 in f64 they round from 30 binades on, and from there
// on plain arithmetic, multiply-adds and Kahan's difference of products are
// wrong each in a way of its own. Before, only products round: a multiply-add
// is wrong of points on the edge, and little else goes wrong.
#include <cmath>

#include "harness/scenes/families.h"
#include "harness/scenes/step.h"

namespace pitbench {
namespace {

template <class T>
struct Cancellation {
  int binades;

  static Point<T> Vertex(Random& random) {
    const auto coordinate = [&random] {
      const double x = random.In(0.5, 1);
      return static_cast<T>(random.Below(2) == 0 ? x : -x);
    };
    const T x = coordinate();
    return {x, coordinate()};
  }
  static Point<T> Scaled(const Point<T>& p, int exponent) {
    return {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
  }
  // p or up to two numbers beside the line through it and the origin.
  static Point<T> Moved(Random& random, Point<T> p) {
    T& across = std::abs(p.x) > std::abs(p.y) ? p.y : p.x;
    across = Step(across, static_cast<std::int64_t>(random.Below(5)) - 2);
    return p;
  }

  // A triangle of which an edge goes from v to −v; any vertex is the first.
  static Triangle<T> WithEdge(Random& random, const Point<T>& v) {
    const Point<T> opposite{-v.x, -v.y};
    while (true) {
      const double x = random.In(-1, 1);
      const Point<T> c = Rounded<T>(Point<double>{x, random.In(-1, 1)});
      const auto wide = [](const Point<T>& p) -> Point<double> {
        return {static_cast<double>(p.x), static_cast<double>(p.y)};
      };
      if (!HasAltitude({wide(v), wide(opposite), wide(c)}, kWellShaped)) {
        continue;
      }
      const Point<T> vertices[] = {v, opposite, c};
      const std::size_t first = random.Below(3);
      return {vertices[first], vertices[(first + 1) % 3],
              vertices[(first + 2) % 3]};
    }
  }

  Triangle<T> DrawTriangle(Random& random) const {
    return WithEdge(random, Vertex(random));
  }
  Point<T> DrawPoint(Random& random) const {
    return Scaled(Vertex(random), -binades);
  }
  Point<T> PointFor(Random& random, const Triangle<T>& t) const {
    Point<T> v = t.a.x == -t.b.x && t.a.y == -t.b.y ? t.a : t.c;
    if (random.Below(2) == 0) v = {-v.x, -v.y};
    return Moved(random, Scaled(v, -binades));
  }
  Triangle<T> TriangleFor(Random& random, const Point<T>& p) const {
    return WithEdge(random, Scaled(Moved(random, p), binades));
  }
};

}  // namespace

template <class T>
Scene<T> CancellationScene(const SceneSpec& spec, Loop loop, SceneSize size,
                           std::uint64_t seed) {
  const auto binades =
      static_cast<int>(spec.Number("binades", 0, sizeof(T) == 4 ? 60 : 120));
  return Assemble<T>(Cancellation<T>{binades}, spec, loop, size, seed);
}

template Scene<float> CancellationScene(const SceneSpec&, Loop, SceneSize,
                                        std::uint64_t);
template Scene<double> CancellationScene(const SceneSpec&, Loop, SceneSize,
                                         std::uint64_t);

}  // namespace pitbench
