#include "harness/truth/ray_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

#include "harness/truth/exact_distance.h"
#include "harness/truth/ray_integers.h"

namespace pitbench {
namespace {

// The exponent of an ulp of the largest coordinate.
template <class T>
int UlpOfLargest(const Triangle3<T>& triangle, const Ray<T>& ray) {
  T largest = 0;
  for (const Point3<T>& p : {triangle.a, triangle.b, triangle.c, ray.origin}) {
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  return UlpExponent<T>(std::ilogb(largest));
}

// Integers and floating-point numbers alike.
template <class Number>
using Vector = std::array<Number, 3>;

template <class Number>
Number Product(const Vector<Number>& p, const Vector<Number>& q) {
  return Number(p[0] * q[0] + p[1] * q[1] + p[2] * q[2]);
}
template <class Number>
Vector<Number> Difference(const Vector<Number>& p, const Vector<Number>& q) {
  return {Number(p[0] - q[0]), Number(p[1] - q[1]), Number(p[2] - q[2])};
}
template <class Number>
Vector<Number> CrossProduct(const Vector<Number>& p, const Vector<Number>& q) {
  return {Number(p[1] * q[2] - p[2] * q[1]), Number(p[2] * q[0] - p[0] * q[2]),
          Number(p[0] * q[1] - p[1] * q[0])};
}

// take(numerator, denominator) for the squares of all distances that count; d
// is D, `vertices` are A, B and C less O.
//
// D × p is the place of p in the plane across the ray, turned by a right angle
// and |D| times as large; the ray is 0 there. With e = B − A, the line of AB
// is |D·(A × B)| / |D × e| away from the ray's.
template <class Number, class Take>
void ForEachDistance(const Vector<Number>& d,
                     const std::array<Vector<Number>, 3>& vertices,
                     const Take& take) {
  const Number squared_d = Product(d, d);
  const Vector<Number> normal =
      CrossProduct(Difference(vertices[1], vertices[0]),
                   Difference(vertices[2], vertices[0]));
  const Number facing = Product(d, normal);
  bool inside = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector<Number>& from = vertices[k];
    const Vector<Number>& to = vertices[(k + 1) % 3];
    const Number weight = Product(d, CrossProduct(from, to));
    inside &= (weight > 0 && facing > 0) || (weight < 0 && facing < 0);
    const Vector<Number> seen_from = CrossProduct(d, from);
    const Vector<Number> seen_edge = CrossProduct(d, Difference(to, from));
    const Number length = Product(seen_edge, seen_edge);
    const Number along = -Product(seen_edge, seen_from);
    if (along <= 0) {
      take(Product(seen_from, seen_from), squared_d);
    } else if (along >= length) {
      const Vector<Number> seen_to = CrossProduct(d, to);
      take(Product(seen_to, seen_to), squared_d);
    } else {
      take(Number(weight * weight), length);
    }
  }
  if (!inside) return;
  const Number height = Product(vertices[0], normal);
  take(Number(height * height), Product(normal, normal));
}

}  // namespace

template <class T>
double AnswerDistanceInUlps(const Triangle3<T>& triangle, const Ray<T>& ray) {
  RayIntegers exact;
  exact.Take(triangle, ray);
  const std::array<mpz_class, 12>& p = exact.coordinates();
  std::array<Vector<mpz_class>, 3> vertices;
  for (std::size_t k = 0; k < 9; ++k) {
    vertices[k / 3][k % 3] = p[k] - p[9 + k % 3];
  }
  const IntegerVector d = exact.d();
  SquaredDistance least{.numerator = -1, .denominator = 1};
  ForEachDistance<mpz_class>(
      {d[0], d[1], d[2]}, vertices,
      [&](const mpz_class& numerator, const mpz_class& denominator) {
        const SquaredDistance square{numerator, denominator};
        if (least.numerator < 0 || square < least) least = square;
      });
  return ScaledRoot(least, exact.length() - UlpOfLargest(triangle, ray));
}

template <class T>
double AnswerDistanceEstimate(const Triangle3<T>& triangle, const Ray<T>& ray) {
  using Wide =
      std::conditional_t<std::is_same_v<T, double>, long double, double>;
  const auto wide = [](const Point3<T>& q) {
    return Vector<Wide>{static_cast<Wide>(q.x), static_cast<Wide>(q.y),
                        static_cast<Wide>(q.z)};
  };
  const Vector<Wide> origin = wide(ray.origin);
  const auto seen = [&](const Point3<T>& q) {
    return Difference(wide(q), origin);
  };
  Wide least = std::numeric_limits<Wide>::infinity();
  ForEachDistance<Wide>(wide(ray.direction),
                        {seen(triangle.a), seen(triangle.b), seen(triangle.c)},
                        [&](Wide numerator, Wide denominator) {
                          least = std::min(least, numerator / denominator);
                        });
  return static_cast<double>(
      std::ldexp(std::sqrt(least), -UlpOfLargest(triangle, ray)));
}

#define PITBENCH_INSTANTIATE(T)                                             \
  template double AnswerDistanceInUlps(const Triangle3<T>&, const Ray<T>&); \
  template double AnswerDistanceEstimate(const Triangle3<T>&, const Ray<T>&)
PITBENCH_INSTANTIATE(float);
PITBENCH_INSTANTIATE(double);
#undef PITBENCH_INSTANTIATE

}  // namespace pitbench
