// Every class of errors counts what it is named after, and nothing else.
#include "harness/measure/classes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "harness/measure/accuracy.h"
#include "harness/measure/distance_estimate.h"
#include "harness/truth/weights.h"
#include "kernels/kernels.h"
#include "tests/judged_scene.h"
#include "tests/spoiled_kernel.h"

namespace pitbench {
namespace {

using nlohmann::json;

json ClassesOf(const Kernel& kernel, const Scene<float>& scene) {
  return MeasureAccuracyOn(scene, {&kernel}).at(0).at("classes");
}

void Clear(const Batch<float>& batch, const Result<float>& result) {
  std::fill_n(result.bits, BitBytes(batch.n), std::uint8_t{0});
}

// The classes of change in which something is counted, out of the three inner
// and three outer points of the hand-made triangle.
std::vector<std::string> Changing(const Kernel& kernel) {
  std::vector<std::string> changing;
  const json classes = ClassesOf(kernel, HandMadeScene());
  for (const char* name :
       {"reversed_winding", "rotated_vertices", "swapped_vertices", "negated",
        "scaled_by_power_of_two"}) {
    const json& entry = classes.at(name);
    EXPECT_EQ(entry.at("of"), 6) << name;
    if (entry.at("count") == 0) continue;
    EXPECT_EQ(entry.at("count"), 3) << name;
    // (1, 1) is 1 from two sides, where an ulp is 2^-23; (2, 1) and (1, 2) are
    // 1/√2 from BC, where an ulp is 2^-22.
    EXPECT_EQ(entry.at("distance_ulps").at("largest"), 0x1p23) << name;
    EXPECT_NEAR(entry.at("distance_ulps").at("smallest").get<double>(),
                0x1p22 / std::sqrt(2), 1)
        << name;
    EXPECT_EQ(entry.at("worst").size(), 2u) << name;
    EXPECT_EQ(entry.at("worst").at(0).at("said"), "inside") << name;
    changing.emplace_back(name);
  }
  return changing;
}

using Names = std::vector<std::string>;

TEST(ClassesTest, RightKernelChangesNothing) {
  EXPECT_EQ(Changing(OneTriangleKernel("cross_product", Output::kInside)),
            Names{});
}

// Exchanging A and B reverses the winding as well: counted once.
TEST(ClassesTest, KernelThatWantsAWindingChangesWithIt) {
  constexpr auto kCounterClockwise = [](const Batch<float>& b,
                                        const Result<float>& result) {
    if ((*b.bx - *b.ax) * (*b.cy - *b.ay) < (*b.by - *b.ay) * (*b.cx - *b.ax)) {
      Clear(b, result);
    }
  };
  EXPECT_EQ(Changing(SpoiledKernel<Output::kInside, kCounterClockwise>()),
            Names{"reversed_winding"});
}

TEST(ClassesTest, KernelThatWantsAVertexFirstChangesWithTheOrder) {
  constexpr auto kOriginFirst = [](const Batch<float>& b,
                                   const Result<float>& result) {
    if (*b.ax != 0 || *b.ay != 0) Clear(b, result);
  };
  EXPECT_EQ(Changing(SpoiledKernel<Output::kInside, kOriginFirst>()),
            (Names{"rotated_vertices", "swapped_vertices"}));
}

TEST(ClassesTest, KernelThatWantsPositiveCoordinatesChangesWithTheSign) {
  constexpr auto kPositive = [](const Batch<float>& b,
                                const Result<float>& result) {
    if (std::min({*b.ax, *b.bx, *b.cx}) < 0) Clear(b, result);
  };
  EXPECT_EQ(Changing(SpoiledKernel<Output::kInside, kPositive>()),
            Names{"negated"});
}

TEST(ClassesTest, KernelWithALengthInItChangesWithTheScale) {
  constexpr auto kSmall = [](const Batch<float>& b,
                             const Result<float>& result) {
    if (std::max({*b.ax, *b.bx, *b.cx}) > 1000) Clear(b, result);
  };
  EXPECT_EQ(Changing(SpoiledKernel<Output::kInside, kSmall>()),
            Names{"scaled_by_power_of_two"});
}

TEST(ClassesTest, SubnormalScenesAreNotScaled) {
  Scene<float> scene = HandMadeScene();
  scene.px[0] = 0x1p-140f;
  const json classes =
      ClassesOf(OneTriangleKernel("cross_product", Output::kInside), scene);
  EXPECT_FALSE(classes.contains("scaled_by_power_of_two"));
  EXPECT_TRUE(classes.contains("negated"));
}

constexpr auto kAcceptsNaN = [](const Batch<float>& b,
                                const Result<float>& result) {
  for (std::size_t i = 0; i < b.n; ++i) {
    if (std::isnan(b.px[i])) Set(result.bits, i, true);
  }
};

TEST(ClassesTest, AcceptedNaNOfTheSceneIsNoFalseInside) {
  const json classes =
      ClassesOf(SpoiledKernel<Output::kInside, kAcceptsNaN>(), HandMadeScene());
  EXPECT_EQ(classes.at("false_inside").at("count"), 0);
  const json& accepted = classes.at("not_finite_accepted");
  EXPECT_EQ(accepted.at("count"), 2);
  EXPECT_EQ(accepted.at("of"), 2);
  EXPECT_EQ(accepted.at("distance_ulps"), nullptr);
  EXPECT_EQ(accepted.at("worst").at(0).at("p"), (json{"nan", "0x1p+0"}));
}

// Into a finite scene they are put: into triangle 0, which makes its four
// answers not finite, and into points 1 (its x) and 3 (its y).
TEST(ClassesTest, FiniteScenesAreAskedAboutNaN) {
  Scene<float> scene{.name = "own", .loop = Loop::kOneTriangle};
  scene.Add(Triangle<float>{{0, 0}, {4, 0}, {0, 4}});
  scene.Add(Triangle<float>{{0, 0}, {4, 0}, {0, 4}});
  for (int i = 0; i < 4; ++i) scene.Add(Point<float>{1, 1});
  scene.calls = {{0, 0, 4}, {1, 0, 4}};
  const json classes =
      ClassesOf(SpoiledKernel<Output::kInside, kAcceptsNaN>(), scene);
  EXPECT_EQ(classes.at("false_inside").at("count"), 0);
  EXPECT_EQ(classes.at("not_finite_accepted").at("of"), 4 + 2);
  EXPECT_EQ(classes.at("not_finite_accepted").at("count"), 2);
}

// Two triangles that share the edge from (0, 0) to (4, 4), which is BC of both,
// and three points that each is asked about: below, above and on it.
Scene<float> TwoTriangles() {
  Scene<float> scene{.name = "own", .loop = Loop::kOneTriangle};
  scene.Add(Triangle<float>{{4, 0}, {4, 4}, {0, 0}});
  scene.Add(Triangle<float>{{0, 4}, {0, 0}, {4, 4}});
  scene.Add(Point<float>{3, 1});
  scene.Add(Point<float>{1, 3});
  scene.Add(Point<float>{2, 2});
  scene.calls = {{0, 0, 3}, {1, 0, 3}};
  scene.query = {0, 1, 2, 0, 1, 2};
  return scene;
}

TEST(ClassesTest, ClosedTrianglesBothClaimTheEdgeBetweenThem) {
  const json classes = ClassesOf(
      OneTriangleKernel("cross_product", Output::kInside), TwoTriangles());
  EXPECT_EQ(classes.at("hole").at("count"), 0);
  EXPECT_EQ(classes.at("hole").at("of"), 3);
  const json& hits = classes.at("double_hit");
  EXPECT_EQ(hits.at("count"), 1);
  EXPECT_EQ(hits.at("of"), 3);
  EXPECT_EQ(hits.at("distance_ulps").at("largest"), 0);
  EXPECT_EQ(hits.at("worst").at(0).at("p"), (json{"0x1p+1", "0x1p+1"}));
  EXPECT_EQ(hits.at("worst").at(0).at("said"), "inside");
}

TEST(ClassesTest, HalfOpenTrianglesLeaveAHoleAtBc) {
  const json classes =
      ClassesOf(OneTriangleKernel("barycentric_determinant", Output::kInside),
                TwoTriangles());
  EXPECT_EQ(classes.at("double_hit").at("count"), 0);
  EXPECT_EQ(classes.at("hole").at("count"), 1);
  EXPECT_EQ(classes.at("hole").at("worst").at(0).at("p"),
            (json{"0x1p+1", "0x1p+1"}));
  EXPECT_EQ(classes.at("hole").at("worst").at(0).at("said"), "outside");
}

// The lower triangle gives up its point and takes its neighbour's: a hole is
// shown with the triangle that holds the point, a double hit with the one that
// does not.
TEST(ClassesTest, ClaimsAreShownWithTheTriangleThatIsWrong) {
  constexpr auto kExchanged = [](const Batch<float>& b,
                                 const Result<float>& result) {
    if (*b.ax != 4) return;
    Set(result.bits, 0, false);
    Set(result.bits, 1, true);
    Set(result.bits, 2, false);
  };
  const json classes =
      ClassesOf(SpoiledKernel<Output::kInside, kExchanged>(), TwoTriangles());
  for (const char* name : {"hole", "double_hit"}) {
    const json& entry = classes.at(name);
    EXPECT_EQ(entry.at("count"), 1) << name;
    ASSERT_EQ(entry.at("worst").size(), 1u) << name;
    EXPECT_EQ(entry.at("worst").at(0).at("a"), (json{"0x1p+2", "0x0p+0"}))
        << name;
  }
}

TEST(ClassesTest, ScenesWithoutQueriesHaveNoHoles) {
  const json classes = ClassesOf(
      OneTriangleKernel("cross_product", Output::kInside), HandMadeScene());
  EXPECT_FALSE(classes.contains("hole"));
  EXPECT_FALSE(classes.contains("double_hit"));
}

// What failing answers are chosen by, against what is then told.
template <class T>
void EstimatesAreNear(const char* name) {
  const Scene<T>& scene = FindJudgedScene<T>(name, Loop::kPairs).scene;
  for (std::size_t i = 0; i < scene.ax.size(); ++i) {
    const Triangle<T> t = scene.TriangleAt(i);
    const Point<T> p = scene.PointAt(i);
    const double exact = BoundaryDistanceInUlps(t, p);
    // Coordinates are at most 4; relative to the point's they are this large.
    const double ratio =
        4 / static_cast<double>(std::max(std::abs(p.x), std::abs(p.y)));
    EXPECT_NEAR(DistanceEstimate(t, p), exact, 0x1p-10 * ratio + 1e-10 * exact)
        << name << " " << i;
  }
}

TEST(DistanceEstimateTest, IsNearTheExactDistance) {
  for (const char* name : {"near_edge:ulps=1", "needle:aspect=10"}) {
    EstimatesAreNear<float>(name);
    EstimatesAreNear<double>(name);
  }
}

}  // namespace
}  // namespace pitbench
