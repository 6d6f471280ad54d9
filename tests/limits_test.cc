// The limits are of what they say, and no loop was folded away. Only ratios of
// one run are looked at, and only such as hold beside a busy neighbour.
#include "harness/limits/limits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "harness/input/name_filter.h"
#include "harness/limits/probes.h"
#include "harness/scenes/scene.h"

namespace pitbench {
namespace {

using nlohmann::json;

constexpr std::size_t kKibi = 1 << 10;
constexpr std::size_t kMebi = 1 << 20;
constexpr std::size_t kStep = 6 * kKibi;  // what is walked is a multiple of it

TEST(MemoryLevelsTest, HalfOfOwnCachesAndLessOfTheSharedOne) {
  const auto levels =
      MemoryLevels({48 * kKibi, kMebi, 32 * kMebi}, 8192 * kMebi);
  ASSERT_EQ(levels.size(), 4u);
  EXPECT_EQ(levels[0].name, "L1");
  EXPECT_EQ(levels[0].probed, 24 * kKibi);
  EXPECT_EQ(levels[1].name, "L2");
  // Whole steps of 6 KiB, which is 1 KiB a stream.
  EXPECT_EQ(levels[1].probed, 510 * kKibi);
  EXPECT_EQ(levels[2].name, "L3");
  // sqrt(1 · 32) = 5.66 MiB = 5792 KiB, which is 965 steps.
  EXPECT_EQ(levels[2].probed, 965 * 6 * kKibi);
  EXPECT_EQ(levels[3].name, "DRAM");
  EXPECT_EQ(levels[3].capacity, 0u);
  EXPECT_EQ(levels[3].probed, 128 * kMebi / (6 * kKibi) * (6 * kKibi));
}

TEST(MemoryLevelsTest, EachSetFitsItsLevelAndNoNearerOne) {
  for (const std::vector<std::size_t>& caches :
       {std::vector{32 * kKibi, 256 * kKibi, 8 * kMebi},
        {48 * kKibi, 2 * kMebi, 260 * kMebi},
        {64 * kKibi, kMebi},
        {128 * kKibi, 12 * kMebi}}) {
    const auto levels = MemoryLevels(caches, 4096 * kMebi);
    ASSERT_EQ(levels.size(), caches.size() + 1);
    for (std::size_t k = 0; k < levels.size(); ++k) {
      if (k > 0) {
        EXPECT_GT(levels[k].probed, caches[k - 1]) << levels[k].name;
      }
      if (k < caches.size()) {
        EXPECT_LT(levels[k].probed, caches[k]);
      }
    }
  }
}

TEST(DataCachesTest, InstructionsAreLeftOutAndLevelsInOrder) {
  const json caches = {{{"level", 2}, {"type", "Unified"}, {"bytes", 1000}},
                       {{"level", 1}, {"type", "Instruction"}, {"bytes", 7}},
                       {{"level", 1}, {"type", "Data"}, {"bytes", 100}}};
  EXPECT_EQ(DataCaches(caches), (std::vector<std::size_t>{100, 1000}));
  EXPECT_EQ(DataCaches(json::array()).size(), 3u)
      << "a guess where none is told";
}

// An emulator's own work, and what sanitizers insert, hide how fast loads and
// operations are.
#if PITBENCH_SLOW
constexpr bool kRatesTell = false;
constexpr double kSeconds = 1e-5;
constexpr int kRepetitions = 2;
#else
constexpr bool kRatesTell = true;
constexpr double kSeconds = 3e-4;
constexpr int kRepetitions = 7;
#endif

// Bytes and operations a second by name, of probes that walk small sets.
class MeasuredTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const std::vector<MemoryLevel> levels = {
        {"L1", 32 * kKibi, 12 * kKibi},
        {"L2", kMebi, (PITBENCH_SLOW ? 4 : 42) * kStep},
        {"DRAM", 0, (PITBENCH_SLOW ? 8 : 8192) * kStep},
    };
    limits_ = new json(
        MeasureLimits(levels, NameFilter("."), kSeconds, kRepetitions));
  }
  static void TearDownTestSuite() { delete limits_; }

  // The best over the numbers of streams.
  static std::map<std::string, double> Loads(const std::string& level) {
    std::map<std::string, double> best;
    for (const json& row : limits_->at("memory")) {
      if (row.at("level") != level || row.at("access") != "load") continue;
      if (row.at("scalars").at(0) != "f32") continue;
      double& value = best[row.at("isa")];
      value = std::max(value, row.at("bytes_per_second").get<double>());
    }
    return best;
  }
  static std::map<std::string, double> Rates(const std::string& operation,
                                             const std::string& scalar) {
    std::map<std::string, double> rates;
    for (const json& row : limits_->at("operations")) {
      if (row.at("operation") != operation || row.at("scalar") != scalar) {
        continue;
      }
      rates[row.at("isa")] = row.at("operations_per_second");
    }
    return rates;
  }

