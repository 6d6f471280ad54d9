// Whole coordinates of a chosen number of bits, the points as near to an edge
// as whole numbers can be.
//
// Let e be the edge from v to w and g the greatest common divisor of ex and ey.
// Then e × (p − v) is a multiple of g for every whole p, and a scene's points
// have −g, 0 or g. What a method needs so that it gets them right is all of the
// determinant's bits: so the scene tells up to how many bits of the coordinates
// it is exact.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <utility>

#include "harness/scenes/families.h"

namespace pitbench {
namespace {

using Whole = Point<std::int64_t>;

Whole operator+(const Whole& a, const Whole& b) {
  return {a.x + b.x, a.y + b.y};
}
Whole operator-(const Whole& a, const Whole& b) {
  return {a.x - b.x, a.y - b.y};
}
Whole operator*(std::int64_t k, const Whole& a) { return {k * a.x, k * a.y}; }

double Dot(const Whole& a, const Whole& b) {
  return static_cast<double>(a.x) * static_cast<double>(b.x) +
         static_cast<double>(a.y) * static_cast<double>(b.y);
}

// Steps that lead to every whole point: `along` an edge, of which it takes
// `count` to its end, and `across` it, along × across = 1.
struct Steps {
  Whole along, across;
  std::int64_t count;
};

// Of an edge that is not 0, by Euclid's extended algorithm.
Steps StepsOf(const Whole& edge) {
  // Always r = s·|edge.x| + t·|edge.y|, and so for the next three.
  std::int64_t r = std::abs(edge.x), next_r = std::abs(edge.y);
  std::int64_t s = 1, next_s = 0;
  std::int64_t t = 0, next_t = 1;
  while (next_r != 0) {
    const std::int64_t quotient = r / next_r;
    r = std::exchange(next_r, r - quotient * next_r);
    s = std::exchange(next_s, s - quotient * next_s);
    t = std::exchange(next_t, t - quotient * next_t);
  }
  const Whole across{edge.y < 0 ? t : -t, edge.x < 0 ? -s : s};
  return {{edge.x / r, edge.y / r}, across, r};
}

// From the beginning of an edge to a random one of the whole points beside it
// that are nearest to it, or on it, if there are any between its ends.
Whole ToNearest(Random& random, const Whole& edge) {
  const Steps steps = StepsOf(edge);
  const auto count = static_cast<std::uint64_t>(steps.count);
  const std::uint64_t side = random.Below(count > 1 ? 3 : 2);
  if (side == 2) {
    const auto k = static_cast<std::int64_t>(1 + random.Below(count - 1));
    return k * steps.along;
  }
  const Whole beside = (side == 0 ? 1 : -1) * steps.across;
  const double passed =
      std::floor(Dot(beside, steps.along) / Dot(steps.along, steps.along));
  const auto k = static_cast<std::int64_t>(random.Below(count)) -
                 static_cast<std::int64_t>(passed);
  return beside + k * steps.along;
}

template <class T>
struct WholeNumbers {
  int bits;

  std::int64_t Most() const { return std::int64_t{1} << bits; }
  Whole Draw(Random& random) const {
    const auto coordinate = [&] {
      const auto all = static_cast<std::uint64_t>(2 * Most() + 1);
      return static_cast<std::int64_t>(random.Below(all)) - Most();
    };
    const std::int64_t x = coordinate();
    return {x, coordinate()};
  }
  bool Holds(const Whole& p) const {
    return std::abs(p.x) <= Most() && std::abs(p.y) <= Most();
  }
  bool IsWellShaped(const Whole& a, const Whole& b, const Whole& c) const {
    const auto in_units = [this](const Whole& p) -> Point<double> {
      return {std::ldexp(static_cast<double>(p.x), -bits),
              std::ldexp(static_cast<double>(p.y), -bits)};
    };
    return HasAltitude({in_units(a), in_units(b), in_units(c)}, kWellShaped);
  }
  static Point<T> Cast(const Whole& p) {
    return {static_cast<T>(p.x), static_cast<T>(p.y)};
  }
  static Whole Cast(const Point<T>& p) {
    return {static_cast<std::int64_t>(p.x), static_cast<std::int64_t>(p.y)};
  }

  Triangle<T> DrawTriangle(Random& random) const {
    while (true) {
      const Whole a = Draw(random);
      const Whole b = Draw(random);
      const Whole c = Draw(random);
      if (IsWellShaped(a, b, c)) return {Cast(a), Cast(b), Cast(c)};
    }
  }
  // In the inner half, so that long edges pass it.
  Point<T> DrawPoint(Random& random) const {
    const Whole p = Draw(random);
    return Cast(Whole{p.x / 2, p.y / 2});
  }
  Point<T> PointFor(Random& random, const Triangle<T>& t) const {
    const Whole vertices[] = {Cast(t.a), Cast(t.b), Cast(t.c)};
    const std::size_t k = random.Below(3);
    while (true) {
      const Whole& v = vertices[k];
      const Whole p = v + ToNearest(random, vertices[(k + 1) % 3] - v);
      if (Holds(p)) return Cast(p);
    }
  }
  Triangle<T> TriangleFor(Random& random, const Point<T>& p) const {
    while (true) {
      const Whole edge = Draw(random);
      if (edge.x == 0 && edge.y == 0) continue;
      const Whole v = Cast(p) - ToNearest(random, edge);
      const Whole w = v + edge;
      const Whole c = Draw(random);
      if (!Holds(v) || !Holds(w) || !IsWellShaped(v, w, c)) continue;
      const Point<T> vertices[] = {Cast(v), Cast(w), Cast(c)};
      const std::size_t first = random.Below(3);
      return {vertices[first], vertices[(first + 1) % 3],
              vertices[(first + 2) % 3]};
    }
  }
};

}  // namespace

// From 3 bits on there are triangles that are well shaped with points beside
// each edge; with as many as T has, every coordinate is still what was drawn.
template <class T>
Scene<T> WholeNumbersScene(const SceneSpec& spec, Loop loop, SceneSize size,
                           std::uint64_t seed) {
  const auto bits =
      static_cast<int>(spec.Number("bits", 3, std::numeric_limits<T>::digits));
  return Assemble<T>(WholeNumbers<T>{bits}, spec, loop, size, seed);
}

template Scene<float> WholeNumbersScene(const SceneSpec&, Loop, SceneSize,
                                        std::uint64_t);
template Scene<double> WholeNumbersScene(const SceneSpec&, Loop, SceneSize,
                                         std::uint64_t);

}  // namespace pitbench
