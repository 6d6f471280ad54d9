// The exact arithmetic for rays against GMP's rational numbers.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "kernels/rays/exact/ray_contains.h"
#include "tests/rays/hard_rays.h"
#include "tests/rays/ray_kernel_answers.h"

namespace pitbench {
namespace {

#if PITBENCH_SLOW
constexpr int kItems = 20'000;
#else
constexpr int kItems = 100'000;
#endif

template <class T>
RayAndTriangle Both(const Triangle3<T>& t, const Ray<T>& ray) {
  return {{t.a.x, t.a.y, t.a.z},
          {t.b.x, t.b.y, t.b.z},
          {t.c.x, t.c.y, t.c.z},
          {ray.origin.x, ray.origin.y, ray.origin.z},
          {ray.direction.x, ray.direction.y, ray.direction.z}};
}

template <class T>
bool ExactlyHits(const Triangle3<T>& t, const Ray<T>& ray,
                 Boundary boundary = Boundary::kClosed) {
  return RayExactlyHits(boundary, Both(t, ray), ray.t_min, ray.t_max);
}

template <class T>
class ExactRaysTest : public testing::Test {};
using Floats = testing::Types<float, double>;
TYPED_TEST_SUITE(ExactRaysTest, Floats);

TYPED_TEST(ExactRaysTest, HitsAreThoseOfRationalArithmetic) {
  using T = TypeParam;
  HardRays<T> draw(1);
  int hits = 0;
  for (int i = 0; i < kItems; ++i) {
    const auto [triangle, ray] = draw.Draw();
    const bool hit = HitsByRationals(triangle, ray);
    ASSERT_EQ(ExactlyHits(triangle, ray), hit) << triangle << " " << ray;
    hits += hit ? 1 : 0;
  }
  EXPECT_GT(hits, kItems / 10);
  EXPECT_LT(hits, kItems * 9 / 10);
}

// |rounded − exact| is at most half of the distance to either neighbour, and
// less where `rounded` is odd.
template <class T>
bool IsNearest(T rounded, const mpq_class& exact) {
  constexpr T kLargest = std::numeric_limits<T>::max();
  constexpr T kInfinity = std::numeric_limits<T>::infinity();
  const auto rational = [](T x) { return mpq_class(static_cast<double>(x)); };
  const mpq_class beyond =
      rational(kLargest) +
      (rational(kLargest) - rational(std::nextafter(kLargest, T{0})));
  const auto middle = [&](T x, T y) -> mpq_class {
    const mpq_class of_x =
        std::isinf(x) ? (x > 0 ? beyond : -beyond) : rational(x);
    const mpq_class of_y =
        std::isinf(y) ? (y > 0 ? beyond : -beyond) : rational(y);
    return (of_x + of_y) / 2;
  };
  if (rounded == kInfinity) return exact >= middle(kLargest, kInfinity);
  if (rounded == -kInfinity) return exact <= middle(-kLargest, -kInfinity);
  const mpq_class low = middle(std::nextafter(rounded, -kInfinity), rounded);
  const mpq_class high = middle(rounded, std::nextafter(rounded, kInfinity));
  const bool even =
      sizeof(T) == 4
          ? (std::bit_cast<std::uint32_t>(static_cast<float>(rounded)) & 1) == 0
          : (std::bit_cast<std::uint64_t>(static_cast<double>(rounded)) & 1) ==
                0;
  return even ? low <= exact && exact <= high : low < exact && exact < high;
}

TYPED_TEST(ExactRaysTest, TuvAreTheNearestNumbers) {
  using T = TypeParam;
  HardRays<T> draw(2);
  for (int i = 0; i < kItems / 2; ++i) {
    const auto [triangle, ray] = draw.Draw();
    const RationalCrossing at = CrossingOf(triangle, ray);
    if (at.parallel) continue;
    const RayTuv<T> is = RoundedTuv<T>(Both(triangle, ray));
    ASSERT_TRUE(IsNearest(is.t, at.t)) << triangle << " " << ray << is.t;
    ASSERT_TRUE(IsNearest(is.u, at.u)) << triangle << " " << ray << is.u;
    ASSERT_TRUE(IsNearest(is.v, at.v)) << triangle << " " << ray << is.v;
  }
}

TYPED_TEST(ExactRaysTest, NearerIsALessT) {
  using T = TypeParam;
  HardRays<T> draw(3);
  Random random(3);
  std::array<int, 3> seen = {};
  for (int i = 0; i < kItems; ++i) {
    const auto [triangle, ray] = draw.Draw();
    Triangle3<T> other = draw.Draw().triangle;
    // Mostly one that meets the ray at the same t or close to it.
    if (random.Below(4) != 0) {
      other = {triangle.b, triangle.c, triangle.a};
      if (random.Below(2) == 0) other.a.x = std::nextafter(other.a.x, T{0});
      if (random.Below(2) == 0) other.b.z = std::nextafter(other.b.z, T{0});
    }
    const RationalCrossing x = CrossingOf(triangle, ray);
    const RationalCrossing y = CrossingOf(other, ray);
    if (x.parallel || y.parallel) continue;
    ++seen[static_cast<std::size_t>(1 + sgn(mpq_class(x.t - y.t)))];
    ASSERT_EQ(IsExactlyNearer(Both(triangle, ray), Both(other, ray)), x.t < y.t)
        << triangle << " " << other << " " << ray;
  }
  for (const int count : seen) EXPECT_GT(count, kItems / 10);
}

// Turned by (ε, ε², ε³) with an ε that is small enough for small whole numbers.
TYPED_TEST(ExactRaysTest, PerturbedIsWhatATurnedRayHits) {
  using T = TypeParam;
  Random random(4);
  const auto draw = [&] {
    return static_cast<T>(static_cast<int>(random.Below(5)) - 2);
  };
  const auto draw_point = [&]() -> Point3<T> {
    const T x = draw();
    const T y = draw();
    return {x, y, draw()};
  };
  const mpq_class epsilon(1, 1 << 16);
  int hits = 0;
  int misses_of_boundary = 0;
  for (int i = 0; i < kItems; ++i) {
    const Point3<T> a = draw_point();
    const Point3<T> b = draw_point();
    const Triangle3<T> triangle{a, b, draw_point()};
    const Point3<T> origin = draw_point();
    const Ray<T> ray{origin, draw_point(), 0,
                     std::numeric_limits<T>::infinity()};
    RationalVector turned = Rational(ray.direction);
    turned[0] += epsilon;
    turned[1] += epsilon * epsilon;
    turned[2] += epsilon * epsilon * epsilon;
    const RationalCrossing at =
        CrossingOf(triangle, Rational(ray.origin), turned);
    const bool hit = HitsByRationals(triangle, ray) && !at.parallel &&
                     at.u > 0 && at.v > 0 && at.u + at.v < 1;
    ASSERT_EQ(ExactlyHits(triangle, ray, Boundary::kPerturbed), hit)
        << triangle << " " << ray;
    hits += hit ? 1 : 0;
    misses_of_boundary += !hit && HitsByRationals(triangle, ray) ? 1 : 0;
  }
  EXPECT_GT(hits, kItems / 1000);
  EXPECT_GT(misses_of_boundary, kItems / 1000);
}

TYPED_TEST(ExactRaysTest, NumbersThatAreNotFiniteAreMisses) {
  using T = TypeParam;
  const Triangle3<T> t{{0, 0, 1}, {4, 0, 1}, {0, 4, 1}};
  const Ray<T> ray{{1, 1, 0}, {0, 0, 1}, 0, 2};
  ASSERT_TRUE(ExactlyHits(t, ray));
  for (const T x : kNotFinite<T>) {
    for (int k = 0; k < 15; ++k) {
      RayAndTriangle both = Both(t, ray);
      double(*const points[])[3] = {&both.a, &both.b, &both.c, &both.origin,
                                    &both.direction};
      (*points[k / 3])[k % 3] = x;
      EXPECT_FALSE(RayExactlyHits(Boundary::kClosed, both, 0, 2));
    }
    EXPECT_FALSE(RayExactlyHits(Boundary::kClosed, Both(t, ray), x, 2));
    EXPECT_EQ(RayExactlyHits(Boundary::kClosed, Both(t, ray), 0, x),
              x == std::numeric_limits<T>::infinity());
  }
}

}  // namespace
}  // namespace pitbench
