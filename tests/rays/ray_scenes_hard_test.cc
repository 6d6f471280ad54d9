// Hard scenes of rays are what their names say, by exact arithmetic.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "tests/rays/made_ray_scene.h"
#include "tests/rays/rational_vectors.h"

namespace pitbench {
namespace {

template <class T>
class RayScenesHardTest : public testing::Test {};
using Floats = testing::Types<float, double>;
TYPED_TEST_SUITE(RayScenesHardTest, Floats);

// Both sides of an edge, as far as hits and misses show it.
TYPED_TEST(RayScenesHardTest, RaysNearEdgesHitAndMiss) {
  for (const RayLoop loop : kRayLoops) {
    for (const std::string name :
         {"rays_near_edge:ulps=16", "rays_needle:aspect=5",
          "rays_far_origin:exponent=3", "rays_offset:ratio=3",
          "rays_grazing:exponent=0", "rays_grazing:exponent=40",
          "rays_special:kind=minus_zero", "rays_special:kind=subnormal",
          "rays_special:kind=largest"}) {
      auto positions = Positions(MakeRays<TypeParam>(name, loop));
      const std::size_t all = kRaySize.groups * kRaySize.size;
      EXPECT_GT(positions[RayPosition::kHit], all / 40)
          << name << " " << Name(loop);
      EXPECT_GT(positions[RayPosition::kMiss], all / 40)
          << name << " " << Name(loop);
    }
  }
}

TYPED_TEST(RayScenesHardTest, GrazingRaysHaveTheAngleOfTheirName) {
  using T = TypeParam;
  for (const RayLoop loop : kRayLoops) {
    for (const int exponent : {0, 1, 10, 24, 40, 60}) {
      double least = 2;
      double most = 0;
      ForEachRay(MakeRays<T>(With("rays_grazing:exponent=", exponent), loop),
                 [&](const Triangle3<T>& t, const Ray<T>& ray) {
                   const RationalVector a = Rational(t.a);
                   const RationalVector normal =
                       Cross(Minus(Rational(t.b), a), Minus(Rational(t.c), a));
                   const RationalVector d = Rational(ray.direction);
                   const double sine = std::abs(Dot(d, normal).get_d()) /
                                       Length(Dot(normal, normal)) /
                                       Length(Dot(d, d));
                   least = std::min(least, sine * std::ldexp(1.0, exponent));
                   most = std::max(most, sine * std::ldexp(1.0, exponent));
                 });
      EXPECT_GE(least, exponent < 2 ? 0.4 : 0.65) << exponent;
      EXPECT_LE(most, 1.25) << exponent;
    }
  }
}

TYPED_TEST(RayScenesHardTest, NeedlesHaveTheAltitudeOfTheirName) {
  using T = TypeParam;
  for (const RayLoop loop : kRayLoops) {
    for (const int aspect : {0, 8, std::numeric_limits<T>::digits - 8}) {
      ForEachRay(MakeRays<T>(With("rays_needle:aspect=", aspect), loop),
                 [&](const Triangle3<T>& t, const Ray<T>&) {
                   const RationalVector e = Minus(Rational(t.b), Rational(t.a));
                   const RationalVector normal =
                       Cross(e, Minus(Rational(t.c), Rational(t.a)));
                   const double length = Length(Dot(e, e));
                   const double altitude = Length(Dot(normal, normal)) / length;
                   EXPECT_NEAR(length, 1, 1e-4);
                   EXPECT_NEAR(std::ldexp(altitude, aspect), 1, 0.1);
                 });
    }
  }
}

TYPED_TEST(RayScenesHardTest, FarOriginsAndOffsetsAreAsFarAsTheirNames) {
  using T = TypeParam;
  for (const RayLoop loop : kRayLoops) {
    for (const int k : {4, 12, 30}) {
      const double size = std::ldexp(1.0, k);
      ForEachRay(MakeRays<T>(With("rays_far_origin:exponent=", k), loop),
                 [&](const Triangle3<T>&, const Ray<T>& ray) {
                   const RationalVector o = Rational(ray.origin);
                   const RationalVector d = Rational(ray.direction);
                   EXPECT_NEAR(Length(Dot(o, o)) / size, 1, 4 / size + 1e-6);
                   EXPECT_NEAR(Length(Dot(d, d)), 1, 1e-6);
                 });
      ForEachRay(MakeRays<T>(With("rays_offset:ratio=", k), loop),
                 [&](const Triangle3<T>& t, const Ray<T>& ray) {
                   for (const Point3<T>& p : {t.a, t.b, t.c, ray.origin}) {
                     for (const T x : {p.x, p.y, p.z}) {
                       EXPECT_NEAR(static_cast<double>(x) / size, 1,
                                   7 / size + 1e-6);
                     }
                   }
                 });
    }
  }
}

TYPED_TEST(RayScenesHardTest, DegenerateScenesHaveNothingElse) {
  for (const RayLoop loop : kRayLoops) {
    for (const std::string kind :
         {"collinear", "doubled", "single", "zero_direction"}) {
      const auto positions =
          Positions(MakeRays<TypeParam>("rays_degenerate:kind=" + kind, loop));
      EXPECT_EQ(positions.size(), 1u) << kind;
      EXPECT_EQ(positions.begin()->first, RayPosition::kDegenerate) << kind;
    }
    const auto parallel =
        Positions(MakeRays<TypeParam>("rays_degenerate:kind=parallel", loop));
    EXPECT_EQ(parallel.size(), 1u) << Name(loop);
    EXPECT_EQ(parallel.begin()->first, RayPosition::kCoplanar);
  }
}

TYPED_TEST(RayScenesHardTest, SpecialScenesHaveTheNumbersOfTheirNames) {
  using T = TypeParam;
  using Limits = std::numeric_limits<T>;
  for (const RayLoop loop : kRayLoops) {
    const auto count = [&](const std::string& kind, const auto& is) {
      std::size_t triangles = 0;
      std::size_t rays = 0;
      ForEachRay(MakeRays<T>("rays_special:kind=" + kind, loop),
                 [&](const Triangle3<T>& t, const Ray<T>& ray) {
                   const auto any = [&](const auto& points) {
                     return std::ranges::any_of(points, [&](const auto& p) {
                       return is(p.x) || is(p.y) || is(p.z);
                     });
                   };
                   triangles += any(std::array{t.a, t.b, t.c}) ? 1 : 0;
                   rays += any(std::array{ray.origin, ray.direction}) ? 1 : 0;
                 });
      EXPECT_GT(triangles, 100u) << kind << " " << Name(loop);
      EXPECT_GT(rays, 100u) << kind << " " << Name(loop);
    };
    count("nan", [](T x) { return std::isnan(x); });
    count("infinite", [](T x) { return std::isinf(x); });
    count("minus_zero", [](T x) { return x == 0 && std::signbit(x); });
    count("subnormal", [](T x) { return std::fpclassify(x) == FP_SUBNORMAL; });
    count("largest", [](T x) { return std::abs(x) == Limits::max(); });
  }
}

// Where the numbers are none, about a half and a quarter of the rest are hit as
// usual, so a kernel cannot pass by missing everything.
TYPED_TEST(RayScenesHardTest, NotFiniteScenesHaveHitsToo) {
  for (const std::string kind : {"nan", "infinite"}) {
    auto positions = Positions(
        MakeRays<TypeParam>("rays_special:kind=" + kind, RayLoop::kRayPairs));
    EXPECT_GT(positions[RayPosition::kHit], 20u) << kind;
  }
}

}  // namespace
}  // namespace pitbench
