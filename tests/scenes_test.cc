// Scenes are what their names say.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "harness/measure/answers.h"
#include "harness/scenes/generate.h"
#include "harness/truth/weights.h"
#include "tests/made_scene.h"

namespace pitbench {
namespace {

template <class T>
class ScenesTest : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(ScenesTest, Scalars);

// Within five standard deviations of a binomial count, of as many trials as
// are independent: one_triangle repeats its points, one_point its triangles.
TYPED_TEST(ScenesTest, UniformHasTheHitRateOfItsName) {
  for (const Loop loop : kLoops) {
    for (const int hit : {0, 10, 50, 90, 100}) {
      auto scene = Make<TypeParam>(
          "uniform:hit=" + std::to_string(hit) +
              (loop == Loop::kOnePoint ? ":bytes=1k" : ":bytes=32k") +
              ":sets=fresh",
          loop);
      if (loop == Loop::kOneTriangle) scene.calls.resize(8);  // is enough
      const SceneTruth truth = JudgeScene(scene);
      const double all = static_cast<double>(truth.interior + truth.exterior +
                                             truth.boundary + truth.degenerate);
      const double rate = static_cast<double>(truth.interior) / all;
      const double expected = hit / 100.0;
      const double trials = static_cast<double>(
          loop == Loop::kOnePoint ? std::min(scene.px.size(), scene.ax.size())
                                  : scene.px.size());
      EXPECT_NEAR(rate, expected,
                  5 * std::sqrt(expected * (1 - expected) / trials))
          << Name(loop) << ", " << hit << " %";
      EXPECT_EQ(truth.degenerate, 0u);
    }
  }
}

TYPED_TEST(ScenesTest, UniformCallReadsAboutTheBytesOfItsName) {
  for (const Loop loop : kLoops) {
    for (const std::size_t kilobytes : {4, 24, 512}) {
      const auto scene = Make<TypeParam>(
          "uniform:hit=50:bytes=" + std::to_string(kilobytes) + "k:sets=fixed",
          loop);
      ASSERT_EQ(scene.calls.size(), 1u);
      const std::size_t bytes = scene.BytesRead(scene.calls[0]);
      EXPECT_LE(bytes, kilobytes * 1024 + 6 * sizeof(TypeParam));
      EXPECT_GT(bytes, kilobytes * 1024 - 8 * sizeof(TypeParam));
    }
  }
}

// Every call has another triangle, so that each pays for its set-up.
TYPED_TEST(ScenesTest, UniformCallHasAsManyItemsAsItsName) {
  for (const Loop loop : kLoops) {
    for (const std::size_t n : {1, 16, 4096}) {
      const auto scene = Make<TypeParam>(
          "uniform:hit=50:n=" + std::to_string(n) + ":sets=fresh", loop);
      std::set<TypeParam> triangles;
      for (const Call& call : scene.calls) {
        EXPECT_EQ(call.n, n);
        triangles.insert(scene.TriangleOf(call, 0).a.x);
      }
      if (loop == Loop::kOneTriangle) {
        EXPECT_EQ(triangles.size(), scene.calls.size());
        EXPECT_GE(scene.calls.size(), 256u);
      }
    }
  }
}

TYPED_TEST(ScenesTest, FixedTwinIsTheFirstFreshSet) {
  for (const Loop loop : kLoops) {
    const auto fresh =
        Make<TypeParam>("uniform:hit=50:bytes=4k:sets=fresh", loop);
    const auto fixed =
        Make<TypeParam>("uniform:hit=50:bytes=4k:sets=fixed", loop);
    EXPECT_GE(fresh.calls.size(), 32u);
    ASSERT_EQ(fixed.calls.size(), 1u);
    ASSERT_EQ(fixed.calls[0].n, fresh.calls[0].n);
    for (std::size_t i = 0; i < fixed.calls[0].n; ++i) {
      const auto numbers = [i](const auto& scene) {
        const auto t = scene.TriangleOf(scene.calls[0], i);
        const auto p = scene.PointOf(scene.calls[0], i);
        return std::array{t.a.x, t.a.y, t.b.x, t.b.y, t.c.x, t.c.y, p.x, p.y};
      };
      ASSERT_EQ(numbers(fixed), numbers(fresh)) << Name(loop) << ", item " << i;
    }
  }
}

TYPED_TEST(ScenesTest, FreshSetsHaveDifferentAnswers) {
  for (const Loop loop : kLoops) {
    const auto scene =
        Make<TypeParam>("uniform:hit=50:bytes=4k:sets=fresh", loop);
    const SceneTruth truth = JudgeScene(scene);
    for (std::size_t c = 1; c < scene.calls.size(); ++c) {
      EXPECT_NE(truth.calls[c].inside, truth.calls[0].inside) << Name(loop);
    }
  }
}

// ulps steps along one axis are at most that many ulps across the edge, and
// rounding the point onto the edge moved it by √½ at most. Before that came two
// roundings of doubles up to 1, 2^-54 each, in either coordinate; of f32 they
// are nothing. Where the triangle is made for the point (one_point), its
// vertices round too, by up to an ulp of 2, which is 2^k ulps of a point below
// 2^-k.
TYPED_TEST(ScenesTest, NearEdgePointsAreThatManyUlpsFromTheEdge) {
  constexpr int kDigits = std::numeric_limits<TypeParam>::digits;
  for (const int ulps : {0, 1, 16, 256}) {
    for (const Loop loop : {Loop::kOneTriangle, Loop::kPairs}) {
      std::size_t far = 0;
      ForEachAnswer(
          Make<TypeParam>("near_edge:ulps=" + std::to_string(ulps), loop),
          [&](const auto& t, const auto& p) {
            const double distance = BoundaryDistanceInUlps(t, p);
            const double ulp =
                std::ldexp(1.0, std::ilogb(std::max(p.x, p.y)) + 1 - kDigits);
            EXPECT_LE(distance, ulps + 0.7072 + 0x1.6a1p-53 / ulp);
            far += distance >= ulps / 4.0 ? 1u : 0u;
          });
      EXPECT_GT(far, kSize.groups * kSize.size / 2);
    }
    std::size_t near = 0;
    std::size_t all = 0;
    ForEachAnswer(Make<TypeParam>("near_edge:ulps=" + std::to_string(ulps),
                                  Loop::kOnePoint),
                  [&](const auto& t, const auto& p) {
                    ++all;
                    near += BoundaryDistanceInUlps(t, p) <= ulps + 4 ? 1u : 0u;
                  });
    EXPECT_GT(near, all * 8 / 10);
  }
}

TYPED_TEST(ScenesTest, NearEdgePointsLieOnBothSides) {
  for (const Loop loop : kLoops) {
    const SceneTruth truth =
        JudgeScene(Make<TypeParam>("near_edge:ulps=16", loop));
    EXPECT_GT(truth.interior, kSize.groups * kSize.size / 3);
    EXPECT_GT(truth.exterior, kSize.groups * kSize.size / 3);
  }
}

TYPED_TEST(ScenesTest, NeedleHasLengthOneAndTheAltitudeOfItsName) {
  for (const int aspect : {0, 5, 10}) {
    for (const Loop loop : kLoops) {
      std::size_t inside = 0;
      ForEachAnswer(
          Make<TypeParam>("needle:aspect=" + std::to_string(aspect), loop),
          [&](const auto& t, const auto& p) {
            const double ex = double{t.b.x} - double{t.a.x};
            const double ey = double{t.b.y} - double{t.a.y};
            const double length = std::hypot(ex, ey);
            const double altitude = (ex * (double{t.c.y} - double{t.a.y}) -
                                     ey * (double{t.c.x} - double{t.a.x})) /
                                    length;
            EXPECT_NEAR(length, 1, 1e-6);
            EXPECT_NEAR(std::ldexp(altitude, aspect), 1, 1e-3);
            const auto w = ExactWeights(t, p);
            EXPECT_LT(std::abs(w[2].get_d() - 0.5), 1.501);
            inside += Classify(t, p) == Position::kInside ? 1u : 0u;
          });
      EXPECT_GT(inside, kSize.groups * kSize.size / 20);
    }
  }
}

TYPED_TEST(ScenesTest, OffsetLiesInAUnitSquareThatFarAway) {
  for (const int ratio : {0, 4, 20}) {
    const double corner = std::ldexp(1.0, ratio);
    for (const Loop loop : kLoops) {
      const auto scene =
          Make<TypeParam>("offset:ratio=" + std::to_string(ratio), loop);
      for (const auto* array : {&scene.ax, &scene.ay, &scene.bx, &scene.by,
                                &scene.cx, &scene.cy, &scene.px, &scene.py}) {
        for (const TypeParam x : *array) {
          EXPECT_GE(double{x}, corner);
          EXPECT_LE(double{x}, corner + 1);
        }
      }
    }
  }
}

TEST(GridSceneTest, VerticesAreThePixelsAndReachEveryCorner) {
  const auto scene = MakeScene<std::int32_t>(
      ParseScene("grid_80x50:sets=fresh"), Loop::kGrid, {}, kDefaultSeed);
  EXPECT_EQ(scene.width, 80u);
  EXPECT_EQ(scene.height, 50u);
  for (const auto* xs : {&scene.ax, &scene.bx, &scene.cx}) {
    EXPECT_EQ(*std::min_element(xs->begin(), xs->end()), 0);
    EXPECT_EQ(*std::max_element(xs->begin(), xs->end()), 79);
  }
  for (const auto* ys : {&scene.ay, &scene.by, &scene.cy}) {
    EXPECT_EQ(*std::min_element(ys->begin(), ys->end()), 0);
    EXPECT_EQ(*std::max_element(ys->begin(), ys->end()), 49);
  }
}

template <class T>
void ExpectTheGridAsPoints() {
  const auto grid = MakeScene<std::int32_t>(ParseScene("grid_80x50:sets=fresh"),
                                            Loop::kGrid, {}, kDefaultSeed);
  const auto points = MakeScene<T>(ParseScene("grid_points_80x50:sets=fresh"),
                                   Loop::kOneTriangle, {}, kDefaultSeed);
  ASSERT_EQ(points.calls.size(), grid.ax.size());
  EXPECT_TRUE(std::equal(grid.ax.begin(), grid.ax.end(), points.ax.begin()));
  EXPECT_TRUE(std::equal(grid.cy.begin(), grid.cy.end(), points.cy.begin()));
  const std::size_t pixels = grid.width * grid.height;
  for (std::size_t i = 0; i < points.calls.size(); ++i) {
    EXPECT_EQ(points.calls[i].triangle, i);
    EXPECT_EQ(points.calls[i].point, 0u);
    EXPECT_EQ(points.calls[i].n, pixels);
  }
  for (std::size_t i = 0; i < pixels; ++i) {
    const Point<std::int32_t> pixel = grid.PointOf(grid.calls[0], i);
    EXPECT_EQ(points.px[i], pixel.x);
    EXPECT_EQ(points.py[i], pixel.y);
  }
}

TEST(GridSceneTest, AsPointsItHasTheSameTrianglesAndPixelsInEveryScalar) {
  ExpectTheGridAsPoints<std::int32_t>();
  ExpectTheGridAsPoints<std::int16_t>();
  ExpectTheGridAsPoints<std::uint8_t>();
}

// What the error says of a scene that cannot be made.
std::string Error(const std::string& name, Loop loop = Loop::kOneTriangle) {
  try {
    MakeScene<float>(ParseScene(name), loop, kSize, kDefaultSeed);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no error";
}

TEST(SceneErrorTest, UnknownFamilySuggestsTheNearest) {
  EXPECT_EQ(Error("unifrom:hit=50"),
            "no scene 'unifrom': did you mean 'uniform'?");
  EXPECT_EQ(Error(""), Error(std::string()));
  EXPECT_EQ(Error("grid"), "no scene 'grid': did you mean 'own'?");
}

TEST(SceneErrorTest, WrongKeysShowTheForm) {
  const std::string form =
      "must have the form 'uniform:hit=…:bytes|n=…:sets=…'";
  for (const char* name :
       {"uniform", "uniform:hit=50", "uniform:bytes=4k:hit=50:sets=fresh",
        "uniform:hit=50:bytes=4k:sets=fresh:more=1",
        "uniform:hit:bytes=4k:sets=fresh", "uniform:::"}) {
    EXPECT_NE(Error(name).find(form), std::string::npos) << Error(name);
  }
}

TEST(SceneErrorTest, ValuesOutOfRangeNameTheRange) {
  EXPECT_EQ(Error("near_edge:ulps=-1"),
            "scene 'near_edge:ulps=-1': ulps must be a whole number from 0 to "
            "65536, not '-1'");
  for (const char* name :
       {"uniform:hit=101:bytes=4k:sets=fresh", "uniform:hit=50:n=0:sets=fresh",
        "uniform:hit=50:bytes=1:sets=fresh",
        "uniform:hit=50:bytes=9999999M:sets=fresh", "needle:aspect=61",
        "needle:aspect=", "needle:aspect=1e3", "needle:aspect=3.5",
        "offset:ratio=k", "offset:ratio=99999999999999999999"}) {
    EXPECT_NE(Error(name).find("must be a whole number"), std::string::npos)
        << name << ": " << Error(name);
  }
  EXPECT_EQ(Error("offset:ratio=1:sets=both"),
            "scene 'offset:ratio=1:sets=both': sets must be one of fresh, "
            "fixed, not 'both'");
  EXPECT_EQ(Error("scale:exponent=-146"),
            "scene 'scale:exponent=-146': exponent must be a whole number from "
            "-145 to 127, not '-146'");
  EXPECT_EQ(Error("degenerate:kind=flat"),
            "scene 'degenerate:kind=flat': kind must be one of collinear, "
            "doubled, single, not 'flat'");
}

TEST(SceneErrorTest, GridIsForGridLoopsAndIntegersOnly) {
  EXPECT_NE(Error("grid_80x50:sets=fresh").find("no meaning"),
            std::string::npos);
  EXPECT_NE(Error("grid_points_80x50:sets=fresh").find("no meaning"),
            std::string::npos);
  EXPECT_NE(Error("needle:aspect=3", Loop::kGrid).find("no meaning"),
            std::string::npos);
  EXPECT_NE(Error("own").find("your own files"), std::string::npos);
}

}  // namespace
}  // namespace pitbench
