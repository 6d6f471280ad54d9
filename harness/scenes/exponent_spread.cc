// Coordinates whose exponents lie anywhere in a range of binades.
//
// Points are rounded onto an edge, also very near to a vertex, so that theirs
// spread as well. What such a scene asks is whether a small term survives
// beside a large one.
#include <cmath>

#include "harness/scenes/families.h"
#include "harness/scenes/step.h"

namespace pitbench {
namespace {

template <class T>
struct ExponentSpread {
  std::uint64_t binades;

  // 2^-k for a random k from 0 to `binades`.
  double Power(Random& random) const {
    return std::ldexp(1.0, -static_cast<int>(random.Below(binades + 1)));
  }
  // ±[½, 1) times such a power.
  double Coordinate(Random& random) const {
    const double mantissa = random.In(0.5, 1);
    const double power = Power(random);
    return random.Below(2) == 0 ? mantissa * power : -mantissa * power;
  }
  Point<double> Draw(Random& random) const {
    const double x = Coordinate(random);
    const double y = Coordinate(random);
    return {x, y};
  }
  // How far along an edge: near to either end in every scale.
  double Along(Random& random) const {
    const double s = random.Unit();
    return s * Power(random);
  }

  Triangle<T> DrawTriangle(Random& random) const {
    const Point<double> a = Draw(random);
    const Point<double> b = Draw(random);
    const Point<double> c = Draw(random);
    return Rounded<T>(Triangle<double>{a, b, c});
  }
  Point<T> DrawPoint(Random& random) const { return Rounded<T>(Draw(random)); }

  Point<T> PointFor(Random& random, const Triangle<T>& t) const {
    const Point<T> vertices[] = {t.a, t.b, t.c};
    const std::size_t k = random.Below(3);
    const std::size_t other = (k + 1 + random.Below(2)) % 3;
    return BesideEdge(vertices[k], vertices[other], Along(random), 0);
  }

  // A triangle of which an edge runs through p, or as near as it rounds.
  Triangle<T> TriangleFor(Random& random, const Point<T>& p) const {
    const Point<double> edge = Draw(random);
    const double s = Along(random);
    const Point<double> a{static_cast<double>(p.x) - s * edge.x,
                          static_cast<double>(p.y) - s * edge.y};
    const Point<double> b{a.x + edge.x, a.y + edge.y};
    const Point<double> c = Draw(random);
    const Point<T> vertices[] = {Rounded<T>(a), Rounded<T>(b), Rounded<T>(c)};
    const std::size_t first = random.Below(3);
    return {vertices[first], vertices[(first + 1) % 3],
            vertices[(first + 2) % 3]};
  }
};

}  // namespace

// The products of two coordinates stay normal numbers: range is the matter of
// family scale.
template <class T>
Scene<T> ExponentSpreadScene(const SceneSpec& spec, Loop loop, SceneSize size,
                             std::uint64_t seed) {
  const auto binades = static_cast<std::uint64_t>(
      spec.Number("binades", 0, sizeof(T) == 4 ? 60 : 120));
  return Assemble<T>(ExponentSpread<T>{binades}, spec, loop, size, seed);
}

template Scene<float> ExponentSpreadScene(const SceneSpec&, Loop, SceneSize,
                                          std::uint64_t);
template Scene<double> ExponentSpreadScene(const SceneSpec&, Loop, SceneSize,
                                           std::uint64_t);

}  // namespace pitbench
