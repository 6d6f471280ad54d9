// Exact weights, errors in ulps and distances from the boundary: known answers
// and identities that hold exactly.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "harness/truth/weights.h"

namespace pitbench {
namespace {

template <class T>
Triangle<T> Permuted(const Triangle<T>& t, int which) {
  const std::array<Triangle<T>, 6> all = {{{t.a, t.b, t.c},
                                           {t.a, t.c, t.b},
                                           {t.b, t.a, t.c},
                                           {t.b, t.c, t.a},
                                           {t.c, t.a, t.b},
                                           {t.c, t.b, t.a}}};
  return all[static_cast<std::size_t>(which)];
}

TEST(ExactWeightsTest, ShoelaceByHand) {
  // Areas by hand: p = (1, 1) sees twice 4 opposite A and twice 2 elsewhere.
  const auto w = ExactWeights<float>({{0, 0}, {4, 0}, {0, 4}}, {1, 1});
  EXPECT_EQ(w[0], mpq_class(1, 2));
  EXPECT_EQ(w[1], mpq_class(1, 4));
  EXPECT_EQ(w[2], mpq_class(1, 4));
}

TEST(ExactWeightsTest, AVertexHasWeightOne) {
  const Triangle<std::int32_t> t = {
      {-2147483647 - 1, 5}, {7, 2147483647}, {9, -2}};
  EXPECT_EQ(ExactWeights(t, t.a), (std::array<mpq_class, 3>{1, 0, 0}));
  EXPECT_EQ(ExactWeights(t, t.b), (std::array<mpq_class, 3>{0, 1, 0}));
  EXPECT_EQ(ExactWeights(t, t.c), (std::array<mpq_class, 3>{0, 0, 1}));
}

template <class T>
class ExactWeightsRandomTest : public testing::Test {};
using Floats = testing::Types<float, double>;
TYPED_TEST_SUITE(ExactWeightsRandomTest, Floats);

TYPED_TEST(ExactWeightsRandomTest, SumToOneAndReproduceThePoint) {
  using T = TypeParam;
  using Limits = std::numeric_limits<T>;
  std::mt19937_64 bits(1);
  for (int i = 0; i < 20'000; ++i) {
    // Every power of two from subnormal to the greatest; a spread of 2^8
    // within one case, and of everything in every eighth.
    const auto exponent = [&bits](int low, int high) {
      return low + static_cast<int>(bits() %
                                    static_cast<std::uint64_t>(high - low + 1));
    };
    const int base = exponent(Limits::min_exponent, Limits::max_exponent - 8);
    std::array<T, 8> v;
    for (T& x : v) {
      const T unit = std::ldexp(
          static_cast<T>(static_cast<std::int64_t>(bits()) >> 40), -23);
      x = std::ldexp(unit, i % 8 == 0 ? exponent(Limits::min_exponent - 20,
                                                 Limits::max_exponent)
                                      : base + exponent(0, 8));
    }
    const Triangle<T> t = {{v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}};
    const Point<T> p = {v[6], v[7]};
    if (ClassifyExactly(t, p) == Position::kDegenerate) continue;
    const auto w = ExactWeights(t, p);
    ASSERT_EQ(mpq_class(w[0] + w[1] + w[2]), 1);
    ASSERT_EQ(mpq_class(w[0] * t.a.x + w[1] * t.b.x + w[2] * t.c.x), p.x);
    ASSERT_EQ(mpq_class(w[0] * t.a.y + w[1] * t.b.y + w[2] * t.c.y), p.y);
    const bool inside = w[0] > 0 && w[1] > 0 && w[2] > 0;
    ASSERT_EQ(inside, ClassifyExactly(t, p) == Position::kInside);
  }
}

TEST(UlpErrorTest, KnownAnswers) {
  EXPECT_EQ(UlpError(1.0, mpq_class(1)), 0);
  EXPECT_EQ(UlpError(1 + 0x1p-52, mpq_class(1)), 1);
  EXPECT_EQ(UlpError(1 - 0x1p-53, mpq_class(1)), 0.5);
  EXPECT_EQ(UlpError(-1.0f, mpq_class(-1) - mpq_class(0x3p-23)), 3);
  EXPECT_EQ(UlpError(-1.0, mpq_class(1)), 0x1p53);
  // The double nearest to 1/3 is 2^-54 / 3 below it, and the ulp is 2^-54.
  EXPECT_DOUBLE_EQ(UlpError(1.0 / 3, mpq_class(1, 3)), 1.0 / 3);
  // 1 − 2^-60 belongs to the binade below 1, where the ulp is half.
  EXPECT_EQ(UlpError(1.0, 1 - mpq_class(0x1p-60)), 0x1p-7);
}

TEST(UlpErrorTest, SubnormalSpacingIsTheLeastUlp) {
  EXPECT_EQ(UlpError(0x1p-1074, mpq_class(0)), 1);
  EXPECT_EQ(UlpError(0.0, mpq_class(0)), 0);
  EXPECT_EQ(UlpError(0.0, mpq_class(0x1p-1022)), 0x1p52);
  EXPECT_EQ(UlpError(0x1p-149f, mpq_class(0x1p-150)), 0.5);
  const mpq_class tiny = mpq_class(0x1p-1074) / 8;
  EXPECT_EQ(UlpError(0.0, tiny), 0.125);
}

TEST(UlpErrorTest, NanAndInfinityAreInfinitelyWrong) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(UlpError(kInfinity, mpq_class(1)), kInfinity);
  EXPECT_EQ(UlpError(-std::numeric_limits<float>::infinity(), mpq_class(1)),
            kInfinity);
  EXPECT_EQ(UlpError(std::numeric_limits<double>::quiet_NaN(), mpq_class(0)),
            kInfinity);
}

TEST(BoundaryDistanceTest, FootOnAnEdgeAndVertexNearest) {
  for (int which = 0; which < 6; ++which) {
    const auto i32 = [which](std::int32_t x, std::int32_t y) {
      return BoundaryDistanceInUlps<std::int32_t>(
          Permuted<std::int32_t>({{0, 0}, {12, 0}, {0, 12}}, which), {x, y});
    };
    EXPECT_EQ(i32(3, 2), 2);                      // inside
    EXPECT_EQ(i32(4, 0), 0);                      // on an edge
    EXPECT_EQ(i32(-3, -4), 5);                    // vertex (0, 0)
    EXPECT_EQ(i32(15, -4), 5);                    // vertex (12, 0)
    EXPECT_DOUBLE_EQ(i32(7, 7), std::sqrt(2.0));  // hypotenuse
    EXPECT_DOUBLE_EQ(i32(1000000000, 1000000000), (2e9 - 12) / std::sqrt(2.0));
  }
}

TEST(BoundaryDistanceTest, UlpIsThatOfTheLargerCoordinateOfThePoint) {
  const Triangle<double> t = {{0, 0}, {4, 0}, {0, 4}};
  EXPECT_EQ(BoundaryDistanceInUlps<double>(t, {1, -0x1p-52}), 1);
  EXPECT_EQ(BoundaryDistanceInUlps<double>(t, {2, -0x1p-52}), 0.5);
  EXPECT_EQ(BoundaryDistanceInUlps<double>(t, {-0x1p-52, -1}), 0x1p52);
  const Triangle<float> f = {{0, 0}, {4, 0}, {0, 4}};
  EXPECT_EQ(BoundaryDistanceInUlps<float>(f, {1, -0x1p-23f}), 1);
  EXPECT_EQ(BoundaryDistanceInUlps<float>(f, {1, 0x3p-149f}), 0x3p-126);
}

TEST(BoundaryDistanceTest, NoIntermediateOverflowsOrUnderflows) {
  const Triangle<double> huge = {
      {-0x1p1023, -0x1p1023}, {0x1p1023, -0x1p1023}, {0, 0x1p1023}};
  EXPECT_EQ(BoundaryDistanceInUlps<double>(huge, {0x1p900, -0x1p1022}), 0x1p52);
  const double least = 0x1p-1074;
  const Triangle<double> tiny = {{0, 0}, {8 * least, 0}, {0, 8 * least}};
  EXPECT_EQ(BoundaryDistanceInUlps<double>(tiny, {2 * least, least}), 1);
  EXPECT_DOUBLE_EQ(BoundaryDistanceInUlps<double>(tiny, {least * 5, least * 5}),
                   std::sqrt(2.0));
  // Subnormal distance from a boundary at the other end of the range.
  const Triangle<double> wide = {{-0x1p1023, 0}, {0x1p1023, 0}, {0, 0x1p1023}};
  EXPECT_EQ(BoundaryDistanceInUlps<double>(wide, {0x1p-1022, 3 * least}), 3);
}

// sqrt of a rational number by long double on plain numbers.
TEST(BoundaryDistanceTest, AgreesWithLongDoubleOnPlainNumbers) {
  std::mt19937_64 bits(1);
  const auto unit = [&bits] {
    return std::ldexp(static_cast<double>(bits() >> 40), -24);
  };
  for (int i = 0; i < 10'000; ++i) {
    const std::array<Point<double>, 3> v = {
        {{unit(), unit()}, {unit(), unit()}, {unit(), unit()}}};
    const Point<double> p = {unit() + 1, unit()};  // its ulp is 2^-52
    long double nearest = 10;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point<double>& a = v[k];
      const Point<double>& b = v[(k + 1) % 3];
      const long double ex = b.x - a.x, ey = b.y - a.y;
      const long double along =
          ((p.x - a.x) * ex + (p.y - a.y) * ey) / (ex * ex + ey * ey);
      const long double t = std::min(1.0L, std::max(0.0L, along));
      nearest =
          std::min(nearest, std::hypot(a.x + t * ex - p.x, a.y + t * ey - p.y));
    }
    const double expected = static_cast<double>(std::ldexp(nearest, 52));
    ASSERT_NEAR(BoundaryDistanceInUlps<double>({v[0], v[1], v[2]}, p), expected,
                1e-10 * expected);
  }
}

