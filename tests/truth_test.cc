// Known answers for truth: published cases, brute force on small grids, and
// what its contract says of NaN, infinity and area 0.
#include "harness/truth/truth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "harness/truth/orientation.h"
#include "tests/real_world_cases.h"

namespace pitbench {
namespace {

template <class T>
void ExpectPosition(const Triangle<T>& triangle, const Point<T>& p,
                    std::string_view expected, const std::string& id) {
  EXPECT_EQ(Name(Classify(triangle, p)), expected) << id;
  EXPECT_EQ(Name(ClassifyExactly(triangle, p)), expected) << id;
}

template <class T>
void ExpectTruthOf(const RealWorldCase& one) {
  EXPECT_TRUE(one.Fits<T>()) << one.id;
  ExpectPosition(one.TriangleAs<T>(), one.PointAs<T>(), one.truth, one.id);
}

TEST(TruthTest, AgreesWithEveryRealWorldCase) {
  const std::vector<RealWorldCase> cases = RealWorldCases();
  EXPECT_EQ(cases.size(), 26u);
  for (const RealWorldCase& one : cases) {
    if (one.scalar == "f32") {
      ExpectTruthOf<float>(one);
    } else {
      EXPECT_EQ(one.scalar, "f64") << one.id;
      ExpectTruthOf<double>(one);
    }
  }
}

// A product and its mirror differ under FMA: a × a = 0x1.eb852p-32 there.
TEST(TruthTest, CrossProductOfAVectorWithItselfIsZero) {
  const Point<float> a = {0x1.99999ap-4f, 0x1.333334p-2f};
  EXPECT_EQ(Orientation<float>({0, 0}, a, a), 0);
  ExpectPosition<float>({{0, 0}, a, a}, a, "degenerate", "a × a");
}

// The exact value is -2^-56. In double without contraction it is 0, with it
// +0x1.8p-55.
TEST(TruthTest, FloatsThatDoubleGetsWrongAreRight) {
  const Point<float> a = {-1, -1};
  const Point<float> b = {0x1.8p-27f, 0x1p-27f};
  const Point<float> c = {0x1p-27f, 0x1p-28f};
  EXPECT_EQ(Orientation(a, b, c), -1);
  EXPECT_EQ(OrientationExactly(a, b, c), -1);
}

// Kettner's map (kettner_test.cc): p steps by ulps, nearly on the line y = x.
TEST(TruthTest, KettnersMapIsDecidedByItsDiagonal) {
  const Point<double> q = {12, 12};
  const Point<double> r = {24, 24};
  for (int i = 0; i < 256; ++i) {
    for (int j = 0; j < 256; ++j) {
      const Point<double> p = {0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53};
      EXPECT_EQ(OrientationExactly(p, q, r), (j > i) - (j < i));
      EXPECT_EQ(Orientation(p, q, r), (j > i) - (j < i));
    }
  }
}

// The position by integers too small to overflow.
std::string_view BruteForce(const std::array<int, 8>& v) {
  const auto cross = [&v](int i, int j, int k) {
    const auto at = [&v](int point, int axis) {
      return v[static_cast<std::size_t>(2 * point + axis)];
    };
    return (at(j, 0) - at(i, 0)) * (at(k, 1) - at(i, 1)) -
           (at(j, 1) - at(i, 1)) * (at(k, 0) - at(i, 0));
  };
  const int area = cross(0, 1, 2);
  if (area == 0) return "degenerate";
  const int turn = area > 0 ? 1 : -1;
  const auto [least, most] = std::minmax(
      {turn * cross(0, 1, 3), turn * cross(1, 2, 3), turn * cross(2, 0, 3)});
  return least < 0 ? "outside" : least == 0 ? "boundary" : "inside";
}

// All triangles on a 3 × 3 grid and all points of the 5 × 5 grid around it,
// after x → x·x_unit + x_origin and the same for y, which the caller chooses
// such that T holds the results exactly. Such a map moves no point across an
// edge.
template <class T>
void ExpectAgreementWithBruteForce(T x_unit, T y_unit, T x_origin = 0,
                                   T y_origin = 0) {
  using Wide = std::conditional_t<std::integral<T>, std::int64_t, T>;
  const auto point = [=](int x, int y) -> Point<T> {
    return {static_cast<T>(static_cast<Wide>(x) * x_unit + x_origin),
            static_cast<T>(static_cast<Wide>(y) * y_unit + y_origin)};
  };
  for (int triangle = 0; triangle < 9 * 9 * 9; ++triangle) {
    std::array<int, 8> v{};
    for (int vertex = 0, rest = triangle; vertex < 3; ++vertex, rest /= 9) {
      v[static_cast<std::size_t>(2 * vertex)] = rest % 3;
      v[static_cast<std::size_t>(2 * vertex + 1)] = rest % 9 / 3;
    }
    for (v[6] = -1; v[6] <= 3; ++v[6]) {
      for (v[7] = -1; v[7] <= 3; ++v[7]) {
        const Triangle<T> at = {point(v[0], v[1]), point(v[2], v[3]),
                                point(v[4], v[5])};
        const Point<T> p = point(v[6], v[7]);
        const std::string_view expected = BruteForce(v);
        ASSERT_EQ(Name(Classify(at, p)), expected)
            << "triangle " << triangle << ", p " << v[6] << ' ' << v[7];
        ASSERT_EQ(Name(ClassifyExactly(at, p)), expected)
            << "triangle " << triangle << ", p " << v[6] << ' ' << v[7];
      }
    }
  }
}

TEST(TruthTest, SmallGridsAreRightInEveryScalar) {
  ExpectAgreementWithBruteForce<float>(1, 1);
  ExpectAgreementWithBruteForce<double>(1, 1);
  ExpectAgreementWithBruteForce<std::int32_t>(1, 1);
}

TEST(TruthTest, SubnormalGridsAreRight) {
  ExpectAgreementWithBruteForce<float>(0x1p-149f, 0x1p-149f);
  ExpectAgreementWithBruteForce<float>(0x1p-149f, 1);
  ExpectAgreementWithBruteForce<double>(0x1p-1074, 0x1p-1074);
  ExpectAgreementWithBruteForce<double>(0x1p-1074, 1);
}

TEST(TruthTest, GridsNearOverflowAreRight) {
  ExpectAgreementWithBruteForce<float>(0x1p126f, 0x1p126f);
  ExpectAgreementWithBruteForce<double>(0x1p1022, 0x1p1022);
  ExpectAgreementWithBruteForce<double>(0x1p1022, 0x1p-1074);
  // The first and the last grid line are far apart: the differences overflow.
  ExpectAgreementWithBruteForce<float>(0x1p126f, 0x1p126f, -0x1p127f);
  ExpectAgreementWithBruteForce<double>(0x1p1022, 0x1p1022, -0x1p1023,
                                        -0x1p1023);
}

TEST(TruthTest, GridsAtTheEndsOfInt32AreRight) {
  constexpr std::int32_t kMin = std::numeric_limits<std::int32_t>::min();
  constexpr std::int32_t kMax = std::numeric_limits<std::int32_t>::max();
  ExpectAgreementWithBruteForce<std::int32_t>(1, 1, kMin + 1, kMax - 3);
  ExpectAgreementWithBruteForce<std::int32_t>(0x3FFFFFFF, 0x3FFFFFFF,
                                              -0x40000000, -0x40000000);
  ExpectAgreementWithBruteForce<std::int32_t>(0x3FFFFFFF, -1, -0x40000000, 0);
}

TEST(TruthTest, GridsFarFromTheOriginAreRight) {
  ExpectAgreementWithBruteForce<float>(1, 1, 0x1p23f, -0x1p23f);
  ExpectAgreementWithBruteForce<double>(1, 1, 0x1p52, -0x1p52);
}

// Rounded decimals: p is one ulp off the middle of the long edge.
TEST(TruthTest, OneUlpFromAnEdgeIsNotOnIt) {
  const Triangle<double> triangle = {{0, 0}, {1e300, 1e-300}, {0, 1e300}};
  ExpectPosition<double>(triangle, {5e299, 5e-301}, "boundary", "middle");
  const double above = std::nextafter(5e-301, 1.0);
  ExpectPosition<double>(triangle, {5e299, above}, "inside", "above");
  const double below = std::nextafter(5e-301, 0.0);
  ExpectPosition<double>(triangle, {5e299, below}, "outside", "below");
}

template <class T>
void ExpectOutsideWherever(T bad) {
  // A plain triangle around the origin, and one of area 0.
  for (const std::array<T, 8>& good :
       {std::array<T, 8>{-1, -1, 3, -1, 0, 3, 0, 0},
        std::array<T, 8>{0, 0, 1, 1, 2, 2, 0, 0}}) {
    for (std::size_t k = 0; k < 8; ++k) {
      std::array<T, 8> v = good;
      v[k] = bad;
      ExpectPosition<T>({{v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}},
                        {v[6], v[7]}, "outside", std::to_string(k));
    }
  }
}

TEST(TruthTest, NanAndInfinityInAnyCoordinateAreOutside) {
  ExpectOutsideWherever(std::numeric_limits<float>::quiet_NaN());
  ExpectOutsideWherever(std::numeric_limits<float>::infinity());
  ExpectOutsideWherever(-std::numeric_limits<float>::infinity());
  ExpectOutsideWherever(std::numeric_limits<double>::quiet_NaN());
  ExpectOutsideWherever(std::numeric_limits<double>::infinity());
  ExpectOutsideWherever(-std::numeric_limits<double>::infinity());
}

TEST(TruthTest, AreaZeroIsDegenerateForEveryPoint) {
  const Triangle<double> dot = {{0.1, 0.2}, {0.1, 0.2}, {0.1, 0.2}};
  const Triangle<double> segment = {{0, 0}, {3, 1}, {6, 2}};
  const Triangle<double> twice = {{0, 0}, {3, 1}, {0, 0}};
  for (const Triangle<double>& triangle : {dot, segment, twice}) {
    for (const Point<double>& p :
         {triangle.a, triangle.b, Point<double>{5, -7}}) {
      ExpectPosition(triangle, p, "degenerate", "f64");
    }
  }
  ExpectPosition<std::int32_t>({{0, 0}, {2, 2}, {1, 1}}, {1, 1}, "degenerate",
                               "i32");
}

TEST(TruthTest, MinusZeroIsZero) {
  ExpectPosition<float>({{-0.0f, -0.0f}, {1, -0.0f}, {-0.0f, 1}}, {0, 0},
                        "boundary", "vertex");
  ExpectPosition<double>({{-1, 0}, {1, -0.0}, {0, 1}}, {-0.0, -0.0}, "boundary",
                         "edge");
}

}  // namespace
}  // namespace pitbench
