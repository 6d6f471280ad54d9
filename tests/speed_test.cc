// What is timed, how often, and what is not.
#include "harness/measure/speed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "harness/input/name_filter.h"
#include "harness/measure/clock.h"
#include "harness/measure/threads.h"
#include "kernels/kernels.h"
#include "tests/spoiled_kernel.h"

namespace pitbench {
namespace {

using nlohmann::json;

// The scalar kernels that only answer, on one scene.
SpeedRun TimeScalar(const Scene<float>& scene) {
  return MeasureSpeedOn({scene}, {}, NameFilter("one_triangle/.*/scalar$"),
                        {1e-5});
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
    // Each call decides nine points, and what passes is the real time.
    const double seconds = row.at("real_time").get<double>() * 1e-9;
    EXPECT_NEAR(row.at("items_per_second").get<double>() * seconds, 9, 1e-6);
  }
  EXPECT_FALSE(run.file.at("context").contains("host_name"));
  EXPECT_GT(run.occupancy.wall_seconds, 0);
  EXPECT_GT(run.occupancy.cpu_seconds, 0);
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
                     NameFilter("one_triangle/.*/edge_function/"), {1e-5});
  std::size_t twins = 0;
  for (const auto& [name, rows] : RowsByName(run.file)) {
    if (name.ends_with("/twin")) {
      ++twins;
      EXPECT_EQ(rows.size(), std::size_t{kRepetitions});
    }
  }
  const bool some =
      RunsHere(Isa::kSse4) || RunsHere(Isa::kAvx2) || RunsHere(Isa::kNeon);
  EXPECT_EQ(twins, some ? 1u : 0u);
}

TEST(SpeedTest, WhereWiderOnesAreLeftOutANarrowerKernelIsRegisteredTwice) {
  if (!RunsHere(Isa::kSse4)) GTEST_SKIP();
  const SpeedRun run = MeasureSpeedOn(
      {HandMadeScene()}, {},
      NameFilter("one_triangle/.*/edge_function/f32/(scalar|ssse3|sse4)$"),
      {1e-5});
  const auto rows = RowsByName(run.file);
  EXPECT_EQ(rows.size(), 3u + 2u);
  EXPECT_TRUE(rows.contains("one_triangle/own/edge_function/f32/sse4/twin"));
  EXPECT_TRUE(rows.contains("one_triangle/own/edge_function/f32/sse4/doubled"));
}

