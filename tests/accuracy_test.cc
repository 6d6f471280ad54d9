// What is written of a kernel's accuracy is what was counted.
#include "harness/measure/accuracy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "harness/measure/statistics.h"
#include "kernels/kernels.h"
#include "tests/spoiled_kernel.h"

namespace pitbench {
namespace {

using nlohmann::json;

// Newcombe, Statistics in Medicine 17 (1998), table I, method 3.
TEST(Wilson95Test, AgreesWithNewcombesTable) {
  const struct {
    std::size_t count, of;
    double low, high;
  } published[] = {{81, 263, 0.2553, 0.3662},
                   {15, 148, 0.0624, 0.1605},
                   {0, 20, 0, 0.1611},
                   {1, 29, 0.0061, 0.1718}};
  for (const auto& [count, of, low, high] : published) {
    const Interval interval = Wilson95(count, of);
    EXPECT_NEAR(interval.low, low, 5e-5) << count << " of " << of;
    EXPECT_NEAR(interval.high, high, 5e-5) << count << " of " << of;
  }
}

TEST(Wilson95Test, EndsAreExactAndNothingSeenSaysNothing) {
  EXPECT_EQ(Wilson95(0, 20).low, 0);
  EXPECT_EQ(Wilson95(20, 20).high, 1);
  EXPECT_EQ(Wilson95(0, 0).low, 0);
  EXPECT_EQ(Wilson95(0, 0).high, 1);
  EXPECT_NEAR(Wilson95(20, 20).low, 1 - Wilson95(0, 20).high, 1e-15);
}

constexpr auto kMistakes = [](const Batch<float>& batch,
                              const Result<float>& result) {
  if (*batch.bx == 4) {
    Set(result.bits, kInNearB, false);
    Set(result.bits, kOutLeft, true);
    Set(result.bits, kOutFar, true);
    Set(result.bits, kOnA, false);
  } else {
    Set(result.bits, kInNearA, true);
  }
};

// The one cell of a kernel on the hand-made scene.
json CellOf(const Kernel& kernel) {
  const json cells = MeasureAccuracyOn(HandMadeScene(), {&kernel});
  EXPECT_EQ(cells.size(), 1u);
  return cells.at(0);
}

void ExpectShare(const json& entry, std::size_t count, std::size_t of) {
  EXPECT_EQ(entry.at("count"), count);
  EXPECT_EQ(entry.at("of"), of);
  EXPECT_EQ(entry.at("low"), Wilson95(count, of).low);
  EXPECT_EQ(entry.at("high"), Wilson95(count, of).high);
}

TEST(AccuracyTest, MistakesAreCountedByKind) {
  const json cell = CellOf(SpoiledKernel<Output::kInside, kMistakes>());
  EXPECT_EQ(cell.at("name"),
            "one_triangle/own/barycentric_determinant_closed/f32/scalar");
  EXPECT_EQ(cell.at("boundary_rule"), "closed");
  EXPECT_EQ(cell.at("accepts"), "triangle");
  EXPECT_EQ(cell.at("points"), 18);
  EXPECT_EQ(cell.at("interior"), 3);
  EXPECT_EQ(cell.at("exterior"), 3);
  EXPECT_EQ(cell.at("boundary"), 2);
  EXPECT_EQ(cell.at("degenerate"), 8);
  EXPECT_EQ(cell.at("not_finite"), 2);
  const json& classes = cell.at("classes");
  ExpectShare(classes.at("false_outside"), 1, 3);
  ExpectShare(classes.at("false_inside"), 3, 3 + 8);
  ExpectShare(classes.at("boundary_accepted"), 1, 2);
  EXPECT_EQ(classes.at("boundary_accepted").at("distance_ulps"), nullptr);
  EXPECT_EQ(classes.at("boundary_accepted").at("worst"), json::array());
  EXPECT_EQ(cell.at("weights"), nullptr);
}

// An ulp at 1 is 2^-23, at 5 2^-21. (1, 1) lies on the degenerate triangle;
// (5, 5) is 3√2 behind BC, and (−1, 1) is 1 to the left of AC. An ulp at 2 is
// 2^-22; (2, 1) is 1/√2 before BC.
TEST(AccuracyTest, DistancesAndTheWorstInputsAreTold) {
  const json cell = CellOf(SpoiledKernel<Output::kInside, kMistakes>());
  const json& inside = cell.at("classes").at("false_inside");
  EXPECT_EQ(inside.at("distance_ulps").at("smallest"), 0);
  const double largest = inside.at("distance_ulps").at("largest");
  EXPECT_NEAR(largest, 3 * std::sqrt(2) * 0x1p21, 1);
  ASSERT_EQ(inside.at("worst").size(), 2u);
  const json& worst = inside.at("worst").at(0);
  EXPECT_EQ(worst.at("said"), "inside");
  EXPECT_EQ(worst.at("distance_ulps"), largest);
  EXPECT_EQ(worst.at("a"), (json{"0x0p+0", "0x0p+0"}));
  EXPECT_EQ(worst.at("b"), (json{"0x1p+2", "0x0p+0"}));
  EXPECT_EQ(worst.at("c"), (json{"0x0p+0", "0x1p+2"}));
  EXPECT_EQ(worst.at("p"), (json{"0x1.4p+2", "0x1.4p+2"}));
  EXPECT_EQ(inside.at("worst").at(1).at("p"), (json{"-0x1p+0", "0x1p+0"}));
  EXPECT_EQ(inside.at("worst").at(1).at("distance_ulps"), 0x1p23);
  const json& outside = cell.at("classes").at("false_outside");
  ASSERT_EQ(outside.at("worst").size(), 1u);
  EXPECT_EQ(outside.at("worst").at(0).at("said"), "outside");
  const json& distance = outside.at("distance_ulps");
  EXPECT_NEAR(distance.at("smallest").get<double>(), 0x1p22 / std::sqrt(2), 1);
  EXPECT_EQ(distance.at("smallest"), distance.at("largest"));
}

TEST(AccuracyTest, RightKernelHasNoDistanceAndNoWorstInput) {
  const json cell = CellOf(OneTriangleKernel("cross_product", Output::kInside));
  EXPECT_EQ(cell.at("classes").size(), 9u);
  for (const auto& [name, entry] : cell.at("classes").items()) {
    EXPECT_EQ(entry.at("count"), name == "boundary_accepted" ? 2 : 0) << name;
    EXPECT_EQ(entry.at("distance_ulps"), nullptr) << name;
    EXPECT_EQ(entry.at("worst"), json::array()) << name;
  }
}

// Of the eight finite points of the one triangle that has weights: an error of
// 2^-20 is 8 ulps of 1, and a NaN is told apart.
TEST(AccuracyTest, ErrorsOfWeightsAreInUlpsOfOne) {
  constexpr auto kOff = [](const Batch<float>& batch,
                           const Result<float>& result) {
    if (*batch.bx != 4) return;
    result.w[0][kInNearA] += 0x1p-20f;
    result.w[2][kOutFar] = std::numeric_limits<float>::infinity();
  };
  const json weights =
      CellOf(SpoiledKernel<Output::kWeights, kOff>()).at("weights");
  EXPECT_EQ(weights.at("points"), 8);
  EXPECT_EQ(weights.at("largest_ulps"), 8);
  EXPECT_EQ(weights.at("mean_ulps"), 8.0 / 23);
  EXPECT_EQ(weights.at("not_finite"), 1);
}

// The weight of B is 2^-20 too large at (2, 1): 4 times that beside the point,
// where an ulp is 2^-22.
TEST(AccuracyTest, ForwardErrorIsThatOfTheInterpolatedPoint) {
  constexpr auto kOff = [](const Batch<float>& batch,
                           const Result<float>& result) {
    if (*batch.bx == 4) result.w[1][kInNearB] += 0x1p-20f;
  };
  const json weights =
      CellOf(SpoiledKernel<Output::kWeights, kOff>()).at("weights");
  EXPECT_EQ(weights.at("largest_ulps"), 8);
  EXPECT_EQ(weights.at("largest_forward_ulps"), 16);
  EXPECT_EQ(weights.at("mean_forward_ulps"), 16.0 / 8);
}

}  // namespace
}  // namespace pitbench
