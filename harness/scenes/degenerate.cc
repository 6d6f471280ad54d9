// Triangles without area, exactly: their vertices are small multiples of one
// vector, added to one point, and all of it is exact in T.
//
// The vector has as many bits as that leaves, so products of its components
// round: where one of two products is rounded and the other is not, as by a
// contracted multiply-add, such a triangle seems to have an area. Half of the
// collinear ones lie on a line through the origin instead and are multiples
// ±2^-k of one vector: so their differences round as well.
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>
#include <utility>

#include "harness/scenes/families.h"
#include "harness/scenes/step.h"

namespace pitbench {
namespace {

template <class T>
struct Degenerate {
  std::string_view kind;

  // Coordinates are multiples of 2^-kBits, in quarters where a point lies
  // between vertices. The largest is below 16 = 2^4 (see TriangleFor), and
  // 4 + 2 + kBits ≤ digits.
  static constexpr int kBits = std::numeric_limits<T>::digits - 6;
  static double OnGrid(double x) {
    return std::ldexp(std::floor(std::ldexp(x, kBits)), -kBits);
  }
  static Point<double> OnGrid(const Point<double>& p) {
    return {OnGrid(p.x), OnGrid(p.y)};
  }

  // Vertices within 2 of the unit square in either coordinate.
  Triangle<double> Draw(Random& random) const {
    const Point<double> base = OnGrid(InUnitSquare(random));
    Point<double> along{0, 0};
    while (along.x == 0 && along.y == 0) {
      const Point<double> p = InUnitSquare(random);
      along = OnGrid(Point<double>{2 * p.x - 1, 2 * p.y - 1});
    }
    // Three of −2 … 2, the first ones of a random order.
    int steps[] = {-2, -1, 0, 1, 2};
    for (std::size_t i = 0; i < 3; ++i) {
      std::swap(steps[i], steps[i + random.Below(5 - i)]);
    }
    const std::size_t one = random.Below(3);
    const std::size_t other = (one + 1) % 3;
    if (kind != "collinear") steps[one] = steps[other];
    if (kind == "single") steps[(one + 2) % 3] = steps[other];
    const auto at = [&](int k) -> Point<double> {
      return {base.x + k * along.x, base.y + k * along.y};
    };
    return {at(steps[0]), at(steps[1]), at(steps[2])};
  }

  // Different powers of two, either sign, in any order.
  static Triangle<double> Multiples(Random& random, const Point<double>& v) {
    double power = 1;
    double multiples[3];
    const std::size_t first = random.Below(3);
    for (std::size_t i = 0; i < 3; ++i) {
      power = std::ldexp(power, -1 - static_cast<int>(random.Below(8)));
      multiples[(first + i) % 3] = random.Below(2) == 0 ? power : -power;
    }
    const auto at = [&](double k) -> Point<double> {
      return {k * v.x, k * v.y};
    };
    return {at(multiples[0]), at(multiples[1]), at(multiples[2])};
  }
  bool IsMultiples(Random& random) const {
    return kind == "collinear" && random.Below(2) == 0;
  }

  // A point exactly on the line through the vertices, up to an edge's length
  // (4 in either coordinate) beyond them, in steps of a quarter of that edge.
  // All of one point: that. On a line through the origin it may round.
  static Point<double> OnLine(Random& random, const Triangle<double>& t) {
    const bool doubled = t.a.x == t.b.x && t.a.y == t.b.y;
    const Point<double>& to = doubled ? t.c : t.b;
    const double s = (static_cast<double>(random.Below(13)) - 4) / 4;
    return {t.a.x + s * (to.x - t.a.x), t.a.y + s * (to.y - t.a.y)};
  }

  Triangle<T> DrawTriangle(Random& random) const {
    if (!IsMultiples(random)) return Rounded<T>(Draw(random));
    const Point<T> v = Rounded<T>(InUnitSquare(random));
    return Rounded<T>(Multiples(random, {v.x, v.y}));
  }
  Point<T> DrawPoint(Random& random) const {
    return Rounded<T>(OnGrid(InUnitSquare(random)));
  }

  // Half of the points are on the line, a quarter one number beside it, a
  // quarter anywhere around.
  Point<T> PointFor(Random& random, const Triangle<T>& t) const {
    const Triangle<double> same{{t.a.x, t.a.y}, {t.b.x, t.b.y}, {t.c.x, t.c.y}};
    Point<T> p = Rounded<T>(OnLine(random, same));
    switch (random.Below(4)) {
      case 0:
        p.x = Step(p.x, random.Below(2) == 0 ? 1 : -1);
        break;
      case 1: {
        const Point<double> off = InUnitSquare(random);
        p = Rounded<T>(Point<double>{static_cast<double>(p.x) + off.x - 0.5,
                                     static_cast<double>(p.y) + off.y - 0.5});
        break;
      }
      default:
        break;
    }
    return p;
  }

  // Multiples of p itself are on a line with it. Any other triangle is moved so
  // that p is on its line, or beside it by a step of
  // the grid, or anywhere. Coordinates: at most 1 + 7 + 3.
  Triangle<T> TriangleFor(Random& random, const Point<T>& p) const {
    if (IsMultiples(random)) {
      return Rounded<T>(Multiples(random, {p.x, p.y}));
    }
    const Triangle<double> t = Draw(random);
    const Point<double> on = OnLine(random, t);
    Point<double> move{static_cast<double>(p.x) - on.x,
                       static_cast<double>(p.y) - on.y};
    switch (random.Below(4)) {
      case 0:
        move.x += std::ldexp(1.0, -kBits);
        break;
      case 1:
        move = {0, 0};
        break;
      default:
        break;
    }
    const auto moved = [&](const Point<double>& v) -> Point<double> {
      return {v.x + move.x, v.y + move.y};
    };
    return Rounded<T>(Triangle<double>{moved(t.a), moved(t.b), moved(t.c)});
  }
};

}  // namespace

template <class T>
Scene<T> DegenerateScene(const SceneSpec& spec, Loop loop, SceneSize size,
                         std::uint64_t seed) {
  const Degenerate<T> family{
      spec.Word("kind", {"collinear", "doubled", "single"})};
  return Assemble<T>(family, spec, loop, size, seed);
}

template Scene<float> DegenerateScene(const SceneSpec&, Loop, SceneSize,
                                      std::uint64_t);
template Scene<double> DegenerateScene(const SceneSpec&, Loop, SceneSize,
                                       std::uint64_t);

}  // namespace pitbench
