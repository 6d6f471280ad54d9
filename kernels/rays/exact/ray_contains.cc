#include "kernels/rays/exact/ray_contains.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernels/exact/big_number.h"

namespace pitbench {
namespace {

constexpr double kMax = std::numeric_limits<double>::max();

template <int kDegree>
struct BigVector {
  BigNumber<kDegree> x, y, z;
};

BigVector<1> Whole(const double (&p)[3], int unit) {
  return {BigNumber<1>(p[0], unit), BigNumber<1>(p[1], unit),
          BigNumber<1>(p[2], unit)};
}

BigVector<1> operator-(const BigVector<1>& p, const BigVector<1>& q) {
  return {p.x - q.x, p.y - q.y, p.z - q.z};
}

template <int kA, int kB>
BigVector<kA + kB> Cross(const BigVector<kA>& p, const BigVector<kB>& q) {
  return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}

template <int kA, int kB>
BigNumber<kA + kB> Dot(const BigVector<kA>& p, const BigVector<kB>& q) {
  return p.x * q.x + p.y * q.y + p.z * q.z;
}

// A ray and the plane through the origin and an edge from p to q.
struct EdgePlane {
  BigVector<2> normal;  // (p − origin) × (q − origin)
  BigNumber<3> volume;  // direction · normal: on which side the ray passes

  EdgePlane(const BigVector<1>& direction, const BigVector<1>& p,
            const BigVector<1>& q)
      : normal(Cross(p, q)), volume(Dot(direction, normal)) {}

  int Side() const { return volume.Sign(); }

  // The first of direction·n, n_x, n_y, n_z that is not 0: what the turned
  // direction has with n. All are 0 where the origin lies on the edge's line.
  int SideWhenTurned() const {
    for (const int sign :
         {volume.Sign(), normal.x.Sign(), normal.y.Sign(), normal.z.Sign()}) {
      if (sign != 0) return sign;
    }
    return 0;
  }
};

// Powers of two in which a ray and a triangle are whole numbers.
struct RayUnits {
  int points;
  int direction;
};
RayUnits Units(const RayAndTriangle& of) {
  const auto [a, b, c, o, d] = of;
  return {CommonUnit({a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2],
                      o[0], o[1], o[2]}),
          CommonUnit({d[0], d[1], d[2]})};
}

// The ray's line and the triangle's plane. The weights of a, b and c at where
// they meet are as the volumes of the edges opposite to them, which sum to
// direction·n with n = (b − a) × (c − a), and t is n·(a − origin) over that
// sum.
class Crossing {
 public:
  explicit Crossing(const RayAndTriangle& of) : Crossing(of, Units(of)) {}

  Crossing(const RayAndTriangle& of, RayUnits units)
      : units_(units),
        direction_(Whole(of.direction, units.direction)),
        origin_(Whole(of.origin, units.points)),
        a_(Whole(of.a, units.points) - origin_),
        b_(Whole(of.b, units.points) - origin_),
        c_(Whole(of.c, units.points) - origin_),
        ab_(direction_, a_, b_),
        bc_(direction_, b_, c_),
        ca_(direction_, c_, a_) {}

  // Whether the line goes through the triangle.
  bool Inside(Boundary boundary) const {
    const bool turned = boundary == Boundary::kPerturbed;
    const auto side = [turned](const EdgePlane& edge) {
      return turned ? edge.SideWhenTurned() : edge.Side();
    };
    const int ab = side(ab_);
    const int bc = side(bc_);
    const int ca = side(ca_);
    if (turned && (ab == 0 || bc == 0 || ca == 0)) return false;
    return ab * bc >= 0 && ab * ca >= 0 && bc * ca >= 0;
  }

  BigNumber<3> Denominator() const {
    return ab_.volume + bc_.volume + ca_.volume;
  }
  // t is in units of 2^UnitOfT().
  int UnitOfT() const { return units_.points - units_.direction; }
  BigNumber<3> OfT() const { return Dot(a_, bc_.normal); }
  const BigNumber<3>& OfU() const { return ca_.volume; }
  const BigNumber<3>& OfV() const { return ab_.volume; }

 private:
  RayUnits units_;
  BigVector<1> direction_;
  BigVector<1> origin_;
  BigVector<1> a_, b_, c_;  // from the ray's origin
  EdgePlane ab_, bc_, ca_;
};

// The sign of numerator/denominator − bound, the quotient in units of 2^unit.
int Compare(const BigNumber<3>& numerator, const BigNumber<3>& denominator,
            int unit, double bound) {
  const BigNumber<1> one(1.0);
  return (numerator * one - denominator * BigNumber<1>(bound, unit)).Sign() *
         denominator.Sign();
}

// x − x is 0 for a finite x and else NaN.
bool IsFinite(const RayAndTriangle& of) {
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    sum += (of.a[k] - of.a[k]) + (of.b[k] - of.b[k]) + (of.c[k] - of.c[k]) +
           (of.origin[k] - of.origin[k]) + (of.direction[k] - of.direction[k]);
  }
  return sum == 0;
}

