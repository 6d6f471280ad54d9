#include "harness/truth/orientation.h"

#include <gmpxx.h>

#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>

#include "harness/truth/scaled_integers.h"

namespace pitbench {
namespace {

// The sign of (bx − ax)(cy − ay) − (by − ay)(cx − ax), or nothing where
// rounding could decide it.
//
// The bound. u = 2^-53, η = 2^-1075 (half the smallest subnormal). A rounded
// difference is the true one times (1+δ), |δ| ≤ u: sums never underflow. So
// the rounded product is l = L(1+δ1)(1+δ2)(1+δ3) + e with |e| ≤ η, where L is
// the exact one; solved for L:
//   |L − l| ≤ (|l| + η)((1−u)^-3 − 1) + η ≤ (3u + 7u²)|l| + 2η.
// With the same for r and S = |l| + |r|:
//   |(L − R) − (l − r)| ≤ (3u + 7u²) S + 4η,
// and L − R has the sign of l − r, which is also that of det = fl(l − r), if
// |l − r| is greater than the right side. The code asks for
//   |det| > fl(fl(4u · fl(S)) + 2^-1022).
// Each fl costs at most a factor 1 − u, and the scaling by 4u at most η, so
//   |l − r| ≥ |det|/(1+u) > (4u S(1−u) − η + 2^-1022)(1−u)/(1+u)
//           > 4u(1 − 4u) S + 2^-1023 > (3u + 7u²) S + 4η.
// Overflow: an infinite difference, product or S makes the bound infinite or
// the comparison one with NaN, and either is false.
//
// The worst known wrong sign has |det| = 2.9999999u S, and without 2^-1022
// there are wrong signs at any S that small: truth_worst_inputs_test.cc.
// (Shewchuk 1997 has 3u + 16u² and Ozaki et al. 2016 a tighter one still; the
// part of all points that they decide and 4u leaves is too small to matter.)
//
// Needs -ffp-contract=off and gradual underflow (no flush to zero).
std::optional<int> FilteredSign(double ax, double ay, double bx, double by,
                                double cx, double cy) {
  constexpr double k4u = 2 * std::numeric_limits<double>::epsilon();
  const double left = (bx - ax) * (cy - ay);
  const double right = (by - ay) * (cx - ax);
  const double det = left - right;
  const double bound = k4u * (std::abs(left) + std::abs(right)) +
                       std::numeric_limits<double>::min();
  if (det > bound) return 1;
  if (-det > bound) return -1;
  return std::nullopt;
}

__extension__ using Int128 = __int128;

}  // namespace

// x and y are scaled apart: that multiplies the determinant by a power of two,
// which leaves its sign, and keeps the integers short where the triangle lies
// at (2^500, 2^-500).
template <class T>
int OrientationExactly(const Point<T>& a, const Point<T>& b,
                       const Point<T>& c) {
  struct Scratch {
    std::array<mpz_class, 3> x;
    std::array<mpz_class, 3> y;
    mpz_class left;
    mpz_class right;
  };
  thread_local Scratch s;
  ScaleToIntegers<T, 3>({a.x, b.x, c.x}, s.x);
  ScaleToIntegers<T, 3>({a.y, b.y, c.y}, s.y);
  s.x[1] -= s.x[0];
  s.x[2] -= s.x[0];
  s.y[1] -= s.y[0];
  s.y[2] -= s.y[0];
  s.left = s.x[1] * s.y[2];
  s.right = s.y[1] * s.x[2];
  const int order = cmp(s.left, s.right);
  return (order > 0) - (order < 0);
}

template <class T>
int Orientation(const Point<T>& a, const Point<T>& b, const Point<T>& c) {
  if constexpr (std::integral<T>) {
    // Differences of int32 have 33 bits, their products 66; of int16 17 and 34.
    using Wide = std::conditional_t<(sizeof(T) < 4), std::int64_t, Int128>;
    const auto difference = [](T p, T q) { return Wide{p} - Wide{q}; };
    const Wide left = difference(b.x, a.x) * difference(c.y, a.y);
    const Wide right = difference(b.y, a.y) * difference(c.x, a.x);
    return (left > right) - (left < right);
  } else if constexpr (std::same_as<T, mpq_class>) {
    const int order = cmp((b.x - a.x) * (c.y - a.y), (b.y - a.y) * (c.x - a.x));
    return (order > 0) - (order < 0);
  } else {
    const std::optional<int> sign = FilteredSign(a.x, a.y, b.x, b.y, c.x, c.y);
    return sign ? *sign : OrientationExactly(a, b, c);
  }
}

template int Orientation(const Point<float>&, const Point<float>&,
                         const Point<float>&);
template int Orientation(const Point<double>&, const Point<double>&,
                         const Point<double>&);
template int Orientation(const Point<std::int32_t>&, const Point<std::int32_t>&,
                         const Point<std::int32_t>&);
template int Orientation(const Point<std::int16_t>&, const Point<std::int16_t>&,
                         const Point<std::int16_t>&);
template int Orientation(const Point<std::uint8_t>&, const Point<std::uint8_t>&,
                         const Point<std::uint8_t>&);
template int Orientation(const Point<mpq_class>&, const Point<mpq_class>&,
                         const Point<mpq_class>&);
template int OrientationExactly(const Point<float>&, const Point<float>&,
                                const Point<float>&);
template int OrientationExactly(const Point<double>&, const Point<double>&,
                                const Point<double>&);
template int OrientationExactly(const Point<std::int32_t>&,
                                const Point<std::int32_t>&,
                                const Point<std::int32_t>&);
template int OrientationExactly(const Point<std::int16_t>&,
                                const Point<std::int16_t>&,
                                const Point<std::int16_t>&);
template int OrientationExactly(const Point<std::uint8_t>&,
                                const Point<std::uint8_t>&,
                                const Point<std::uint8_t>&);

}  // namespace pitbench
