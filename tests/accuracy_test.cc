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

json Rate(std::size_t count, std::size_t of) {
  return {{"count", count},
          {"of", of},
          {"low", Wilson95(count, of).low},
          {"high", Wilson95(count, of).high}};
}

TEST(AccuracyTest, MistakesAreCountedByKind) {
  const json cell = CellOf(SpoiledKernel<Output::kInside, kMistakes>());
  EXPECT_EQ(cell.at("name"),
            "one_triangle/own/barycentric_determinant_closed/f32/scalar");
  EXPECT_EQ(cell.at("boundary_rule"), "closed");
  EXPECT_EQ(cell.at("accepts"), "triangle");
  EXPECT_EQ(cell.at("points"), 18);
  EXPECT_EQ(cell.at("interior"), 3);
  EXPECT_EQ(cell.at("exterior"), 5);
  EXPECT_EQ(cell.at("boundary"), 2);
  EXPECT_EQ(cell.at("degenerate"), 8);
  EXPECT_EQ(cell.at("false_outside"), Rate(1, 3));
  EXPECT_EQ(cell.at("false_inside"), Rate(3, 5 + 8));
  EXPECT_EQ(cell.at("boundary_accepted"), Rate(1, 2));
  EXPECT_EQ(cell.at("weights"), nullptr);
}

// An ulp at 1 is 2^-23, at 5 2^-21. (1, 1) lies on the degenerate triangle;
// (5, 5) is 3√2 behind BC.
TEST(AccuracyTest, DistancesAndTheWorstInputAreTold) {
  const json cell = CellOf(SpoiledKernel<Output::kInside, kMistakes>());
  EXPECT_EQ(cell.at("error_distance_ulps").at("smallest"), 0);
  const double largest = cell.at("error_distance_ulps").at("largest");
  EXPECT_NEAR(largest, 3 * std::sqrt(2) * 0x1p21, 1);
  ASSERT_EQ(cell.at("worst").size(), 1u);
  const json& worst = cell.at("worst").at(0);
  EXPECT_EQ(worst.at("kind"), "false_inside");
  EXPECT_EQ(worst.at("distance_ulps"), largest);
  EXPECT_EQ(worst.at("a"), (json{"0x0p+0", "0x0p+0"}));
  EXPECT_EQ(worst.at("b"), (json{"0x1p+2", "0x0p+0"}));
  EXPECT_EQ(worst.at("c"), (json{"0x0p+0", "0x1p+2"}));
  EXPECT_EQ(worst.at("p"), (json{"0x1.4p+2", "0x1.4p+2"}));
}

TEST(AccuracyTest, RightKernelHasNoDistanceAndNoWorstInput) {
  const json cell = CellOf(OneTriangleKernel("cross_product", Output::kInside));
  EXPECT_EQ(cell.at("false_outside"), Rate(0, 3));
  EXPECT_EQ(cell.at("false_inside"), Rate(0, 13));
  EXPECT_EQ(cell.at("error_distance_ulps"), nullptr);
  EXPECT_EQ(cell.at("worst"), json::array());
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

}  // namespace
}  // namespace pitbench