bool AreEqual(const double (&p)[3], const double (&q)[3]) {
  return p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
}

// The number half way from `at`, ≥ 0 and finite, to the next larger T.
template <class T>
SplitDouble HalfWayUp(T at) {
  constexpr int kBits = std::numeric_limits<T>::digits;
  constexpr int kLeast = std::numeric_limits<T>::min_exponent - kBits;
  if (at == 0) return {1, kLeast - 1};
  const SplitDouble split = SplitDouble::Of(static_cast<double>(at));
  const int bits =
      64 - std::countl_zero(static_cast<std::uint64_t>(split.mantissa));
  // Of the last place.
  const int exponent = std::max(split.exponent + bits - kBits, kLeast);
  const std::int64_t mantissa = split.mantissa << (split.exponent - exponent);
  return {2 * mantissa + 1, exponent - 1};
}

// |numerator/denominator|, in units of 2^unit, as the nearest T.
template <class T>
T RoundedMagnitude(const BigNumber<3>& numerator,
                   const BigNumber<3>& denominator, int unit) {
  constexpr T kLargest = std::numeric_limits<T>::max();
  constexpr T kInfinity = std::numeric_limits<T>::infinity();
  if (numerator.Sign() == 0) return 0;
  int exponent_above = 0;
  int exponent_below = 0;
  const double above = std::abs(numerator.Leading(exponent_above));
  const double below = std::abs(denominator.Leading(exponent_below));
  // This is a few units in the last place off, which is mended step by step.
  const double near =
      std::ldexp(above / below, exponent_above - exponent_below + unit);
  T at = near < static_cast<double>(kLargest) ? static_cast<T>(near) : kLargest;
  const BigNumber<4> whole = (numerator * BigNumber<1>(1.0)).Magnitude();
  const BigNumber<3> divisor = denominator.Magnitude();
  const auto rounds_above = [&](T from) {
    const SplitDouble middle = HalfWayUp(from);
    const int side = (whole - divisor * BigNumber<1>(middle, unit)).Sign();
    const bool from_is_odd = (middle.mantissa & 2) != 0;
    return side > 0 || (side == 0 && from_is_odd);
  };
  while (rounds_above(at)) {
    if (at == kLargest) return kInfinity;
    at = std::nextafter(at, kInfinity);
  }
  for (; at != 0; at = std::nextafter(at, T{0})) {
    if (rounds_above(std::nextafter(at, T{0}))) break;
  }
  return at;
}

template <class T>
T Rounded(const BigNumber<3>& numerator, const BigNumber<3>& denominator,
          int unit) {
  const T magnitude = RoundedMagnitude<T>(numerator, denominator, unit);
  return numerator.Sign() * denominator.Sign() < 0 ? -magnitude : magnitude;
}

}  // namespace

bool RayExactlyHits(Boundary boundary, const RayAndTriangle& of, double t_min,
                    double t_max) {
  // What a kernel has beyond the last item of an array is told at once.
  if (AreEqual(of.a, of.b) || AreEqual(of.direction, {0, 0, 0})) return false;
  // An infinite t_max is above every t, as long as there is a t.
  if (!(t_min >= -kMax && t_min <= t_max) || t_min > kMax || !IsFinite(of)) {
    return false;
  }
  const Crossing crossing(of);
  if (!crossing.Inside(boundary)) return false;
  const BigNumber<3> denominator = crossing.Denominator();
  if (denominator.Sign() == 0) return false;
  const BigNumber<3> numerator = crossing.OfT();
  const int unit = crossing.UnitOfT();
  return Compare(numerator, denominator, unit, t_min) >= 0 &&
         (t_max > kMax || Compare(numerator, denominator, unit, t_max) <= 0);
}

template <class T>
RayTuv<T> RoundedTuv(const RayAndTriangle& of) {
  const Crossing crossing(of);
  const BigNumber<3> denominator = crossing.Denominator();
  return {Rounded<T>(crossing.OfT(), denominator, crossing.UnitOfT()),
          Rounded<T>(crossing.OfU(), denominator, 0),
          Rounded<T>(crossing.OfV(), denominator, 0)};
}

bool IsExactlyNearer(const RayAndTriangle& x, const RayAndTriangle& y) {
  const RayUnits of_one = Units(x);
  const RayUnits of_other = Units(y);
  const RayUnits both = {std::min(of_one.points, of_other.points),
                         of_one.direction};
  const Crossing of_x(x, both);
  const Crossing of_y(y, both);
  const BigNumber<3> below_x = of_x.Denominator();
  const BigNumber<3> below_y = of_y.Denominator();
  return (of_x.OfT() * below_y - of_y.OfT() * below_x).Sign() * below_x.Sign() *
             below_y.Sign() <
         0;
}

template RayTuv<float> RoundedTuv(const RayAndTriangle&);
template RayTuv<double> RoundedTuv(const RayAndTriangle&);

}  // namespace pitbench
