// Times of calls, freed of what disturbs them: on timers that only pretend.
#include "harness/measure/slices.h"

#include <gtest/gtest.h>
#include <sched.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "harness/measure/parts.h"
#include "harness/measure/quiet.h"
#include "harness/measure/threads.h"

namespace pitbench {
namespace {

constexpr double kMicro = 1e-6;

// A machine on which nothing ever happens.
const Surroundings kCalm = {.look = [] { return Quiet::kYes; },
                            .between = [](double) {}};

// What the call `k` takes where calls differ.
double Cost(std::size_t k) { return (1 + static_cast<double>(k % 7)) * kMicro; }

double CostOf(std::size_t first, std::size_t count, std::size_t round) {
  double sum = 0;
  for (std::size_t k = 0; k < count; ++k) sum += Cost((first + k) % round);
  return sum;
}

TEST(SlicesTest, TimesTheCallsAndNotWhatDisturbsThem) {
  constexpr std::size_t kRound = 28;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> times;
  const TimedCalls row = {kRound, [&](std::size_t first, std::size_t count) {
                            // Of the same calls two times of three are
                            // disturbed, some a lot.
                            constexpr std::array kFactors = {1.3, 12., 1.};
                            return kFactors[times[{first, count}]++ % 3] *
                                   CostOf(first, count, kRound);
                          }};
  const SliceTimes found = TimeInSlices({row}, {1.6e-3}, 1, kCalm);
  ASSERT_EQ(found.rows.size(), 1u);
  ASSERT_EQ(found.rows[0].size(), 1u);
  const Repetition& repetition = found.rows[0][0];
  EXPECT_NEAR(repetition.call_seconds, 4 * kMicro, 1e-12);
  EXPECT_GT(repetition.mean_call_seconds, 4 * 2 * kMicro);
  EXPECT_GE(repetition.calls, 100u);
  EXPECT_EQ(found.quiet_share, 1);
}

// Of a round too long for a repetition, all passes of one take the same calls
// and other repetitions take others.
TEST(SlicesTest, TheSpreadOfRepetitionsHoldsThatOfTheCalls) {
  constexpr std::size_t kRound = 1000;
  std::set<std::size_t> seen;
  const TimedCalls row = {kRound, [&](std::size_t first, std::size_t count) {
                            for (std::size_t k = 0; k < count; ++k) {
                              seen.insert((first + k) % kRound);
                            }
                            return 20 * CostOf(first, count, kRound);
                          }};
  const SliceTimes found = TimeInSlices({row}, {1.6e-3}, 9, kCalm);
  std::set<double> times;
  for (const Repetition& repetition : found.rows[0]) {
    times.insert(repetition.call_seconds);
    EXPECT_DOUBLE_EQ(repetition.call_seconds, repetition.mean_call_seconds)
        << "some pass took other calls";
  }
  EXPECT_GT(times.size(), 1u);
  EXPECT_GT(seen.size(), 9u);
}

TEST(SlicesTest, OfEachPartOfALongCallTheFastestPassCounts) {
  std::size_t pass = 0;
  const TimedCalls row = {
      3, [](std::size_t, std::size_t) { return 300 * kMicro; },
      [&](std::size_t call, std::vector<double>& seconds) {
        seconds.assign(3, static_cast<double>(call + 1) * 100 * kMicro);
        seconds[pass++ % 3] *= 9;  // each pass is disturbed somewhere
      }};
  const SliceTimes found = TimeInSlices({row}, {2.3e-4}, 6, kCalm);
  for (std::size_t k = 0; k < found.rows[0].size(); ++k) {
    const Repetition& repetition = found.rows[0][k];
    EXPECT_NEAR(repetition.call_seconds,
                static_cast<double>(k % 3 + 1) * 300 * kMicro, 1e-12);
    EXPECT_NEAR(repetition.mean_call_seconds,
                static_cast<double>(k % 3 + 1) * 1100 * kMicro, 1e-12);
    EXPECT_EQ(repetition.calls, 6u);
  }
  const SliceTimes longer = TimeInSlices({row}, {1}, 1, kCalm);
  EXPECT_EQ(longer.rows[0][0].calls, 8u);
}

TEST(PartTimesTest, TheFastestPassOverEachPartCounts) {
  PartTimes times;
  times.AddPass({1, 5, 2});
  times.AddPass({3, 4, 2});
  EXPECT_EQ(times.Fastest(), 1 + 4 + 2);
  EXPECT_EQ(times.Sum(), 17);
  EXPECT_EQ(times.Passes(), 2u);
}

TEST(PartTimesTest, PassesAreFewerTheLongerTheCall) {
  EXPECT_EQ(PassesOfParts(1, 2), 8u);
  EXPECT_EQ(PassesOfParts(1, 0.5), 4u);
  EXPECT_EQ(PassesOfParts(1, 0.01), 1u);
}

TEST(SlicesTest, WaitsUntilItIsQuiet) {
  int noise = 0;  // looks until it is over
  std::size_t slices = 0;
  const TimedCalls row = {8, [&](std::size_t first, std::size_t count) {
                            // Each third time something comes up.
                            if (++slices % 3 == 0) noise = 5;
                            return (noise > 0 ? 2 : 1) *
                                   CostOf(first, count, 7);
                          }};
  const Surroundings surroundings = {.look =
                                         [&] {
                                           if (noise > 0) --noise;
                                           return noise > 0 ? Quiet::kDisturbed
                                                            : Quiet::kYes;
                                         },
                                     .between = [](double) {}};
  const SliceTimes found = TimeInSlices(
      {row}, {.seconds = 1.6e-3, .patience = 1e6}, 9, surroundings);
  EXPECT_EQ(found.quiet_share, 1);
}

TEST(SlicesTest, LooksTwiceAfterASliceThatHadToBeWokenUpFrom) {
  bool woken = false;
  const TimedCalls row = {7, [&](std::size_t first, std::size_t count) {
                            woken = true;
                            return CostOf(first, count, 7);
                          }};
  const Surroundings surroundings = {.look =
                                         [&] {
                                           return std::exchange(woken, false)
                                                      ? Quiet::kDisturbed
                                                      : Quiet::kYes;
                                         },
                                     .between = [](double) {}};
  EXPECT_EQ(TimeInSlices({row}, {1e-4}, 2, surroundings).quiet_share, 1);
}

TEST(SlicesTest, DoesNotWaitForEver) {
  for (const auto& [state, share] :
       {std::pair(Quiet::kDisturbed, 0), std::pair(Quiet::kSlower, 1)}) {
    const TimedCalls row = {7, [](std::size_t first, std::size_t count) {
                              return CostOf(first, count, 7);
                            }};
    const Surroundings surroundings = {
        .look = [state = state] { return state; }, .between = [](double) {}};
    const SliceTimes found = TimeInSlices({row}, {1e-4}, 2, surroundings);
    EXPECT_NEAR(found.rows[0][1].call_seconds, 4 * kMicro, 2 * kMicro);
    EXPECT_EQ(found.quiet_share, share);
  }
}

TEST(SlicesTest, ThePaceIsAskedForAllAlong) {
  std::vector<double> done;
  const TimedCalls row = {1, [](std::size_t, std::size_t count) {
                            return static_cast<double>(count) * kMicro;
                          }};
  TimeInSlices({row, row}, {1e-3}, 9,
               {.look = kCalm.look,
                .between = [&](double part) { done.push_back(part); }});
  ASSERT_GT(done.size(), 100u);
  EXPECT_TRUE(std::is_sorted(done.begin(), done.end()));
  EXPECT_EQ(done.front(), 0);
  EXPECT_LT(done.back(), 1);
  EXPECT_GT(done.back(), 0.9);
}

TEST(SlicesTest, PlansLastAsLongAsTheyShould) {
  for (double call = 1e-9; call < 1; call *= 3.7) {
    for (const std::size_t round : {1, 2, 64, 512}) {
      for (const double seconds : {1e-5, 1e-4, 1.6e-3, 4.8e-3}) {
        const SlicePlan plan = PlanSlices(call, round, seconds);
        const auto window = static_cast<double>(plan.window);
        const double total = window * static_cast<double>(plan.passes) * call;
        SCOPED_TRACE(::testing::Message()
                     << call << ' ' << round << ' ' << seconds << ": "
                     << plan.window << ' ' << plan.passes);
        ASSERT_GE(plan.window, 1u);
        ASSERT_GE(plan.passes, 1u);
        ASSERT_GE(plan.pieces, 1u);
        ASSERT_LE(plan.pieces, plan.window);
        if (plan.window > round) {
          EXPECT_EQ(plan.window % round, 0u);
        }
        EXPECT_LE(total, std::max(1.01 * seconds, call));
        if (static_cast<double>(round) * call < seconds / 16) {
          EXPECT_GE(total, 0.4 * seconds);
        }
        const double slice = window * call / static_cast<double>(plan.pieces);
        EXPECT_LE(slice, std::max(1.6 * kSliceSeconds, 2 * call));
        EXPECT_LE(static_cast<double>(plan.warm_up) * call,
                  std::max(0.3 * slice, call));
        EXPECT_EQ(plan.warm_up == 0, call > 1e-3);
      }
    }
  }
}

TEST(QuietTest, ListsOfCpusAreRead) {
  EXPECT_EQ(CpusOfList("0-3,8"), (std::vector<int>{0, 1, 2, 3, 8}));
  EXPECT_EQ(CpusOfList("5"), std::vector<int>{5});
  EXPECT_TRUE(CpusOfList("").empty());
  EXPECT_TRUE(CpusOfList("0-").empty());
  EXPECT_TRUE(CpusOfList("0;1").empty());
}

// An idle core may be called disturbed, but not for ever; and whoever looks
// stays on a CPU that the process may use.
TEST(QuietTest, LooksAreOfThisMachine) {
  PinToLastCpu();
  QuietPlace place;
  std::set<Quiet> seen;
  for (int look = 0; look < 2000; ++look) seen.insert(place.Look());
  EXPECT_NE(seen, std::set<Quiet>{Quiet::kDisturbed});
  EXPECT_TRUE(MayUse(sched_getcpu()));
}

}  // namespace
}  // namespace pitbench
