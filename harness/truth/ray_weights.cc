// t, u and v of a ray, and how near to the limits they are; all by GMP.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "harness/truth/ray_integers.h"
#include "harness/truth/ray_truth.h"

namespace pitbench {
namespace {

mpq_class Quotient(const mpz_class& numerator, const mpz_class& denominator) {
  mpq_class quotient(numerator, denominator);
  quotient.canonicalize();
  return quotient;
}

mpz_class Dot(IntegerVector p, IntegerVector q) {
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}

template <class Numbers>
mpz_class LargestMagnitude(const Numbers& numbers) {
  mpz_class largest = 0;
  for (const mpz_class& number : numbers) {
    if (mpz_cmpabs(number.get_mpz_t(), largest.get_mpz_t()) > 0)
      largest = abs(number);
  }
  return largest;
}

}  // namespace

template <class T>
std::array<mpq_class, 3> ExactTuv(const Triangle3<T>& triangle,
                                  const Ray<T>& ray) {
  thread_local RayIntegers exact;
  exact.Take(triangle, ray);
  const mpz_class facing = exact.Facing();
  return {Scaled(Quotient(exact.Height(), facing),
                 exact.length() - exact.direction()),
          Quotient(exact.Weight(1), facing), Quotient(exact.Weight(2), facing)};
}

template <class T>
double EdgeDistanceInUlps(const Triangle3<T>& triangle, const Ray<T>& ray) {
  const auto [t, u, v] = ExactTuv(triangle, ray);
  const mpq_class least =
      std::min<mpq_class>({abs(u), abs(v), abs(mpq_class(1 - u - v))});
  return Scaled(least, std::numeric_limits<T>::digits - 1).get_d();
}

// As the header has it, with w = W / facing, N = e × f, h = |N| / L and
// sin = |facing| / (|N| |D|). Multiplied out and squared, the comparisons need
// neither division nor root:
//   weights   W² N² ≤ (slack·u)² M⁴ L⁴ D²
//   an end    (height − end · facing)² ≤ (slack·u)² M⁴ L²
template <class T>
bool RoundingMayDecide(const Triangle3<T>& triangle, const Ray<T>& ray,
                       double slack) {
  thread_local RayIntegers exact;
  exact.Take(triangle, ray);
  const mpz_class facing = exact.Facing();
  const mpz_class squared_d = Dot(exact.d(), exact.d());
  if (squared_d == 0) return false;
  if (facing == 0) return true;
  const mpz_class height = exact.Height();

  mpz_class squared_normal = 0;
  std::array<mpz_class, 3> third;
  for (std::size_t k = 0; k < 3; ++k) {
    const mpz_class& component = exact.Normal(k);
    squared_normal += component * component;
    third[k] = exact.f()[k] - exact.e()[k];
  }
  const mpz_class longest =
      std::max<mpz_class>({Dot(exact.e(), exact.e()), Dot(exact.f(), exact.f()),
                           Dot(third, third)});
  const mpq_class reach = Quotient(abs(height) * LargestMagnitude(exact.d()),
                                   mpz_class(abs(facing)));
  const mpq_class size = std::max<mpq_class>(
      mpq_class(LargestMagnitude(exact.coordinates())), reach);
  const mpq_class rounding =
      Scaled(mpq_class(slack), -std::numeric_limits<T>::digits) * size * size;
  const mpq_class allowed = rounding * rounding * longest;

  mpz_class smallest = abs(exact.Weight(0));
  for (const std::size_t k : {1, 2}) {
    const mpz_class& weight = exact.Weight(k);
    if (mpz_cmpabs(weight.get_mpz_t(), smallest.get_mpz_t()) < 0)
      smallest = abs(weight);
  }
  if (smallest * smallest * squared_normal <= allowed * longest * squared_d) {
    return true;
  }
  for (const T end : {ray.t_min, ray.t_max}) {
    if (std::isinf(end)) continue;
    const mpq_class off = height - Scaled(mpq_class(static_cast<double>(end)),
                                          exact.direction() - exact.length()) *
                                       facing;
    if (off * off <= allowed) return true;
  }
  return false;
}

#define PITBENCH_INSTANTIATE(T)                                           \
  template std::array<mpq_class, 3> ExactTuv(const Triangle3<T>&,         \
                                             const Ray<T>&);              \
  template double EdgeDistanceInUlps(const Triangle3<T>&, const Ray<T>&); \
  template bool RoundingMayDecide(const Triangle3<T>&, const Ray<T>&, double)
PITBENCH_INSTANTIATE(float);
PITBENCH_INSTANTIATE(double);
#undef PITBENCH_INSTANTIATE

}  // namespace pitbench
