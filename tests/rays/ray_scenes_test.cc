// Scenes of rays are what their names say, by exact arithmetic.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <string>

#include "harness/scenes/rays/ray_corpus.h"
#include "harness/truth/ray_truth.h"
#include "tests/rays/made_ray_scene.h"
#include "tests/rays/rational_vectors.h"

namespace pitbench {
namespace {

template <class T>
class RayScenesTest : public testing::Test {};
using Floats = testing::Types<float, double>;
TYPED_TEST_SUITE(RayScenesTest, Floats);

// How far the ray's line passes from the line through a and b, of from a where
// both are the same.
template <class T>
double DistanceFrom(const Point3<T>& a, const Point3<T>& b, const Ray<T>& ray) {
  const RationalVector d = Rational(ray.direction);
  const RationalVector to_a = Minus(Rational(a), Rational(ray.origin));
  const RationalVector edge = Minus(Rational(b), Rational(a));
  const RationalVector across = Cross(d, edge);
  const mpq_class squared = Dot(across, across);
  if (squared == 0) {
    const RationalVector off = Cross(to_a, d);
    return Length(Dot(off, off) / Dot(d, d));
  }
  return std::abs(Dot(to_a, across).get_d()) / Length(squared);
}
template <class T>
double NearestEdge(const Triangle3<T>& t, const Ray<T>& ray) {
  return std::min({DistanceFrom(t.a, t.b, ray), DistanceFrom(t.b, t.c, ray),
                   DistanceFrom(t.c, t.a, ray)});
}
template <class T>
double NearestVertex(const Triangle3<T>& t, const Ray<T>& ray) {
  return std::min({DistanceFrom(t.a, t.a, ray), DistanceFrom(t.b, t.b, ray),
                   DistanceFrom(t.c, t.c, ray)});
}

// Within five standard deviations of a binomial count, of as many trials as are
// independent: one_triangle repeats its rays, one_ray its triangles.
TYPED_TEST(RayScenesTest, UniformHasTheHitRateOfItsName) {
  for (const RayLoop loop : kRayLoops) {
    for (const int hit : {0, 10, 50, 90, 100}) {
      auto scene = MakeRays<TypeParam>(
          With("rays_uniform:hit=", hit) +
              (loop == RayLoop::kOneRay ? ":bytes=4k" : ":bytes=96k"),
          loop);
      if (loop != RayLoop::kOneRay) scene.calls.resize(8);  // is enough
      auto positions = Positions(scene);
      double all = 0;
      for (const auto& [position, count] : positions) {
        all += static_cast<double>(count);
      }
      const double rate =
          static_cast<double>(positions[RayPosition::kHit]) / all;
      const double expected = hit / 100.0;
      const double trials = static_cast<double>(
          loop == RayLoop::kOneRay ? std::min(scene.Probes(), scene.Triangles())
                                   : scene.calls[0].n);
      EXPECT_NEAR(rate, expected,
                  5 * std::sqrt(expected * (1 - expected) / trials))
          << Name(loop) << ", " << hit << " %";
      EXPECT_EQ(positions[RayPosition::kDegenerate], 0u);
      EXPECT_EQ(positions[RayPosition::kCoplanar], 0u);
    }
  }
}

TYPED_TEST(RayScenesTest, UniformHasTheSizeOfItsName) {
  for (const RayLoop loop : kRayLoops) {
    for (const std::size_t kilobytes : {4, 24, 512}) {
      const auto scene = MakeRays<TypeParam>(
          "rays_uniform:hit=50:bytes=" + std::to_string(kilobytes) +
              "k:sets=fixed",
          loop);
      ASSERT_EQ(scene.calls.size(), 1u);
      const std::size_t bytes = scene.BytesRead(scene.calls[0]);
      EXPECT_LE(bytes, kilobytes * 1024 + 9 * sizeof(TypeParam));
      EXPECT_GT(bytes, kilobytes * 1024 - 15 * sizeof(TypeParam));
    }
    for (const std::size_t n : {1, 16, 4096}) {
      const auto scene = MakeRays<TypeParam>(
          "rays_uniform:hit=50:n=" + std::to_string(n), loop);
      EXPECT_GE(scene.calls.size(), 32u);
      for (const RayCall& call : scene.calls) EXPECT_EQ(call.n, n);
    }
  }
}

TYPED_TEST(RayScenesTest, FixedTwinIsTheFirstFreshSet) {
  for (const RayLoop loop : kRayLoops) {
    for (const std::string name :
         {"rays_uniform:hit=50:bytes=4k", "rays_near_edge:ulps=1",
          "rays_grazing:exponent=9"}) {
      const auto fresh = MakeRays<TypeParam>(name + ":sets=fresh", loop);
      const auto fixed = MakeRays<TypeParam>(name + ":sets=fixed", loop);
      EXPECT_GE(fresh.calls.size(), 30u);
      ASSERT_EQ(fixed.calls.size(), 1u);
      ASSERT_EQ(fixed.calls[0].n, fresh.calls[0].n);
      for (std::size_t i = 0; i < fixed.calls[0].n; ++i) {
        const auto numbers = [i](const auto& scene) {
          const auto t = scene.TriangleOf(scene.calls[0], i);
          const auto ray = scene.RayOf(scene.calls[0], i);
          return std::array{t.a.x,        t.b.y,           t.c.z,
                            ray.origin.x, ray.direction.y, ray.direction.z};
        };
        ASSERT_EQ(numbers(fixed), numbers(fresh)) << Name(loop) << " " << i;
      }
    }
  }
}

// Each axis is the longest of the direction of many rays, so that no branch of
// a method always goes one way.
TYPED_TEST(RayScenesTest, UniformRaysGoAlongNoAxisMostly) {
  std::array<std::size_t, 3> longest = {};
  std::size_t all = 0;
  ForEachRay(MakeRays<TypeParam>("rays_uniform:hit=50:n=3000:sets=fixed",
                                 RayLoop::kRayPairs),
             [&](const auto&, const auto& ray) {
               const auto& d = ray.direction;
               ++longest[d.x >= d.y && d.x >= d.z ? 0 : d.y >= d.z ? 1 : 2];
               ++all;
             });
  for (const std::size_t count : longest) EXPECT_GT(count, all / 6);
}

// A step is at most half an ulp of 1, which is also what rounds the target; the
// direction, below 4, rounds by four times that in each coordinate. Where the
// triangle is made for the ray, vertices up to 8 round instead.
template <class T>
double Reach(RayLoop loop, double steps) {
  const double step =
      static_cast<double>(std::numeric_limits<T>::epsilon()) / 2;
  return (steps + (loop == RayLoop::kOneRay ? 32 : 8)) * step;
}

// `family` passes what `distance_of` measures from within `most` steps a step
// of its name, and hardly any nearer than a sixtieth of that; without steps
// some exactly and some not.
template <class T, class Distance>
void ExpectBeside(const std::string& family, double most,
                  const Distance& distance_of) {
  for (const RayLoop loop : kRayLoops) {
    for (const int ulps : {0, 1, 16, 4096}) {
      std::size_t far = 0;
      std::size_t exact = 0;
      std::size_t all = 0;
      ForEachRay(MakeRays<T>(With(family + ":ulps=", ulps), loop),
                 [&](const Triangle3<T>& t, const Ray<T>& ray) {
                   const double distance = distance_of(t, ray);
                   ++all;
                   EXPECT_LE(distance, Reach<T>(loop, most * ulps));
                   far += distance >= Reach<T>(loop, ulps) / 64 ? 1 : 0;
                   exact += distance == 0 ? 1 : 0;
                 });
      if (ulps == 4096) {
        EXPECT_GT(far, all * 9 / 10) << Name(loop);
      }
      if (ulps == 0) {
        EXPECT_GT(exact, all / 8) << Name(loop);
        EXPECT_LT(exact, all * 9 / 10) << Name(loop);
      }
    }
  }
}

TYPED_TEST(RayScenesTest, NearEdgeRaysPassAnEdgeThatManyUlpsAway) {
  ExpectBeside<TypeParam>("rays_near_edge", 1, NearestEdge<TypeParam>);
}

// Along all three axes: √3.
TYPED_TEST(RayScenesTest, NearVertexRaysPassAVertexThatManyUlpsAway) {
  ExpectBeside<TypeParam>("rays_near_vertex", 1.733, NearestVertex<TypeParam>);
}

TYPED_TEST(RayScenesTest, RangeIsFromZeroToInfinity) {
  for (const FamilyInfo& family : Families()) {
    if (!IsRayFamily(family.name)) continue;
    std::string name(family.name);
    for (const auto& [key, value] : {std::pair{"hit", ":hit=50:n=16"},
                                     {"ulps", ":ulps=1"},
                                     {"exponent", ":exponent=4"},
                                     {"aspect", ":aspect=4"},
                                     {"ratio", ":ratio=4"}}) {
      if (family.parameters.starts_with(key)) name += value;
    }
    if (family.parameters.starts_with("kind")) {
      name += family.name == "rays_special" ? ":kind=nan" : ":kind=single";
    }
    for (const RayLoop loop : kRayLoops) {
      const auto scene = MakeRays<TypeParam>(name, loop);
      EXPECT_EQ(scene.name, name);
      EXPECT_EQ(scene.loop, loop);
      EXPECT_EQ(scene.t_min, 0);
      EXPECT_EQ(scene.t_max, std::numeric_limits<TypeParam>::infinity());
      EXPECT_FALSE(scene.calls.empty()) << name;
      for (const RayCall& call : scene.calls) {
        const bool one_triangle = loop == RayLoop::kOneTriangleRays;
        const bool one_ray = loop == RayLoop::kOneRay;
        EXPECT_LE(call.triangle + (one_triangle ? 1 : call.n),
                  scene.Triangles());
        EXPECT_LE(call.ray + (one_ray ? 1 : call.n), scene.Probes());
      }
    }
  }
}

// Expected values are what the exact arithmetic of a separate program says of
// the numbers in the file.
TEST(RayCorpusTest, TruthIsWhatTheFileSays) {
  const auto cases = RayCorpus();
  EXPECT_GE(cases.size(), 12u);
  std::set<std::string> ids;
  for (const RayCase& one : cases) {
    EXPECT_TRUE(ids.insert(one.id).second) << one.id << " twice";
    EXPECT_TRUE(one.source.starts_with("https://")) << one.id;
    const RayPosition position =
        one.scalar == "f32"
            ? Classify(one.TriangleAs<float>(), one.RayAs<float>())
            : Classify(one.TriangleAs<double>(), one.RayAs<double>());
    EXPECT_EQ(Name(position), one.truth) << one.id;
  }
}

TEST(RayScenesErrorTest, AParameterOutOfRangeSaysWhatIsAllowed) {
  const auto error = [](const std::string& name) -> std::string {
    try {
      MakeRays<float>(name, RayLoop::kRayPairs);
    } catch (const SceneError& caught) {
      return caught.what();
    }
    return "none";
  };
  EXPECT_EQ(error("rays_near_edge:ulps=65537"),
            "scene 'rays_near_edge:ulps=65537': ulps must be a whole number "
            "from 0 to 65536, not '65537'");
  EXPECT_EQ(error("rays_grazing:exponent=61"),
            "scene 'rays_grazing:exponent=61': exponent must be a whole number "
            "from 0 to 60, not '61'");
  EXPECT_EQ(error("rays_special:kind=big"),
            "scene 'rays_special:kind=big': kind must be one of nan, infinite, "
            "minus_zero, subnormal, largest, not 'big'");
  EXPECT_EQ(
      error("rays_icosphere:ulps=-1"),
      "scene 'rays_icosphere:ulps=-1': ulps must be a whole number from 0 "
      "to 65536, not '-1'");
  EXPECT_EQ(error("rays_needle:ulps=1"),
            "scene 'rays_needle:ulps=1' must have the form "
            "'rays_needle:aspect=…'");
  EXPECT_EQ(error("rays_neddle:aspect=1"),
            "no scene 'rays_neddle': did you mean 'rays_needle'?");
  EXPECT_EQ(
      error("near_edge:ulps=1"),
      "scene 'near_edge:ulps=1' has no rays: the names of those that have "
      "begin with rays_");
}

TEST(RayScenesErrorTest, ScenesOfPointsAreNotMadeOfRays) {
  try {
    MakeScene<float>(ParseScene("rays_corpus"), Loop::kPairs, {}, 1);
    ADD_FAILURE() << "no error";
  } catch (const SceneError& caught) {
    EXPECT_STREQ(
        caught.what(),
        "scene 'rays_corpus' is one of rays, which loop pairs does not "
        "take");
  }
}

}  // namespace
}  // namespace pitbench
