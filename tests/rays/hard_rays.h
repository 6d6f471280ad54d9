// Rays and triangles that are hard to decide, and the answer by GMP's rational
// arithmetic, by formulas that are not those of the kernels.
#ifndef PITBENCH_TESTS_RAYS_HARD_RAYS_H_
#define PITBENCH_TESTS_RAYS_HARD_RAYS_H_

#include <gmpxx.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "harness/scenes/random.h"
#include "harness/truth/ray_truth.h"

namespace pitbench {

// Where the line of a ray meets the plane of a triangle.
struct RationalCrossing {
  bool parallel;
  mpq_class t, u, v;
};

using RationalVector = std::array<mpq_class, 3>;

template <class T>
RationalVector Rational(const Point3<T>& p) {
  return {mpq_class(static_cast<double>(p.x)),
          mpq_class(static_cast<double>(p.y)),
          mpq_class(static_cast<double>(p.z))};
}

inline mpq_class Determinant(const RationalVector& a, const RationalVector& b,
                             const RationalVector& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) -
         a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

// Solves u·(B − A) + v·(C − A) − t·D = O − A by Cramer's rule.
template <class T>
RationalCrossing CrossingOf(const Triangle3<T>& triangle,
                            const RationalVector& origin,
                            const RationalVector& direction) {
  const RationalVector a = Rational(triangle.a);
  RationalVector e1 = Rational(triangle.b);
  RationalVector e2 = Rational(triangle.c);
  RationalVector s = origin;
  RationalVector back = direction;
  for (std::size_t k = 0; k < 3; ++k) {
    e1[k] -= a[k];
    e2[k] -= a[k];
    s[k] -= a[k];
    back[k] = -back[k];
  }
  const mpq_class det = Determinant(e1, e2, back);
  if (det == 0) return {.parallel = true, .t = 0, .u = 0, .v = 0};
  return {.parallel = false,
          .t = Determinant(e1, e2, s) / det,
          .u = Determinant(s, e2, back) / det,
          .v = Determinant(e1, s, back) / det};
}
template <class T>
RationalCrossing CrossingOf(const Triangle3<T>& triangle, const Ray<T>& ray) {
  return CrossingOf(triangle, Rational(ray.origin), Rational(ray.direction));
}

template <class T>
bool InRange(const mpq_class& t, const Ray<T>& ray) {
  return t >= mpq_class(static_cast<double>(ray.t_min)) &&
         (ray.t_max == std::numeric_limits<T>::infinity() ||
          t <= mpq_class(static_cast<double>(ray.t_max)));
}

template <class T>
bool HitsByRationals(const Triangle3<T>& triangle, const Ray<T>& ray) {
  const RationalCrossing at = CrossingOf(triangle, ray);
  return !at.parallel && at.u >= 0 && at.v >= 0 && at.u + at.v <= 1 &&
         InRange(at.t, ray);
}

// Draws triangles and rays aimed at their edges, their vertices and the ends of
// the range of t, a few units in the last place beside them; of numbers of one
// size, of very different ones, whole, subnormal, or near overflow.
template <class T>
class HardRays {
 public:
  explicit HardRays(std::uint64_t seed) : random_(seed) {}

  struct Item {
    Triangle3<T> triangle;
    Ray<T> ray;
  };

  Item Draw() {
    constexpr int kMost = std::numeric_limits<T>::max_exponent - 2;
    constexpr int kLeast = std::numeric_limits<T>::min_exponent;
    const std::uint64_t kind = random_.Below(8);
    whole_ = kind == 0;
    spread_ = kind == 1 ? kMost - kLeast : kind == 2 ? 40 : 0;
    most_ = kind == 3   ? kLeast + 4
            : kind == 4 ? kMost
            : kind == 5 ? kMost / 3 + 1
            : kind == 6 ? kLeast / 3 - static_cast<int>(random_.Below(8))
            : kind == 1 ? kMost
                        : 1;
    const Point3<T> a = DrawPoint();
    const Point3<T> b = DrawPoint();
    Triangle3<T> triangle{a, b, DrawPoint()};
    if (random_.Below(64) == 0) triangle.c = triangle.a;
    return DrawRayFor(triangle);
  }

