#include "harness/truth/weights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "harness/truth/exact_distance.h"
#include "harness/truth/scaled_integers.h"

namespace pitbench {
namespace {

struct ExactPoint {
  mpz_class x;
  mpz_class y;
};

ExactPoint operator-(const ExactPoint& p, const ExactPoint& q) {
  return {.x = p.x - q.x, .y = p.y - q.y};
}

mpz_class Cross(const ExactPoint& p, const ExactPoint& q) {
  return p.x * q.y - p.y * q.x;
}

mpz_class Dot(const ExactPoint& p, const ExactPoint& q) {
  return p.x * q.x + p.y * q.y;
}

// Triangle and point in units of 2^exponent.
struct ExactCase {
  std::array<ExactPoint, 3> vertices;
  ExactPoint p;
  int exponent;
};

template <class T>
ExactCase ToIntegers(const Triangle<T>& triangle, const Point<T>& p) {
  const auto& [a, b, c] = triangle;
  std::array<mpz_class, 8> z;
  const int exponent =
      ScaleToIntegers<T, 8>({a.x, a.y, b.x, b.y, c.x, c.y, p.x, p.y}, z);
  return {.vertices = {{{z[0], z[1]}, {z[2], z[3]}, {z[4], z[5]}}},
          .p = {z[6], z[7]},
          .exponent = exponent};
}

mpz_class TwiceArea(const ExactCase& exact) {
  const auto& [a, b, c] = exact.vertices;
  return Cross(b - a, c - a);
}

// The weight of vertex k times TwiceArea: the edge opposite to it seen from p.
mpz_class EdgeFunction(const ExactCase& exact, std::size_t k) {
  return Cross(exact.vertices[(k + 1) % 3] - exact.p,
               exact.vertices[(k + 2) % 3] - exact.p);
}

// ⌊log2 q⌋ for q > 0.
int FloorLog2(const mpq_class& q) {
  const auto bits = [](const mpz_class& z) {
    return static_cast<int>(mpz_sizeinbase(z.get_mpz_t(), 2));
  };
  // q lies between 2^(guess−1) and 2^(guess+1).
  const int guess = bits(q.get_num()) - bits(q.get_den());
  return Scaled(q, -guess) < 1 ? guess - 1 : guess;
}

// From p to the closed segment ab; a = b is allowed.
SquaredDistance FromSegment(const ExactPoint& a, const ExactPoint& b,
                            const ExactPoint& p) {
  const ExactPoint edge = b - a;
  const ExactPoint to_p = p - a;
  const mpz_class along = Dot(edge, to_p);
  const mpz_class length = Dot(edge, edge);
  if (along <= 0) return {.numerator = Dot(to_p, to_p), .denominator = 1};
  if (along >= length) {
    const ExactPoint from_b = p - b;
    return {.numerator = Dot(from_b, from_b), .denominator = 1};
  }
  const mpz_class cross = Cross(edge, to_p);
  return {.numerator = cross * cross, .denominator = length};
}

}  // namespace

template <class T>
std::array<mpq_class, 3> ExactWeights(const Triangle<T>& triangle,
                                      const Point<T>& p) {
  const ExactCase exact = ToIntegers(triangle, p);
  const mpz_class area = TwiceArea(exact);
  std::array<mpq_class, 3> weights;
  for (std::size_t k = 0; k < 3; ++k) {
    weights[k] = mpq_class(EdgeFunction(exact, k), area);
    weights[k].canonicalize();
  }
  return weights;
}

template <class T>
double UlpError(T computed, const mpq_class& exact) {
  if (!std::isfinite(computed)) return std::numeric_limits<double>::infinity();
  const int log2 = exact == 0 ? std::numeric_limits<T>::min_exponent - 1
                              : FloorLog2(abs(exact));
  const mpq_class error = abs(mpq_class(static_cast<double>(computed)) - exact);
  return Scaled(error, -UlpExponent<T>(log2)).get_d();
}

template <class T>
double BoundaryDistanceInUlps(const Triangle<T>& triangle, const Point<T>& p) {
  const ExactCase exact = ToIntegers(triangle, p);
  const auto& [a, b, c] = exact.vertices;
  const SquaredDistance nearest =
      std::min({FromSegment(a, b, exact.p), FromSegment(b, c, exact.p),
                FromSegment(c, a, exact.p)});
  int ulp_exponent = 0;
  if constexpr (std::floating_point<T>) {
    const T largest = std::max(std::abs(p.x), std::abs(p.y));
    ulp_exponent =
        UlpExponent<T>(largest == 0 ? std::numeric_limits<T>::min_exponent - 1
                                    : std::ilogb(largest));
  }
  return ScaledRoot(nearest, exact.exponent - ulp_exponent);
}

template <class T>
bool RoundingMayDecide(const Triangle<T>& triangle, const Point<T>& p,
                       double slack) {
  if constexpr (std::integral<T>) {
    return false;
  } else {
    const ExactCase exact = ToIntegers(triangle, p);
    const auto& [a, b, c] = exact.vertices;
    mpz_class smallest = abs(EdgeFunction(exact, 0));
    for (const std::size_t k : {1, 2}) {
      smallest = std::min<mpz_class>(smallest, abs(EdgeFunction(exact, k)));
    }
    mpz_class largest = 0;
    for (const ExactPoint* q : {&a, &b, &c, &exact.p}) {
      largest = std::max<mpz_class>({largest, abs(q->x), abs(q->y)});
    }
    const mpz_class longest =
        std::max({Dot(b - a, b - a), Dot(c - b, c - b), Dot(a - c, a - c)});
    // |w| = |E| / |D| and h² = D² / L², with D twice the area and L the
    // longest edge; multiplied by D², the comparison needs no division:
    // |E| |D| ≤ slack · u · M² L².
    const mpz_class area = TwiceArea(exact);
    const mpq_class bound =
        Scaled(mpq_class(slack), -std::numeric_limits<T>::digits) *
        (largest * largest * longest);
    return smallest * abs(area) <= bound;
  }
}

#define PITBENCH_INSTANTIATE(T)                                                \
  template std::array<mpq_class, 3> ExactWeights(const Triangle<T>&,           \
                                                 const Point<T>&);             \
  template double BoundaryDistanceInUlps(const Triangle<T>&, const Point<T>&); \
  template bool RoundingMayDecide(const Triangle<T>&, const Point<T>&, double);
PITBENCH_INSTANTIATE(float)
PITBENCH_INSTANTIATE(double)
PITBENCH_INSTANTIATE(std::int32_t)
PITBENCH_INSTANTIATE(std::int16_t)
PITBENCH_INSTANTIATE(std::uint8_t)
#undef PITBENCH_INSTANTIATE
template double UlpError(float, const mpq_class&);
template double UlpError(double, const mpq_class&);

}  // namespace pitbench