  static const json* limits_;
};
const json* MeasuredTest::limits_ = nullptr;

TEST_F(MeasuredTest, EveryIsaThatRunsHereHasEveryLimitOnce) {
  std::set<std::string> isas;
  for (const Kernel& kernel : AllKernels()) {
    const std::string isa(Name(kernel.isa));
    if (RunsHere(kernel.isa) && !isa.starts_with("autovec")) isas.insert(isa);
  }
  std::set<std::tuple<std::string, std::string, std::string>> seen;
  for (const json& row : limits_->at("operations")) {
    EXPECT_TRUE(
        seen.emplace(row.at("isa"), row.at("scalar"), row.at("operation"))
            .second)
        << row;
    EXPECT_TRUE(isas.contains(row.at("isa"))) << row;
  }
  for (const std::string& isa : isas) {
    for (const char* scalar : {"f32", "f64", "i32", "i16", "u8"}) {
      for (const char* operation : {"add", "min_max", "compare"}) {
        EXPECT_TRUE(seen.contains({isa, scalar, operation}))
            << isa << scalar << operation;
      }
    }
    for (const char* operation : {"mixed", "add_min_max_compare"}) {
      EXPECT_TRUE(seen.contains({isa, "f32", operation})) << isa << operation;
      EXPECT_TRUE(seen.contains({isa, "f64", operation})) << isa << operation;
    }
    EXPECT_EQ(seen.contains({isa, "f32", "multiply_multiply_add"}),
              seen.contains({isa, "f32", "multiply_add"}))
        << isa;
    EXPECT_TRUE(seen.contains({isa, "i16", "integer_multiply"})) << isa;
    for (const char* level : {"L1", "L2", "DRAM"}) {
      EXPECT_TRUE(Loads(level).contains(isa)) << isa << " " << level;
    }
  }
}

TEST_F(MeasuredTest, TheBestIsNoLessThanTheMedianAndThatThanTheLowest) {
  for (const char* part : {"memory", "operations"}) {
    const char* quantity = std::string(part) == "memory"
                               ? "bytes_per_second"
                               : "operations_per_second";
    for (const json& row : limits_->at(part)) {
      EXPECT_GE(row.at(quantity), row.at("median")) << row;
      EXPECT_GE(row.at("median"), row.at("lowest")) << row;
      EXPECT_GT(row.at("lowest"), 0) << row;
    }
  }
}

TEST_F(MeasuredTest, NearerIsNotSlower) {
  if (!kRatesTell) GTEST_SKIP();
  for (const auto& [isa, near] : Loads("L1")) {
    EXPECT_GE(near, 0.75 * Loads("L2").at(isa)) << isa;
    EXPECT_GE(near, 0.75 * Loads("DRAM").at(isa)) << isa;
  }
}

// Within a chain of ISAs, each of which has what those before it have.
TEST_F(MeasuredTest, WiderIsNotSlower) {
  if (!kRatesTell) GTEST_SKIP();
  const std::vector<std::vector<std::string>> chains = {
      {"scalar", "ssse3", "sse4", "avx2", "avx512"}, {"scalar", "neon"}};
  for (const char* scalar : {"f32", "f64"}) {
    for (const char* operation : {"add", "multiply", "min_max", "mixed"}) {
      const auto rates = Rates(operation, scalar);
      for (const auto& chain : chains) {
        for (std::size_t k = 1; k < chain.size(); ++k) {
          if (!rates.contains(chain[k])) continue;
          EXPECT_GT(rates.at(chain[k]), 0.5 * rates.at(chain[k - 1]))
              << operation << " " << scalar << " " << chain[k];
        }
      }
    }
  }
}

// Division is slower than multiplication on every CPU, and two units do at
// least what the slower of them does alone.
TEST_F(MeasuredTest, OperationsRankAsTheyMust) {
  if (!kRatesTell) GTEST_SKIP();
  for (const char* scalar : {"f32", "f64"}) {
    for (const auto& [isa, divide] : Rates("divide", scalar)) {
      EXPECT_LT(divide, Rates("multiply", scalar).at(isa)) << scalar << isa;
      EXPECT_GT(Rates("mixed", scalar).at(isa),
                0.5 * std::min(Rates("add", scalar).at(isa),
                               Rates("multiply", scalar).at(isa)))
          << scalar << isa;
      EXPECT_GT(Rates("add_min_max_compare", scalar).at(isa),
                0.5 * std::min({Rates("add", scalar).at(isa),
                                Rates("min_max", scalar).at(isa),
                                Rates("compare", scalar).at(isa)}))
          << scalar << isa;
    }
  }
}

