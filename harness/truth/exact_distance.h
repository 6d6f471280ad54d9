// Distances of points of integer coordinates: compared exactly, as squares, and
// rounded once, in ulps.
#ifndef PITBENCH_HARNESS_TRUTH_EXACT_DISTANCE_H_
#define PITBENCH_HARNESS_TRUTH_EXACT_DISTANCE_H_

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pitbench {

// The exponent of T's ulp at numbers from 2^log2 to 2^(log2+1).
template <class T>
int UlpExponent(int log2) {
  using Limits = std::numeric_limits<T>;
  return std::max(log2, Limits::min_exponent - 1) - (Limits::digits - 1);
}

// The square of a distance as a fraction, denominator > 0.
struct SquaredDistance {
  mpz_class numerator;
  mpz_class denominator;

  bool operator<(const SquaredDistance& other) const {
    return numerator * other.denominator < other.numerator * denominator;
  }
};

// sqrt(square) · 2^exponent, rounded down to 63 bits or more and then to
// double; a result that double can hold is reached without passing through
// one that it cannot.
inline double ScaledRoot(const SquaredDistance& square, int exponent) {
  if (square.numerator == 0) return 0;
  const auto bits = [](const mpz_class& z) {
    return static_cast<int>(mpz_sizeinbase(z.get_mpz_t(), 2));
  };
  // Scale the quotient by 4^half so that it has 127 bits or more.
  const int missing = 128 - bits(square.numerator) + bits(square.denominator);
  const int half = std::max(0, (missing + 1) / 2);
  mpz_class root = (square.numerator << static_cast<mp_bitcnt_t>(2 * half)) /
                   square.denominator;
  root = sqrt(root);
  long root_exponent = 0;
  const double mantissa = mpz_get_d_2exp(&root_exponent, root.get_mpz_t());
  return std::ldexp(mantissa,
                    static_cast<int>(root_exponent) - half + exponent);
}

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_TRUTH_EXACT_DISTANCE_H_