TEST(BoundaryDistanceTest, TrianglesOfAreaZeroHaveABoundaryToo) {
  EXPECT_EQ(
      BoundaryDistanceInUlps<std::int32_t>({{1, 1}, {1, 1}, {1, 1}}, {4, 5}),
      5);
  EXPECT_EQ(
      BoundaryDistanceInUlps<std::int32_t>({{0, 0}, {5, 0}, {9, 0}}, {7, -3}),
      3);
}

TEST(RoundingMayDecideTest, BoundScalesWithUnitRoundoffAndAltitude) {
  // M = 4, longest edge 4√2, twice the area 16, so (M/h)² = 16·32/256 = 2,
  // and w_c = y/4: rounding may decide up to y = 8·slack·u.
  for (int which = 0; which < 6; ++which) {
    const auto f64 = Permuted<double>({{0, 0}, {4, 0}, {0, 4}}, which);
    EXPECT_TRUE(RoundingMayDecide<double>(f64, {1, 0}, 0));
    EXPECT_FALSE(RoundingMayDecide<double>(f64, {1, 0x1p-1074}, 0));
    EXPECT_TRUE(RoundingMayDecide<double>(f64, {1, 0x1p-50}, 1));
    EXPECT_FALSE(
        RoundingMayDecide<double>(f64, {1, std::nextafter(0x1p-50, 1.0)}, 1));
    EXPECT_TRUE(RoundingMayDecide<double>(f64, {1, -0x1p-48}, 4));
    EXPECT_FALSE(RoundingMayDecide<double>(f64, {1, -0x1p-47}, 4));
    const auto f32 = Permuted<float>({{0, 0}, {4, 0}, {0, 4}}, which);
    EXPECT_TRUE(RoundingMayDecide<float>(f32, {1, 0x1p-21f}, 1));
    EXPECT_FALSE(RoundingMayDecide<float>(f32, {1, 0x1p-20f}, 1));
  }
}

TEST(RoundingMayDecideTest, GrowsWithTheDistanceFromTheOrigin) {
  const Triangle<float> at = {{4096, 4096}, {4096.5, 4096}, {4096, 4096.5}};
  EXPECT_TRUE(RoundingMayDecide<float>(at, {4096.125, 4096.125}, 1));
  const Triangle<float> near = {{0, 0}, {0.5, 0}, {0, 0.5}};
  EXPECT_FALSE(RoundingMayDecide<float>(near, {0.125, 0.125}, 1));
}

TEST(RoundingMayDecideTest, AlwaysWithoutAreaAndNeverForIntegers) {
  EXPECT_TRUE(RoundingMayDecide<float>({{0, 0}, {1, 1}, {3, 3}}, {7, 0}, 0));
  const Triangle<std::int32_t> i32 = {{0, 0}, {4, 0}, {0, 4}};
  EXPECT_FALSE(RoundingMayDecide<std::int32_t>(i32, {1, 0}, 1e9));
}

}  // namespace
}  // namespace pitbench
