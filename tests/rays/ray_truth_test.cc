// The exact answers about rays: known cases, what they do not depend on, and
// what the numbers beside them are.
#include "harness/truth/ray_truth.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/rays/hard_rays.h"

namespace pitbench {
namespace {

template <class T>
constexpr T kInfinity = std::numeric_limits<T>::infinity();

template <class T>
Ray<T> Along(const Point3<T>& origin, const Point3<T>& direction) {
  return {origin, direction, 0, kInfinity<T>};
}

template <class T>
class RayTruthTest : public testing::Test {};
using Floats = testing::Types<float, double>;
TYPED_TEST_SUITE(RayTruthTest, Floats);

template <class T>
const Triangle3<T> kFlat{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

TYPED_TEST(RayTruthTest, KnowsEachKindOfAnswer) {
  using T = TypeParam;
  const auto down = [](T x, T y) { return Along<T>({x, y, 3}, {0, 0, -2}); };
  const auto at = [](const Ray<T>& ray) { return Classify(kFlat<T>, ray); };
  EXPECT_EQ(at(down(1, 1)), RayPosition::kHit);
  EXPECT_EQ(at(down(2, 2)), RayPosition::kBoundary) << "edge BC";
  EXPECT_EQ(at(down(0, 1)), RayPosition::kBoundary) << "edge CA";
  EXPECT_EQ(at(down(1, 0)), RayPosition::kBoundary) << "edge AB";
  EXPECT_EQ(at(down(0, 0)), RayPosition::kBoundary) << "vertex A";
  EXPECT_EQ(at(down(4, 0)), RayPosition::kBoundary) << "vertex B";
  EXPECT_EQ(at(down(3, 2)), RayPosition::kMiss);
  EXPECT_EQ(at(down(-1, 0)), RayPosition::kMiss) << "on the line of AB";
  EXPECT_EQ(at(Along<T>({1, 1, 3}, {0, 0, 2})), RayPosition::kMiss)
      << "behind the origin";
  EXPECT_EQ(at(Along<T>({1, 1, -3}, {0, 0, 2})), RayPosition::kHit)
      << "from the back";
  EXPECT_EQ(at(Along<T>({1, 1, 0}, {0, 0, 2})), RayPosition::kHit)
      << "t = 0 is in the range";
  EXPECT_EQ(at(Along<T>({-1, 1, 0}, {1, 0, 0})), RayPosition::kCoplanar);
  EXPECT_EQ(at(Along<T>({-1, 1, 5}, {1, 0, 0})), RayPosition::kCoplanar)
      << "parallel to the plane";
  EXPECT_EQ(at(Along<T>({1, 1, 3}, {0, 0, 0})), RayPosition::kDegenerate);
  EXPECT_EQ(at(Along<T>({1, 1, 3}, {0, T{-0.0}, 0})), RayPosition::kDegenerate);
  for (const Triangle3<T>& none :
       {Triangle3<T>{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}},
        Triangle3<T>{{0, 0, 0}, {0, 0, 0}, {3, 1, 3}},
        Triangle3<T>{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}}) {
    EXPECT_EQ(Classify(none, down(1, 1)), RayPosition::kDegenerate);
  }
}

TYPED_TEST(RayTruthTest, NumbersThatAreNoneAreMissesButForAnInfiniteEnd) {
  using T = TypeParam;
  const Ray<T> hit = Along<T>({1, 1, 3}, {0, 0, -2});
  for (const T bad :
       {std::numeric_limits<T>::quiet_NaN(), kInfinity<T>, -kInfinity<T>}) {
    for (std::size_t k = 0; k < 17; ++k) {
      Triangle3<T> t = kFlat<T>;
      Ray<T> ray = hit;
      T* const numbers[] = {
          &t.a.x,           &t.a.y,           &t.a.z,           &t.b.x,
          &t.b.y,           &t.b.z,           &t.c.x,           &t.c.y,
          &t.c.z,           &ray.origin.x,    &ray.origin.y,    &ray.origin.z,
          &ray.direction.x, &ray.direction.y, &ray.direction.z, &ray.t_min,
          &ray.t_max};
      *numbers[k] = bad;
      const bool may = k == 16 && bad == kInfinity<T>;
      EXPECT_EQ(IsFinite(t, ray), may) << k;
      EXPECT_EQ(Classify(t, ray), may ? RayPosition::kHit : RayPosition::kMiss)
          << k;
      EXPECT_EQ(ClassifyExactly(t, ray),
                may ? RayPosition::kHit : RayPosition::kMiss);
    }
  }
}

TYPED_TEST(RayTruthTest, EndsOfTheRangeCount) {
  using T = TypeParam;
  Ray<T> ray{{1, 1, 3}, {0, 0, -2}, T{1.5}, T{1.5}};
  EXPECT_EQ(Classify(kFlat<T>, ray), RayPosition::kHit);
  ray.t_min = std::nextafter(T{1.5}, T{2});
  ray.t_max = 9;
  EXPECT_EQ(Classify(kFlat<T>, ray), RayPosition::kMiss);
  ray.t_min = 0;
  ray.t_max = std::nextafter(T{1.5}, T{1});
  EXPECT_EQ(Classify(kFlat<T>, ray), RayPosition::kMiss);
  ray.t_min = 2;
  ray.t_max = 1;
  EXPECT_EQ(Classify(kFlat<T>, ray), RayPosition::kMiss) << "no t at all";
  ray = {{1, 1, -3}, {0, 0, -2}, -2, -1};
  EXPECT_EQ(Classify(kFlat<T>, ray), RayPosition::kHit) << "behind the origin";
}

// The least and the largest numbers there are: every product of three would
// underflow or overflow in double as well.
TYPED_TEST(RayTruthTest, NoSizeIsTooSmallOrTooLarge) {
  using T = TypeParam;
  const T least = std::numeric_limits<T>::denorm_min();
  const T largest = std::numeric_limits<T>::max();
  for (const T s : {least, largest / 4}) {
    for (const T d : {least, largest / 4}) {
      const Triangle3<T> t{{0, 0, 0}, {4 * s, 0, 0}, {0, 4 * s, 0}};
      const auto at = [&](T x, T y) {
        return Classify(t, Along<T>({x * s, y * s, 3 * s}, {0, 0, -2 * d}));
      };
      EXPECT_EQ(at(1, 1), RayPosition::kHit);
      EXPECT_EQ(at(2, 2), RayPosition::kBoundary);
      EXPECT_EQ(at(3, 2), RayPosition::kMiss);
    }
  }
  // Edges longer than the largest number.
  const Triangle3<T> wide{
      {-largest, -largest, 0}, {largest, -largest, 0}, {0, largest, 0}};
  EXPECT_EQ(Classify(wide, Along<T>({0, -largest, 1}, {0, 0, -largest})),
            RayPosition::kBoundary);
  EXPECT_EQ(Classify(wide, Along<T>({0, 0, largest}, {0, 0, -least})),
            RayPosition::kHit);
}

TYPED_TEST(RayTruthTest, TuvAreThoseOfCramersRule) {
  using T = TypeParam;
  const auto [t, u, v] = ExactTuv(kFlat<T>, Along<T>({1, 2, 3}, {0, 0, -2}));
  EXPECT_EQ(t, mpq_class(3, 2));
  EXPECT_EQ(u, mpq_class(1, 4));
  EXPECT_EQ(v, mpq_class(1, 2));
  HardRays<T> draw(7);
  int crossings = 0;
  for (int k = 0; k < 20'000; ++k) {
    const auto [triangle, ray] = draw.Draw();
    const RationalCrossing at = CrossingOf(triangle, ray);
    if (at.parallel) continue;
    ++crossings;
    const auto [own_t, own_u, own_v] = ExactTuv(triangle, ray);
    ASSERT_EQ(own_t, at.t);
    ASSERT_EQ(own_u, at.u);
    ASSERT_EQ(own_v, at.v);
  }
  EXPECT_GT(crossings, 15'000);
}

TYPED_TEST(RayTruthTest, FrontIsWhereVerticesGoCounterClockwise) {
  using T = TypeParam;
  const Triangle3<T> other{kFlat<T>.a, kFlat<T>.c, kFlat<T>.b};
  EXPECT_TRUE(IsFrontFacing(kFlat<T>, Along<T>({1, 2, 3}, {0, 0, -2})));
  EXPECT_FALSE(IsFrontFacing(other, Along<T>({1, 2, 3}, {0, 0, -2})));
  EXPECT_FALSE(IsFrontFacing(kFlat<T>, Along<T>({1, 2, -3}, {0, 0, 2})));
  const T least = std::numeric_limits<T>::denorm_min();
  EXPECT_TRUE(IsFrontFacing<T>({{0, 0, 0}, {least, 0, 0}, {0, least, 0}},
                               Along<T>({0, 0, 1}, {0, 0, -least})));
}

TYPED_TEST(RayTruthTest, EdgeDistanceIsTheLeastWeightInUlpsOfOne) {
  using T = TypeParam;
  const auto at = [](T x, T y) {
    return EdgeDistanceInUlps(kFlat<T>, Along<T>({x, y, 3}, {0, 0, -2}));
  };
  constexpr T kUlp = std::numeric_limits<T>::epsilon();
  EXPECT_EQ(at(2, 2), 0);
  EXPECT_EQ(at(1, 4 * kUlp), 1);
  EXPECT_EQ(at(1, -8 * kUlp), 2);
  EXPECT_EQ(at(1, 1), 0.25 / static_cast<double>(kUlp));
}

// Turned, wound the other way, seen from behind, mirrored, with axes renamed,
// and scaled by powers of two.
TYPED_TEST(RayTruthTest, NothingDependsOnOrderSignAxesOrScale) {
  using T = TypeParam;
  HardRays<T> draw(5);
  for (int k = 0; k < 50'000; ++k) {
    const auto [t, ray] = draw.Draw();
    const RayPosition position = Classify(t, ray);
    const auto& [a, b, c] = t;
    for (const Triangle3<T>& same :
         {Triangle3<T>{b, c, a}, Triangle3<T>{c, a, b}, Triangle3<T>{a, c, b},
          Triangle3<T>{c, b, a}, Triangle3<T>{b, a, c}}) {
      ASSERT_EQ(Classify(same, ray), position);
    }
    const auto mapped = [&](const auto& map) {
      Ray<T> moved = ray;
      moved.origin = map(ray.origin);
      moved.direction = map(ray.direction);
      return Classify({map(a), map(b), map(c)}, moved);
    };
    using P = Point3<T>;
    ASSERT_EQ(mapped([](const P& p) -> P {
                return {p.y, p.z, p.x};
              }),
              position);
    ASSERT_EQ(mapped([](const P& p) -> P {
                return {-p.x, -p.y, -p.z};
              }),
              position);
    ASSERT_EQ(mapped([](const P& p) -> P {
                return {p.y, p.x, -p.z};
              }),
              position);
    // Exact where numbers stay normal.
    const auto half = [](T x) { return std::ldexp(x, -1); };
    const auto doubles = [&](const P& p) {
      return half(p.x) * 2 == p.x && half(p.y) * 2 == p.y &&
             half(p.z) * 2 == p.z;
    };
    if (doubles(a) && doubles(b) && doubles(c) && doubles(ray.origin) &&
        doubles(ray.direction)) {
      ASSERT_EQ(mapped([&](const P& p) -> P {
                  return {half(p.x), half(p.y), half(p.z)};
                }),
                position);
    }
  }
}

TYPED_TEST(RayTruthTest, RoundingMayDecideNearEdgesAndEndsAlone) {
  using T = TypeParam;
  const Ray<T> inside = Along<T>({1, 1, 3}, {0, 0, -2});
  EXPECT_FALSE(RoundingMayDecide(kFlat<T>, inside, 64));
  EXPECT_TRUE(RoundingMayDecide(kFlat<T>, Along<T>({2, 2, 3}, {0, 0, -2}), 0))
      << "on an edge";
  Ray<T> at_end = inside;
  at_end.t_max = T{1.5};
  EXPECT_TRUE(RoundingMayDecide(kFlat<T>, at_end, 0));
  at_end.t_max = 2;
  EXPECT_FALSE(RoundingMayDecide(kFlat<T>, at_end, 64));
  // L = 4√2, h = 2√2, M = 4, sin = 1: the bound is 2u times the slack.
  const T u = std::numeric_limits<T>::epsilon() / 2;
  const auto off = [&](T weight) {
    return Along<T>({1, 4 * weight, 3}, {0, 0, -2});
  };
  EXPECT_TRUE(RoundingMayDecide(kFlat<T>, off(2 * u), 1));
  EXPECT_FALSE(RoundingMayDecide(kFlat<T>, off(T{2.0625} * u), 1));
  // Along (3, 0, -4) the sine is 4/5.
  const Ray<T> slanted = Along<T>({-2, 8 * u, 4}, {3, 0, -4});
  EXPECT_TRUE(RoundingMayDecide(kFlat<T>, slanted, 0.8001));
  EXPECT_FALSE(RoundingMayDecide(kFlat<T>, slanted, 0.7999));
}

TYPED_TEST(RayTruthTest, RoundingMayDecideWithoutAnglesButNotWithoutDirection) {
  using T = TypeParam;
  EXPECT_TRUE(RoundingMayDecide(kFlat<T>, Along<T>({9, 9, 9}, {1, 2, 0}), 0));
  EXPECT_TRUE(RoundingMayDecide<T>({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}},
                                   Along<T>({9, 9, 9}, {1, 2, 0}), 0));
  EXPECT_FALSE(
      RoundingMayDecide(kFlat<T>, Along<T>({1, 1, 3}, {0, 0, 0}), 1e9));
}

// Oblikovati#2146: both halves of the square have the ray on their diagonal.
TYPED_TEST(RayTruthTest, TheRayAtTheDiagonalOfASquareIsOnBothHalves) {
  using T = TypeParam;
  const T x = static_cast<T>(.30458447F);
  const auto ray = Along<T>({0, 0, 10}, {x, x, static_cast<T>(-.9024725F)});
  const Triangle3<T> lower{{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}};
  const Triangle3<T> upper{{-5, -5, 0}, {5, 5, 0}, {-5, 5, 0}};
  EXPECT_EQ(Classify(lower, ray), RayPosition::kBoundary);
  EXPECT_EQ(Classify(upper, ray), RayPosition::kBoundary);
}

// libgdx#6882: the point as it is, and the triangle's normal rounded: the ray
// meets the plane far outside, with no weight that rounding could turn.
TYPED_TEST(RayTruthTest, ThePointFarBesideATriangleIsAMiss) {
  using T = TypeParam;
  const auto of = [](float x, float y, float z) -> Point3<T> {
    return {x, y, z};
  };
  const Triangle3<T> t{of(50.008057F, 22.20586F, 124.62208F),
                       of(62.282288F, 22.205864F, 109.665924F),
                       of(70.92052F, 7.205861F, 115.437805F)};
  for (const float way : {1.F, -1.F}) {
    const Ray<T> ray = {
        of(-5120.8345F, 8946.126F, -3270.5813F),
        of(way * 224.34233F, way * 200.04009F, way * 184.11353F),
        std::numeric_limits<T>::lowest(), kInfinity<T>};
    EXPECT_EQ(Classify(t, ray), RayPosition::kMiss);
    EXPECT_FALSE(RoundingMayDecide(t, ray, 1));
    const auto [at, u, v] = ExactTuv(t, ray);
    const mpq_class w = 1 - u - v;
    EXPECT_LT(std::min({u.get_d(), v.get_d(), w.get_d()}), -100);
  }
}

}  // namespace
}  // namespace pitbench
