// Points exactly on the boundary, which no bound on a rounding error decides.
//
// on_edge: some percent of the points are exactly on an edge of a well-shaped
// triangle, the others anywhere.
//
// on_boundary: all points are, and the exponents of all coordinates spread. An
// edge goes from v to −v·2^j, so through the origin, and v·2^-k is on it; what
// multiplies by powers of two rounds nothing.
#include <algorithm>
#include <cmath>

#include "harness/scenes/exact_edge.h"
#include "harness/scenes/families.h"

namespace pitbench {
namespace {

template <class T>
struct OnEdge {
  std::uint64_t percent;
  ExactEdge<T> exact{};

  Triangle<T> DrawTriangle(Random& random) const {
    return exact.DrawTriangle(random);
  }
  Point<T> DrawPoint(Random& random) const { return exact.DrawPoint(random); }
  Point<T> PointFor(Random& random, const Triangle<T>& t) const {
    return random.Below(100) < percent ? exact.PointFor(random, t)
                                       : Rounded<T>(InUnitSquare(random));
  }
  Triangle<T> TriangleFor(Random& random, const Point<T>& p) const {
    return random.Below(100) < percent ? exact.TriangleFor(random, p)
                                       : DrawTriangle(random);
  }
};

// p · 2^exponent
template <class T>
Point<T> Scaled(const Point<T>& p, int exponent) {
  return {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
}

template <class T>
struct OnBoundary {
  bool at_vertex;
  // Exponents are from −half to half, but for 1.
  int half;

  static int Lower(const Point<T>& p) {
    return std::ilogb(std::min(std::abs(p.x), std::abs(p.y)));
  }
  static int Upper(const Point<T>& p) {
    return std::ilogb(std::max(std::abs(p.x), std::abs(p.y)));
  }
  static int Draw(Random& random, int low, int high) {
    return low + static_cast<int>(
                     random.Below(static_cast<std::uint64_t>(high - low) + 1));
  }
  // ±[½, 1) times a power of two.
  T Coordinate(Random& random) const {
    const double mantissa = random.In(0.5, 1);
    const double x = std::ldexp(mantissa, Draw(random, -half, half));
    // What rounds up to the next power of two leaves the range by one.
    return static_cast<T>(random.Below(2) == 0 ? x : -x);
  }
  Point<T> DrawPoint(Random& random) const {
    const T x = Coordinate(random);
    return {x, Coordinate(random)};
  }

  // Vertices with v first and −v·2^j next.
  Triangle<T> WithEdge(Random& random, const Point<T>& v) const {
    const int j = Draw(random, std::min(-half - 1 - Lower(v), 0),
                       std::max(half - Upper(v), 0));
    const Point<T> w = Scaled(v, j);
    return {v, {-w.x, -w.y}, DrawPoint(random)};
  }
  Triangle<T> DrawTriangle(Random& random) const {
    return WithEdge(random, DrawPoint(random));
  }
  Point<T> PointFor(Random& random, const Triangle<T>& t) const {
    if (at_vertex) {
      const Point<T> vertices[] = {t.a, t.b, t.c};
      return vertices[random.Below(3)];
    }
    const Point<T>& v = random.Below(2) == 0 ? t.a : t.b;
    const int k = Draw(random, 1, std::max(Lower(v) + half + 1, 1));
    return Scaled(v, -k);
  }
  Triangle<T> TriangleFor(Random& random, const Point<T>& p) const {
    const int k = at_vertex ? 0 : Draw(random, 1, std::max(half - Upper(p), 1));
    return WithEdge(random, Scaled(p, k));
  }
};

}  // namespace

template <class T>
Scene<T> OnEdgeScene(const SceneSpec& spec, Loop loop, SceneSize size,
                     std::uint64_t seed) {
  const auto percent =
      static_cast<std::uint64_t>(spec.Number("percent", 0, 100));
  return Assemble<T>(OnEdge<T>{percent}, spec, loop, size, seed);
}

// All numbers are normal, so that powers of two do multiply them exactly.
template <class T>
Scene<T> OnBoundaryScene(const SceneSpec& spec, Loop loop, SceneSize size,
                         std::uint64_t seed) {
  const bool at_vertex = spec.Word("at", {"edge", "vertex"}) == "vertex";
  const auto binades =
      static_cast<int>(spec.Number("binades", 0, sizeof(T) == 4 ? 240 : 2000));
  return Assemble<T>(OnBoundary<T>{at_vertex, binades / 2}, spec, loop, size,
                     seed);
}

#define PITBENCH_INSTANTIATE(T)                                        \
  template Scene<T> OnEdgeScene(const SceneSpec&, Loop, SceneSize,     \
                                std::uint64_t);                        \
  template Scene<T> OnBoundaryScene(const SceneSpec&, Loop, SceneSize, \
                                    std::uint64_t)
PITBENCH_INSTANTIATE(float);
PITBENCH_INSTANTIATE(double);
#undef PITBENCH_INSTANTIATE

}  // namespace pitbench
