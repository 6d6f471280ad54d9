#include "kernels/exact/contains.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace pitbench {
namespace {

__extension__ using Int128 = __int128;
__extension__ using Uint128 = unsigned __int128;

// The number mantissa · 2^exponent, |mantissa| < 2^53.
struct Dyadic {
  std::int64_t mantissa;
  int exponent;
};

Dyadic Split(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const auto fraction = static_cast<std::int64_t>(bits & ((1ULL << 52) - 1));
  const int field = static_cast<int>((bits >> 52) & 0x7FF);
  const std::int64_t magnitude =
      field == 0 ? fraction : fraction | (std::int64_t{1} << 52);
  return {(bits >> 63) != 0 ? -magnitude : magnitude,
          std::max(field, 1) - 1075};
}

// A sum of products of two doubles, as a whole number of 2^lowest: a two's
// complement number of 64-bit words, the lowest first, with no more of them
// than the exponents of the terms need.
class Sum {
 public:
  // `lowest` and `highest` bound the exponents of the terms; there may be eight
  // of them, each below 2^106 before its power.
  Sum(int lowest, int highest)
      : lowest_(lowest), words_((highest - lowest + 106 + 4) / 64 + 1) {
    std::fill_n(word_, words_ + 2, 0);
  }

  void Add(Dyadic x, Dyadic y) { Add(x, y, false); }
  void Subtract(Dyadic x, Dyadic y) { Add(x, y, true); }

  int Sign() const {
    if (word_[words_ - 1] >> 63 != 0) return -1;
    for (int i = 0; i < words_; ++i) {
      if (word_[i] != 0) return 1;
    }
    return 0;
  }

 private:
  // Products of doubles have exponents from 2·−1074 to 2·971.
  static constexpr int kMostWords = (2 * (971 + 1074) + 106 + 4) / 64 + 1;

  void Add(Dyadic x, Dyadic y, bool negate) {
    const std::int64_t factor = negate ? -x.mantissa : x.mantissa;
    const Int128 product = static_cast<Int128>(factor) * y.mantissa;
    if (product == 0) return;  // its exponent says nothing
    const int place = x.exponent + y.exponent - lowest_;
    const int shift = place % 64;
    int i = place / 64;
    // product · 2^shift as three words and the sign in all above.
    const auto low = static_cast<Uint128>(product) << shift;
    const auto sign = static_cast<std::uint64_t>(product < 0 ? -1 : 0);
    const auto high = static_cast<std::uint64_t>(
        shift == 0 ? (product < 0 ? -1 : 0) : product >> (128 - shift));
    Uint128 carry =
        static_cast<Uint128>(word_[i]) + static_cast<std::uint64_t>(low);
    word_[i] = static_cast<std::uint64_t>(carry);
    carry =
        (carry >> 64) + word_[i + 1] + static_cast<std::uint64_t>(low >> 64);
    word_[i + 1] = static_cast<std::uint64_t>(carry);
    carry = (carry >> 64) + word_[i + 2] + high;
    word_[i + 2] = static_cast<std::uint64_t>(carry);
    for (i += 3; i < words_; ++i) {
      carry = (carry >> 64) + word_[i] + sign;
      word_[i] = static_cast<std::uint64_t>(carry);
    }
  }

  int lowest_;
  int words_;
  // Two more than are counted: where a product's three words begin is checked
  // by nobody, and what lies above the last is only its sign.
  std::uint64_t word_[kMostWords + 2];
};

struct Range {
  int lowest = 0;
  int highest = 0;
};

// The exponents of three numbers, zeros left out.
Range ExponentsOf(const Dyadic (&values)[3]) {
  Range range;
  bool any = false;
  for (const Dyadic& value : values) {
    if (value.mantissa == 0) continue;
    range.lowest =
        any ? std::min(range.lowest, value.exponent) : value.exponent;
    range.highest =
        any ? std::max(range.highest, value.exponent) : value.exponent;
    any = true;
  }
  return range;
}

// The sign of the area by integers: the determinant multiplied out, in which
// x and y have exponents of their own.
int OrientationByIntegers(const Corners<double>& t) {
  const Dyadic x[3] = {Split(t.ax), Split(t.bx), Split(t.cx)};
  const Dyadic y[3] = {Split(t.ay), Split(t.by), Split(t.cy)};
  const Range of_x = ExponentsOf(x);
  const Range of_y = ExponentsOf(y);
  Sum sum(of_x.lowest + of_y.lowest, of_x.highest + of_y.highest);
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3;
    sum.Add(x[k], y[next]);
    sum.Subtract(x[next], y[k]);
  }
  return sum.Sign();
}

