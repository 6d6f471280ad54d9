// What is timed, how often, and what is not.
#include "harness/measure/speed.h"

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>

#include "harness/measure/clock.h"
#include "kernels/kernels.h"
#include "tests/spoiled_kernel.h"

namespace pitbench {
namespace {

using nlohmann::json;

// The scalar kernels that only answer, on one scene.
SpeedRun TimeScalar(const Scene<float>& scene) {
  return MeasureSpeedOn({scene}, {}, std::regex("one_triangle/.*/scalar$"),
                        1e-5);
}

std::map<std::string, std::vector<json>> RowsByName(const json& file) {
  std::map<std::string, std::vector<json>> rows;
  for (const json& row : file.at("benchmarks")) {
    if (row.at("run_type") == "iteration") {
      rows[row.at("run_name")].push_back(row);
    }
  }
  return rows;
}

TEST(SpeedTest, EveryRepetitionOfEveryCellIsKept) {
  const SpeedRun run = TimeScalar(HandMadeScene());
  const auto rows = RowsByName(run.file);
  EXPECT_EQ(rows.size(), run.cells);
  EXPECT_EQ(run.refused, 0u);
  const auto found = rows.find("one_triangle/own/edge_function/f32/scalar");
  ASSERT_NE(found, rows.end());
  ASSERT_EQ(found->second.size(), std::size_t{kRepetitions});
  for (const json& row : found->second) {
    EXPECT_EQ(row.at("items"), 9);
    EXPECT_EQ(row.at("working_set_bytes"), 6 * 4 + 9 * 2 * 4);
    EXPECT_GT(row.at("iterations"), 0);
    // Each call decides nine points. Google Benchmark's rates are by the time
    // that the CPU was ours.
    const double seconds = row.at("cpu_time").get<double>() * 1e-9;
    EXPECT_NEAR(row.at("items_per_second").get<double>() * seconds, 9, 1e-6);
  }
  EXPECT_FALSE(run.file.at("context").contains("host_name"));
}

// 2^70 overflows where products are squared again: the answer of
// uv_projection is wrong and no rounding explains it, so it has no time.
TEST(SpeedTest, WrongKernelHasAReasonAndNoNumbers) {
  Scene<float> scene{.name = "own", .loop = Loop::kOneTriangle};
  scene.Add(Triangle<float>{{0, 0}, {0x1p40f, 0}, {0, 0x1p40f}});
  scene.Add(Point<float>{0x1p38f, 0x1p38f});
  scene.calls = {{0, 0, 1}};
  const SpeedRun run = TimeScalar(scene);
  EXPECT_EQ(run.refused, 1u);
  const auto rows = RowsByName(run.file);
  for (const auto& [name, repetitions] : rows) {
    const bool refused = name.find("uv_projection") != std::string::npos;
    for (const json& row : repetitions) {
      EXPECT_EQ(row.value("error_occurred", false), refused) << name;
      EXPECT_EQ(row.contains("items_per_second"), !refused) << name;
      if (refused) {
        EXPECT_EQ(row.at("error_message")
                      .get<std::string>()
                      .rfind("says outside of (0x1p+38, 0x1p+38)", 0),
                  0u)
            << row;
      }
    }
  }
}

// What the same kernel seems to differ from itself by is noise.
TEST(SpeedTest, OneKernelOfALoopIsRegisteredTwice) {
  const SpeedRun run =
      MeasureSpeedOn({HandMadeScene()}, {},
                     std::regex("one_triangle/.*/edge_function/"), 1e-5);
  std::size_t twins = 0;
  for (const auto& [name, rows] : RowsByName(run.file)) {
    if (name.ends_with("/twin")) {
      ++twins;
      EXPECT_EQ(rows.size(), std::size_t{kRepetitions});
    }
  }
  EXPECT_EQ(twins, RunsHere(Isa::kAvx2) || RunsHere(Isa::kNeon) ? 1u : 0u);
}

TEST(SpeedTest, NoCellIsNoError) {
  const SpeedRun run =
      MeasureSpeedOn({HandMadeScene()}, {}, std::regex("nothing"), 1e-5);
  EXPECT_EQ(run.cells, 0u);
}

TEST(ClockTest, RunsAsFastAsClocksDo) {
  EXPECT_GT(ClockGhz(), 0.1);
  EXPECT_LT(ClockGhz(), 10);
}

}  // namespace
}  // namespace pitbench
