// Coordinates as integers that share one power of two.
//
// Every finite float, double and int32 is an integer times a power of two.
// Brought to the smallest power among them, a set of coordinates becomes a set
// of integers, and GMP's integer arithmetic on those is exact, cannot overflow
// or underflow, and is several times faster than its rational arithmetic.
#ifndef PITBENCH_HARNESS_TRUTH_SCALED_INTEGERS_H_
#define PITBENCH_HARNESS_TRUTH_SCALED_INTEGERS_H_

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>

namespace pitbench {

// The number mantissa · 2^exponent.
struct Dyadic {
  std::int64_t mantissa;
  int exponent;
};

// A finite double as it is stored: 52 bits of fraction below 11 of exponent
// and the sign. Exponent field 0 (subnormal) means the same power as field 1,
// without the leading one.
inline Dyadic Split(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const auto fraction = static_cast<std::int64_t>(bits & ((1ULL << 52) - 1));
  const int field = static_cast<int>((bits >> 52) & 0x7FF);
  const std::int64_t magnitude =
      field == 0 ? fraction : fraction | (std::int64_t{1} << 52);
  return {.mantissa = (bits >> 63) != 0 ? -magnitude : magnitude,
          .exponent = std::max(field, 1) - 1075};
}

inline Dyadic Split(std::int32_t value) {
  return {.mantissa = value, .exponent = 0};
}

// Sets integers[i] such that values[i] = integers[i] · 2^e, and returns e.
// The values are finite. Allocates nothing once the integers have grown to the
// size that the values need.
template <class T, std::size_t N>
int ScaleToIntegers(const std::array<T, N>& values,
                    std::array<mpz_class, N>& integers) {
  static_assert(sizeof(long) == sizeof(std::int64_t));  // for mpz_set_si
  using Splittable =
      std::conditional_t<std::floating_point<T>, double, std::int32_t>;
  std::array<Dyadic, N> parts;
  int smallest = 0;
  bool any = false;
  for (std::size_t i = 0; i < N; ++i) {
    parts[i] = Split(static_cast<Splittable>(values[i]));
    if (parts[i].mantissa == 0) continue;
    smallest = any ? std::min(smallest, parts[i].exponent) : parts[i].exponent;
    any = true;
  }
  for (std::size_t i = 0; i < N; ++i) {
    mpz_set_si(integers[i].get_mpz_t(), parts[i].mantissa);
    if (parts[i].mantissa == 0 || parts[i].exponent == smallest) continue;
    mpz_mul_2exp(integers[i].get_mpz_t(), integers[i].get_mpz_t(),
                 static_cast<mp_bitcnt_t>(parts[i].exponent - smallest));
  }
  return smallest;
}

// q · 2^exponent.
inline mpq_class Scaled(const mpq_class& q, int exponent) {
  mpq_class scaled;
  if (exponent >= 0) {
    mpq_mul_2exp(scaled.get_mpq_t(), q.get_mpq_t(),
                 static_cast<mp_bitcnt_t>(exponent));
  } else {
    mpq_div_2exp(scaled.get_mpq_t(), q.get_mpq_t(),
                 static_cast<mp_bitcnt_t>(-exponent));
  }
  return scaled;
}

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_TRUTH_SCALED_INTEGERS_H_
