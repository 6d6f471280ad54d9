// The filter of truth agrees with exact arithmetic, and exact arithmetic with
// plain rationals, on millions of rays made to be hard.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <ios>
#include <sstream>
#include <string>

#include "harness/truth/ray_truth.h"
#include "tests/rays/hard_rays.h"

namespace pitbench {
namespace {

constexpr int kRays = PITBENCH_SLOW ? 100'000 : 2'000'000;

template <class T>
std::string Written(const Triangle3<T>& t, const Ray<T>& ray) {
  std::ostringstream text;
  text << std::hexfloat;
  for (const Point3<T>& p : {t.a, t.b, t.c, ray.origin, ray.direction}) {
    text << p.x << ',' << p.y << ',' << p.z << ' ';
  }
  text << ray.t_min << ' ' << ray.t_max;
  return text.str();
}

// By Cramer's rule, which shares nothing with the code under test.
template <class T>
RayPosition ByRationals(const Triangle3<T>& triangle, const Ray<T>& ray) {
  const RationalCrossing at = CrossingOf(triangle, ray);
  if (at.parallel) {
    const auto none = [](const RationalVector& v) {
      return v[0] == 0 && v[1] == 0 && v[2] == 0;
    };
    RationalVector e1 = Rational(triangle.b);
    RationalVector e2 = Rational(triangle.c);
    const RationalVector a = Rational(triangle.a);
    for (std::size_t k = 0; k < 3; ++k) {
      e1[k] -= a[k];
      e2[k] -= a[k];
    }
    const RationalVector normal = {e1[1] * e2[2] - e1[2] * e2[1],
                                   e1[2] * e2[0] - e1[0] * e2[2],
                                   e1[0] * e2[1] - e1[1] * e2[0]};
    return none(normal) || none(Rational(ray.direction))
               ? RayPosition::kDegenerate
               : RayPosition::kCoplanar;
  }
  const mpq_class w = 1 - at.u - at.v;
  if (at.u < 0 || at.v < 0 || w < 0 || !InRange(at.t, ray)) {
    return RayPosition::kMiss;
  }
  return at.u == 0 || at.v == 0 || w == 0 ? RayPosition::kBoundary
                                          : RayPosition::kHit;
}

// The same rule in arithmetic as narrow as T, which must get some of the inputs
// wrong.
template <class T>
bool HitsByRounding(const Triangle3<T>& t, const Ray<T>& ray) {
  const auto minus = [](const Point3<T>& p, const Point3<T>& q) -> Point3<T> {
    return {p.x - q.x, p.y - q.y, p.z - q.z};
  };
  const auto det = [](const Point3<T>& p, const Point3<T>& q,
                      const Point3<T>& r) {
    return p.x * (q.y * r.z - q.z * r.y) + p.y * (q.z * r.x - q.x * r.z) +
           p.z * (q.x * r.y - q.y * r.x);
  };
  const Point3<T> e = minus(t.b, t.a);
  const Point3<T> f = minus(t.c, t.a);
  const Point3<T> s = minus(ray.origin, t.a);
  const Point3<T>& d = ray.direction;
  const T facing = det(d, e, f);
  const T u = det(d, s, f) / facing;
  const T v = det(d, e, s) / facing;
  const T at = -det(s, e, f) / facing;
  return u >= 0 && v >= 0 && u + v <= 1 && at >= ray.t_min && at <= ray.t_max;
}

template <class T>
class RayTruthFilterTest : public testing::Test {};
using Floats = testing::Types<float, double>;
TYPED_TEST_SUITE(RayTruthFilterTest, Floats);

TYPED_TEST(RayTruthFilterTest, AgreesWithExactArithmeticOnHardRays) {
  using T = TypeParam;
  HardRays<T> draw(11);
  std::array<int, 5> met = {};
  int plain_errs = 0;
  for (int i = 0; i < kRays; ++i) {
    const auto [triangle, ray] = draw.Draw();
    const RayPosition exact = ClassifyExactly(triangle, ray);
    ASSERT_EQ(Classify(triangle, ray), exact) << Written(triangle, ray);
    ++met.at(static_cast<std::size_t>(exact));
    const bool hit =
        exact == RayPosition::kHit || exact == RayPosition::kBoundary;
    plain_errs += HitsByRounding(triangle, ray) != hit ? 1 : 0;
    if (i % 16 != 0) continue;
    ASSERT_EQ(ByRationals(triangle, ray), exact) << Written(triangle, ray);
  }
  for (const int count : met) EXPECT_GT(count, kRays / 2000);
  EXPECT_GT(plain_errs, kRays / 50);
}

// Few inputs lie where a bound that is somewhat too small would err. Here all
// do: a determinant of which nothing is left but what rounding made of it.
//   facing: D in the plane of two edges, as it rounds
//   weight: O and D in a plane with an edge, as they round
//   height: O in the triangle's plane, as it rounds, and t_min = 0
TYPED_TEST(RayTruthFilterTest, AgreesWhereOnlyRoundingIsLeft) {
  using T = TypeParam;
  Random random(3);
  const auto number = [&random](int exponent) {
    return static_cast<T>(std::ldexp(
        random.In(-1, 1), exponent - static_cast<int>(random.Below(4))));
  };
  int decided_late = 0;
  for (int i = 0; i < kRays / 4; ++i) {
    // Where products of three begin to be subnormal, and where they are not.
    constexpr int kLeast = std::numeric_limits<double>::min_exponent;
    const int third = sizeof(T) == 8 ? kLeast / 3 - 16 : -20;
    const int exponent = random.Below(2) == 0 ? 0 : third;
    const auto point = [&]() -> Point3<T> {
      const T x = number(exponent);
      const T y = number(exponent);
      return {x, y, number(exponent)};
    };
    const auto mix = [](const Point3<T>& p, double s, const Point3<T>& q,
                        double r) -> Point3<T> {
      return {static_cast<T>(s * p.x + r * q.x),
              static_cast<T>(s * p.y + r * q.y),
              static_cast<T>(s * p.z + r * q.z)};
    };
    const Point3<T> zero = {0, 0, 0};
    Triangle3<T> t = {zero, point(), point()};
    Ray<T> ray = {point(), point(), 0, std::numeric_limits<T>::infinity()};
    const double s = random.Unit();
    const double r = random.Unit();
    switch (i % 3) {
      case 0:
        ray.direction = mix(t.b, s, t.c, r);
        break;
      case 1:
        ray.direction = mix(t.b, s, ray.origin, -r);
        break;
      default:
        ray.origin = mix(t.b, s / 2, t.c, r / 2);
        break;
    }
    const RayPosition exact = ClassifyExactly(t, ray);
    ASSERT_EQ(Classify(t, ray), exact) << Written(t, ray);
    const bool hit =
        exact == RayPosition::kHit || exact == RayPosition::kBoundary;
    decided_late += HitsByRounding(t, ray) != hit ? 1 : 0;
  }
  EXPECT_GT(decided_late, kRays / 400);
}

}  // namespace
}  // namespace pitbench