// The sign of the area; a determinant that rounding cannot have turned is
// trusted. The bound is that of harness/truth/orientation.cc's proof: each
// product errs by (3u + 7u²) of itself and half the smallest subnormal, so
// |det| > 4u·(|l| + |r|) + 2^-1022 has the right sign. An overflow makes the
// bound infinite or NaN and the comparison false.
int Orientation(const Corners<double>& t) {
  const double left = (t.bx - t.ax) * (t.cy - t.ay);
  const double right = (t.by - t.ay) * (t.cx - t.ax);
  const double det = left - right;
  const double bound = 2 * std::numeric_limits<double>::epsilon() *
                           (std::abs(left) + std::abs(right)) +
                       std::numeric_limits<double>::min();
  if (det > bound) return 1;
  if (-det > bound) return -1;
  return OrientationByIntegers(t);
}

template <class T>
Corners<double> Widened(const Corners<T>& t) {
  return {t.ax, t.ay, t.bx, t.by, t.cx, t.cy};
}

// Whether an edge of a counter-clockwise triangle is a top or a left one, y
// upwards: it goes down, or level to the left.
bool IsTopLeft(double from_x, double from_y, double to_x, double to_y) {
  return to_y < from_y || (to_y == from_y && to_x < from_x);
}

// x − x is 0 for a finite x and else NaN.
bool IsFinite(const Corners<double>& t) {
  return (t.ax - t.ax) + (t.ay - t.ay) + (t.bx - t.bx) + (t.by - t.by) +
             (t.cx - t.cx) + (t.cy - t.cy) ==
         0;
}

bool Contains(Boundary boundary, const Corners<double>& t, double x, double y) {
  if (!IsFinite(t) || !IsFinite({x, y, 0, 0, 0, 0})) return false;
  const int ab = Orientation({t.ax, t.ay, t.bx, t.by, x, y});
  const int bc = Orientation({t.bx, t.by, t.cx, t.cy, x, y});
  if (ab * bc < 0) return false;
  const int ca = Orientation({t.cx, t.cy, t.ax, t.ay, x, y});
  if (ab * ca < 0 || bc * ca < 0) return false;
  // No two signs differ. The three determinants sum to the triangle's, so its
  // winding is their sign, and if all are 0, so is its area.
  if (ab != 0 && bc != 0 && ca != 0) return true;
  const int winding = ab != 0 ? ab : bc != 0 ? bc : ca;
  if (winding == 0) return false;
  if (boundary != Boundary::kTopLeft) return boundary == Boundary::kClosed;
  const auto counts = [winding](int side, double vx, double vy, double wx,
                                double wy) {
    if (side != 0) return true;
    return winding > 0 ? IsTopLeft(vx, vy, wx, wy) : IsTopLeft(wx, wy, vx, vy);
  };
  return counts(ab, t.ax, t.ay, t.bx, t.by) &&
         counts(bc, t.bx, t.by, t.cx, t.cy) &&
         counts(ca, t.cx, t.cy, t.ax, t.ay);
}

}  // namespace

template <class T>
int ExactOrientation(const Corners<T>& abc) {
  const Corners<double> wide = Widened(abc);
  return IsFinite(wide) ? Orientation(wide) : 0;
}

template <class T>
bool ExactlyContains(Boundary boundary, const Corners<T>& triangle, T x, T y) {
  return Contains(boundary, Widened(triangle), x, y);
}

template int ExactOrientation(const Corners<float>&);
template int ExactOrientation(const Corners<double>&);
template bool ExactlyContains(Boundary, const Corners<float>&, float, float);
template bool ExactlyContains(Boundary, const Corners<double>&, double, double);

}  // namespace pitbench
