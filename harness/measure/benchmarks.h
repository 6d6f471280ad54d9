// What is timed together: the rows of one process.
#ifndef PITBENCH_HARNESS_MEASURE_BENCHMARKS_H_
#define PITBENCH_HARNESS_MEASURE_BENCHMARKS_H_

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "harness/measure/clock.h"
#include "harness/measure/occupancy.h"
#include "harness/measure/slices.h"
#include "kernels/kernels.h"

namespace pitbench {

inline constexpr int kRepetitions = 9;

struct SpeedRun {
  // Of the shape of Google Benchmark's files, without "pitbench" in its
  // context.
  nlohmann::json file;
  std::size_t cells = 0;
  std::size_t refused = 0;
  // While the cells were timed; the pace in the first half of that and in the
  // second.
  Occupancy occupancy = {};
  std::array<Pace, 2> pace = {};
  double quiet_share = 0;  // of the slices, see slices.h
};

// What a call does: items and bytes are sums over the threads.
struct Work {
  std::size_t items;
  double working_set_bytes;
  double bytes_per_item;
  double scene_bytes;
};

// Of the calls of a scene of points or rays, which all do as much.
template <class Scene>
Work WorkOfCall(const Scene& scene) {
  const auto& call = scene.calls.front();
  const auto bytes = static_cast<double>(scene.BytesRead(call));
  return {.items = call.n,
          .working_set_bytes = bytes,
          .bytes_per_item = bytes / static_cast<double>(call.n),
          .scene_bytes = static_cast<double>(scene.Bytes())};
}

// Whether `kernel` is the control of its loop, whose time is known to be that
// of its `…/twin` and half of that of its `…/doubled`: of those that may be it,
// the one of the widest ISA among what is timed. AVX-512 is left out: not to
// have a control that few machines have.
template <class K, class MayBe>
bool IsControl(const K& kernel, const std::vector<const K*>& timed,
               const MayBe& may_be) {
  const auto candidate = [&](const K& k) {
    return k.loop == kernel.loop && may_be(k) &&
           (k.isa == Isa::kSse4 || k.isa == Isa::kAvx2 || k.isa == Isa::kNeon);
  };
  return candidate(kernel) &&
         std::none_of(timed.begin(), timed.end(), [&](const K* other) {
           return candidate(*other) && other->isa > kernel.isa;
         });
}

class Benchmarks {
 public:
  // A row of calls by as many threads, and how many of the rows are cells.
  void Add(const std::string& name, const TimedCalls& calls, const Work& work,
           int threads = 1);
  // A cell that may not be timed, and why.
  void Refuse(const std::string& name, const std::string& why);
  void CountCell() { ++cells_; }

  SpeedRun Run(const SliceBudget& budget) const;

 private:
  struct Row {
    std::string name;
    Work work;
    int threads;
  };

  std::vector<Row> rows_;
  std::vector<TimedCalls> calls_;  // of the rows
  nlohmann::json refusals_ = nlohmann::json::array();
  std::size_t cells_ = 0;
};

// Runs a kernel on `count` batches from `first` on and round again. What a call
// writes counts as read.
template <class Batch, class Result>
void RunBatches(void (*run)(const Batch&, const Result&),
                const std::vector<Batch>& batches, const Result& result,
                std::size_t first, std::size_t count) {
  std::size_t next = first % batches.size();
  for (; count != 0; --count) {
    run(batches[next], result);
    std::atomic_signal_fence(std::memory_order_acq_rel);
    if (++next == batches.size()) next = 0;
  }
}

inline double SecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start)
      .count();
}

// Times a kernel on one batch after the other. kCalls batches are timed as if
// they were one call. (Not the same one again, which would be in the caches as
// no other is.) `lives`: what the batches and the result point into.
template <int kCalls, class Batch, class Result, class Lives>
TimedCalls TimedBatches(
    void (*run)(const Batch&, const Result&),
    const std::shared_ptr<const std::vector<Batch>>& batches,
    const Result& result, const Lives& lives) {
  return {batches->size(),
          [run, batches, result, lives](std::size_t first, std::size_t count) {
            const auto start = std::chrono::steady_clock::now();
            RunBatches(run, *batches, result, first * kCalls, count * kCalls);
            return SecondsSince(start);
          }};
}

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_BENCHMARKS_H_