// Of each part the fastest pass of all repetitions counts, so the limit may be
// more than any repetition came to; of what is short it is the best of them,
// which of two is also the upper median.
TEST(MeasureLimitsTest, WhatIsLongIsTimedInPartsAsLongCallsAre) {
  const std::vector<MemoryLevel> levels = {
      {"L1", 32 * kKibi, 12 * kKibi},
      {"DRAM", 0, 16 * kMebi / kStep * kStep + kStep}};
  const json found =
      MeasureLimits(levels, NameFilter("^load/.*/scalar$"), 1e-5, 2);
  std::size_t more = 0;
  for (const json& row : found.at("memory")) {
    const double limit = row.at("bytes_per_second");
    const double best = row.at("median");
    EXPECT_GE(limit, best) << row;
    if (row.at("level") == "DRAM") {
      more += limit > best ? 1u : 0u;
    } else {
      EXPECT_EQ(limit, best) << row;
    }
  }
  EXPECT_GT(more, 0u);
}

TEST(MeasureLimitsTest, TheFilterChooses) {
  const std::vector<MemoryLevel> levels = {{"L1", 32 * kKibi, 12 * kKibi}};
  const json found =
      MeasureLimits(levels, NameFilter("^add/f32/scalar$"), 1e-5, 1);
  ASSERT_EQ(found.at("operations").size(), 1u);
  EXPECT_EQ(found.at("operations")[0].at("operation"), "add");
  EXPECT_TRUE(found.at("memory").empty());
}

TEST(ProbesTest, OperationsAreCountedByLanesAndRounds) {
  for (const OperationProbe& probe : OperationProbes()) {
    if (!RunsHere(probe.isa)) continue;
    const std::size_t once = probe.run(1);
    EXPECT_GT(once, 0u);
    EXPECT_EQ(probe.run(7), 7 * once);
    if (probe.scalar != "f32" || probe.isa == Isa::kScalar) continue;
    for (const OperationProbe& other : OperationProbes()) {
      if (other.isa == probe.isa && other.operation == probe.operation &&
          other.scalar == "f64") {
        EXPECT_EQ(once, 2 * other.run(1)) << Name(probe.isa);
      }
    }
  }
}

// A loop that the compiler folded takes the same time for any number of rounds.
TEST(ProbesTest, MoreRoundsTakeLonger) {
  constexpr std::size_t kRounds = PITBENCH_SLOW ? 100 : 1000;
  // The least of ever more times, since other work may interrupt any of them.
  const auto takes_longer = [](const OperationProbe& probe) {
    auto few = std::chrono::nanoseconds::max();
    auto many = std::chrono::nanoseconds::max();
    const auto time = [&](std::size_t rounds, std::chrono::nanoseconds& least) {
      const auto start = std::chrono::steady_clock::now();
      probe.run(rounds);
      least = std::min<std::chrono::nanoseconds>(
          least, std::chrono::steady_clock::now() - start);
    };
    for (int tries = 1; tries <= 50; ++tries) {
      time(kRounds, few);
      time(20 * kRounds, many);
      if (tries >= 3 && many > 4 * few) return true;
    }
    return false;
  };
  for (const OperationProbe& probe : OperationProbes()) {
    if (!RunsHere(probe.isa)) continue;
    EXPECT_TRUE(takes_longer(probe)) << Name(probe.operation) << " "
                                     << probe.scalar << " " << Name(probe.isa);
  }
}

TEST(ProbesTest, StoresReachEveryByteAndNoneBeyond) {
  constexpr std::size_t kBytes = 6 * kMemoryStep;
  constexpr std::byte kUntouched{0xA5};
  for (const MemoryProbe& probe : MemoryProbes()) {
    if (!RunsHere(probe.isa) || probe.access != Access::kStore) continue;
    Array<std::byte> memory(kBytes + kMemoryStep, kUntouched);
    probe.run(memory.data(), kBytes, 1);
    for (std::size_t i = 0; i < memory.size(); ++i) {
      ASSERT_EQ(memory[i] == kUntouched, i >= kBytes)
          << Name(probe.isa) << " " << i;
    }
  }
}

}  // namespace
}  // namespace pitbench