  // Of the kind that was drawn last.
  Item DrawRayFor(const Triangle3<T>& triangle) {
    const Point3<T> origin =
        random_.Below(8) == 0 ? InPlane(triangle) : DrawPoint();
    const Point3<T> target = InPlane(triangle);
    const Point3<T> direction{Nudged(Less(target.x, origin.x)),
                              Nudged(Less(target.y, origin.y)),
                              Nudged(Less(target.z, origin.z))};
    const T start = DrawStart();
    return {triangle, {origin, direction, start, DrawEnd()}};
  }

  // One with an edge across the ray at t = 1, or the last one beginning with
  // another vertex.
  Item DrawTriangleFor(const Ray<T>& ray) {
    if (random_.Below(4) == 0) {
      last_ = {last_.b, last_.c, last_.a};
      return {last_, ray};
    }
    const Point3<T> a = DrawPoint();
    const auto beyond = [&](T from, T along, T vertex) {
      const T b = 2 * (from + along) - vertex;
      return std::isfinite(b) ? Nudged(b) : DrawNumber();
    };
    const Point3<T> b{beyond(ray.origin.x, ray.direction.x, a.x),
                      beyond(ray.origin.y, ray.direction.y, a.y),
                      beyond(ray.origin.z, ray.direction.z, a.z)};
    last_ = {a, b, DrawPoint()};
    return {last_, ray};
  }

 private:
  T DrawNumber() {
    if (whole_) return static_cast<T>(static_cast<int>(random_.Below(9)) - 4);
    const int below = spread_ == 0 ? 0
                                   : static_cast<int>(random_.Below(
                                         static_cast<std::uint64_t>(spread_)));
    return static_cast<T>(
        std::ldexp(random_.Unit() * 2 - 1, std::max(most_ - below, -1100)));
  }
  Point3<T> DrawPoint() {
    const T x = DrawNumber();
    const T y = DrawNumber();
    return {x, y, DrawNumber()};
  }

  // A point of an edge, a vertex, or one inside or beside, as it rounds.
  Point3<T> InPlane(const Triangle3<T>& t) {
    double u = random_.Unit() * 1.25 - 0.125;
    double v = random_.Unit() * 1.25 - 0.125;
    if (whole_) u = std::round(u * 4) / 4;
    switch (random_.Below(6)) {
      case 0:
        v = 0;
        break;
      case 1:
        u = 0;
        break;
      case 2:
        v = 1 - u;
        break;
      case 3:
        return random_.Below(2) == 0 ? t.a : t.b;
      default:
        break;
    }
    const auto at = [&](T a, T b, T c) {
      return static_cast<T>((1 - u - v) * a + u * b + v * c);
    };
    return {at(t.a.x, t.b.x, t.c.x), at(t.a.y, t.b.y, t.c.y),
            at(t.a.z, t.b.z, t.c.z)};
  }

  static T Less(T x, T y) {
    const T difference = x - y;
    return std::isfinite(difference) ? difference : x / 2 - y / 2;
  }

  T Nudged(T x) {
    if (random_.Below(2) == 0) return x;
    constexpr T kInfinity = std::numeric_limits<T>::infinity();
    const T towards = random_.Below(2) == 0 ? kInfinity : -kInfinity;
    for (std::uint64_t ulps = random_.Below(5); ulps != 0; --ulps) {
      const T next = std::nextafter(x, towards);
      if (std::isfinite(next)) x = next;
    }
    return x;
  }

  // The target is at t = 1, near enough.
  T DrawStart() {
    switch (random_.Below(6)) {
      case 0:
        return Nudged(1);
      case 1:
        return std::numeric_limits<T>::lowest();
      case 2:
        return -1;
      default:
        return 0;
    }
  }
  T DrawEnd() {
    switch (random_.Below(6)) {
      case 0:
        return Nudged(1);
      case 1:
        return std::numeric_limits<T>::max();
      case 2:
        return 3;
      default:
        return std::numeric_limits<T>::infinity();
    }
  }

  Random random_;
  Triangle3<T> last_ = {};
  bool whole_ = false;
  int spread_ = 0;  // exponents are from most_ − spread_ to most_
  int most_ = 0;
};

}  // namespace pitbench

#endif  // PITBENCH_TESTS_RAYS_HARD_RAYS_H_
