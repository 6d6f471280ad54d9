// Edges that have points exactly on them.
//
// Vertices are multiples of 2^-10 and a point is a whole number of sixteenths
// of the edge along it, so a multiple of 2^-14. All such numbers up to 2^10
// are numbers of f32, and nothing on the way to them is rounded.
#ifndef PITBENCH_HARNESS_SCENES_EXACT_EDGE_H_
#define PITBENCH_HARNESS_SCENES_EXACT_EDGE_H_

#include <cmath>

#include "harness/scenes/families.h"
#include "harness/scenes/step.h"

namespace pitbench {

inline constexpr int kVertexBits = 10;
inline constexpr int kShareBits = 4;
inline constexpr int kPointBits = kVertexBits + kShareBits;

// A share of an edge in [low, high), rounded down to sixteenths.
inline double ExactShare(Random& random, double low, double high) {
  return OnGrid(random.In(low, high), kShareBits);
}

inline Point<double> OnGrid(const Point<double>& p, int bits) {
  return {OnGrid(p.x, bits), OnGrid(p.y, bits)};
}

template <class T>
bool IsOnGrid(const Point<T>& p, int bits) {
  const Point<double> at{static_cast<double>(p.x), static_cast<double>(p.y)};
  const Point<double> rounded = OnGrid(at, bits);
  return rounded.x == at.x && rounded.y == at.y;
}

// A triangle of this shape on which the point `aim` is, that share of the edge
// from a to b along it, up to rounding; any of its vertices is the first.
template <class T>
Triangle<T> ShapeThrough(Random& random, const Triangle<double>& shape,
                         double share, const Point<T>& aim) {
  const double ex = shape.b.x - shape.a.x;
  const double ey = shape.b.y - shape.a.y;
  const Point<double> a{static_cast<double>(aim.x) - share * ex,
                        static_cast<double>(aim.y) - share * ey};
  const Point<T> vertices[] = {
      Rounded<T>(a), Rounded<T>(Point<double>{a.x + ex, a.y + ey}),
      Rounded<T>(Point<double>{a.x + (shape.c.x - shape.a.x),
                               a.y + (shape.c.y - shape.a.y)})};
  const std::size_t first = random.Below(3);
  return {vertices[first], vertices[(first + 1) % 3],
          vertices[(first + 2) % 3]};
}

// Well-shaped triangles in the unit square, and points exactly on their edges;
// every sixteenth of them is a vertex.
template <class T>
struct ExactEdge {
  static Triangle<double> Shape(Random& random) {
    const Triangle<double> t = WellShaped(random);
    return {OnGrid(t.a, kVertexBits), OnGrid(t.b, kVertexBits),
            OnGrid(t.c, kVertexBits)};
  }
  static bool Has(const Triangle<T>& t) {
    return IsOnGrid(t.a, kVertexBits) && IsOnGrid(t.b, kVertexBits) &&
           IsOnGrid(t.c, kVertexBits);
  }
  static bool Has(const Point<T>& p) { return IsOnGrid(p, kPointBits); }

  Triangle<T> DrawTriangle(Random& random) const {
    return Rounded<T>(Shape(random));
  }
  Point<T> DrawPoint(Random& random) const {
    return Rounded<T>(OnGrid(InUnitSquare(random), kPointBits));
  }
  // Of a triangle that this has drawn.
  Point<T> PointFor(Random& random, const Triangle<T>& t) const {
    const Point<T> vertices[] = {t.a, t.b, t.c};
    const std::size_t k = random.Below(3);
    return BesideEdge(vertices[k], vertices[(k + 1) % 3],
                      ExactShare(random, 0, 1), 0);
  }
  // Of a point that this has drawn.
  Triangle<T> TriangleFor(Random& random, const Point<T>& p) const {
    const Triangle<double> shape = Shape(random);
    return ShapeThrough(random, shape, ExactShare(random, 0, 1), p);
  }
};

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_SCENES_EXACT_EDGE_H_