double MedianTime(const std::vector<json>& rows) {
  std::vector<double> times;
  for (const json& row : rows) times.push_back(row.at("real_time"));
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

// The kernel of which a twin is timed, made to last: so that what the clock
// itself costs, and other processes, do not show.
TEST(SpeedTest, TwoCallsTimedAsOneTakeTwiceTheTime) {
  Kernel lasting = OneTriangleKernel("edge_function", Output::kInside);
  lasting.isa = Isa::kAvx2;
  lasting.f32 = [](const Batch<float>& batch, const Result<float>& result) {
    static const Kernel kernel =
        OneTriangleKernel("edge_function", Output::kInside);
    const auto start = std::chrono::steady_clock::now();
    kernel.f32(batch, result);
    while (std::chrono::steady_clock::now() - start <
           std::chrono::microseconds(20)) {
    }
  };
  const SpeedRun run = MeasureKernels({&lasting}, HandMadeScene(), {1e-4});
  const auto rows = RowsByName(run.file);
  const std::string name = "one_triangle/own/edge_function/f32/avx2";
  const double plain = MedianTime(rows.at(name));
  EXPECT_NEAR(MedianTime(rows.at(name + "/twin")) / plain, 1, 0.4);
  EXPECT_NEAR(MedianTime(rows.at(name + "/doubled")) / plain, 2, 0.4);
  // Both calls are of a batch as every other row's.
  EXPECT_EQ(rows.at(name + "/doubled")[0].at("items"), 9);
}

#if !defined(PITBENCH_FEWER_KERNELS)  // which has no placements
// The first scene of a shard shows what another place does to a kernel.
TEST(SpeedTest, PlacementsAreTimedOnceAShard) {
  Scene<float> again = HandMadeScene();
  again.name = "again";
  const SpeedRun run =
      MeasureSpeedOn({HandMadeScene(), again}, {},
                     NameFilter("one_triangle/.*/cross_product/"), {1e-5});
  std::set<std::string> placed;
  for (const auto& [name, rows] : RowsByName(run.file)) {
    if (name.find("/placed_") == std::string::npos) continue;
    EXPECT_EQ(rows.size(), std::size_t{kRepetitions});
    placed.insert(name);
  }
  std::set<std::string> expected;
  for (const Isa isa : {Isa::kAvx2, Isa::kAvx512, Isa::kNeon}) {
    if (!RunsHere(isa)) continue;
    for (const char* shift : {"0", "16", "32", "48"}) {
      expected.insert("one_triangle/own/cross_product/f32/" +
                      std::string(Name(isa)) + "/placed_" + shift);
    }
  }
  EXPECT_EQ(placed, expected);
}
#endif

// All CPUs together read what one alone reads, and each number of them has its
// own row.
TEST(SpeedTest, ThreadsShareTheItemsOfACall) {
  Profile profile{.name = "tiny", .speed_budget = {1e-5}};
  profile.speed = {{"uniform:hit=50:n=10000:sets=fresh",
                    {Loop::kOneTriangle},
                    Scalar::kF32,
                    /*weights=*/false,
                    {"cross_product"},
                    {Isa::kScalar},
                    /*threads=*/true}};
  const SpeedRun run =
      MeasureSpeed(profile, NameFilter("/threads$"), kDefaultSeed);
  const auto rows = RowsByName(run.file);
  ASSERT_EQ(rows.size(), ThreadCounts().size());
  for (const int threads : ThreadCounts()) {
    const auto found = rows.find(
        "one_triangle/uniform:hit=50:n=10000:sets=fresh/cross_product/f32/"
        "scalar/threads:" +
        std::to_string(threads));
    ASSERT_NE(found, rows.end());
    ASSERT_EQ(found->second.size(), std::size_t{kRepetitions});
    for (const json& row : found->second) {
      EXPECT_EQ(row.at("items"), 10000);
      EXPECT_EQ(row.at("working_set_bytes"), 6 * 4 + 10000 * 2 * 4);
      EXPECT_NEAR(row.at("items_per_second").get<double>() *
                      row.at("real_time").get<double>() * 1e-9,
                  10000, 1e-3);
    }
  }
}

// What a kernel was called with.
struct Seen {
  const float* triangle;
  const float* point;
  std::size_t n;
  const std::uint8_t* bits;
};
std::vector<Seen> g_seen;
Kernel g_real;

class LongCallTest : public testing::TestWithParam<Loop> {};

TEST_P(LongCallTest, IsTimedInPartsThatAreTheWhole) {
  constexpr std::size_t kItems = (std::size_t{1} << 21) + 100;
  const bool one_triangle = GetParam() == Loop::kOneTriangle;
  const bool one_point = GetParam() == Loop::kOnePoint;
  Scene<float> scene{.name = "long", .loop = GetParam()};
  for (std::size_t k = 0; k < (one_triangle ? 1 : kItems); ++k) {
    scene.Add(Triangle<float>{{0, 0}, {4, 0}, {0, 4}});
  }
  for (std::size_t k = 0; k < (one_point ? 1 : kItems); ++k) {
    scene.Add(Point<float>{1, 1});
  }
  scene.calls = {{0, 0, kItems}};
  g_real = ScalarKernel("edge_function", GetParam(), Output::kInside);
  Kernel kernel = g_real;
  kernel.f32 = [](const Batch<float>& batch, const Result<float>& result) {
    g_seen.push_back({batch.ax, batch.px, batch.n, result.bits});
    g_real.f32(batch, result);
  };
  g_seen.clear();
  const SpeedRun run = MeasureKernels({&kernel}, scene, {1e-5});
  ASSERT_EQ(RowsByName(run.file).size(), 1u);
  // The last pass.
  std::size_t first = g_seen.size();
  std::size_t items = 0;
  while (items < kItems && first != 0) {
    items += g_seen[--first].n;
    if (first + 1 == g_seen.size()) continue;
    const Seen& part = g_seen[first];
    const Seen& next = g_seen[first + 1];
    EXPECT_EQ(part.triangle + (one_triangle ? 0 : part.n), next.triangle);
    EXPECT_EQ(part.point + (one_point ? 0 : part.n), next.point);
    EXPECT_EQ(part.bits + part.n / 8, next.bits);
  }
  EXPECT_EQ(items, kItems);
  EXPECT_GT(g_seen.size() - first, 30u);
}

INSTANTIATE_TEST_SUITE_P(Loops, LongCallTest,
                         testing::Values(Loop::kOneTriangle, Loop::kOnePoint,
                                         Loop::kPairs));

TEST(ThreadsTest, PartsFollowEachOtherAndAreTheWhole) {
  for (const std::size_t n : {0, 1, 63, 64, 1000, 1 << 20}) {
    for (const std::size_t threads : {1, 2, 3, 64}) {
      std::size_t next = 5;
      for (std::size_t k = 0; k < threads; ++k) {
        const Call part = PartOf({7, 5, n}, Loop::kOneTriangle, k, threads);
        EXPECT_EQ(part.triangle, 7u);
        EXPECT_EQ(part.point, next);
        EXPECT_EQ((part.point - 5) % 64, 0u) << "a part begins within a line";
        next += part.n;
      }
      EXPECT_EQ(next, 5 + n);
    }
  }
}

TEST(SpeedTest, NoCellIsNoError) {
  const SpeedRun run =
      MeasureSpeedOn({HandMadeScene()}, {}, NameFilter("nothing"), {1e-5});
  EXPECT_EQ(run.cells, 0u);
}

TEST(ClockTest, RunsAsFastAsClocksDo) {
  EXPECT_GT(MeasurePace().clock_ghz, 0.1);
  EXPECT_LT(MeasurePace().clock_ghz, 10);
}

// Independent operations do not wait for each other, unlike those of the chain.
TEST(ClockTest, ThroughputIsAboveOneOperationACycle) {
  const Pace pace = MeasurePace();
  EXPECT_GT(pace.throughput_gops, 1.2 * pace.clock_ghz);
}

}  // namespace
}  // namespace pitbench
