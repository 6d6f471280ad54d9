// What is timed together: rows of Google Benchmark, run in random order.
#ifndef PITBENCH_HARNESS_MEASURE_BENCHMARKS_H_
#define PITBENCH_HARNESS_MEASURE_BENCHMARKS_H_

#include <benchmark/benchmark.h>

#include <cstddef>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "harness/measure/occupancy.h"

namespace pitbench {

inline constexpr int kRepetitions = 9;

struct SpeedRun {
  nlohmann::json file;  // Google Benchmark's format, without "pitbench" in
                        // its context
  std::size_t cells = 0;
  std::size_t refused = 0;
  Occupancy occupancy = {};  // while the cells were timed
};

// The rows of one process. What they refer to has to live until Run returns.
class Benchmarks {
 public:
  using Function = std::function<void(benchmark::State&)>;

  Benchmarks();

  // A row, and how many of them are cells.
  void Add(const std::string& name, const Function& function);
  // A row for each number of threads, `…/threads:2`. By the time that passed,
  // in the mean over the threads: that of a CPU does not tell how long it
  // waited for another program.
  void AddForThreads(const std::string& name, const Function& function);
  // A cell that may not be timed, and why.
  void Refuse(const std::string& name, const std::string& why);
  void CountCell() { ++cells_; }

  // Each sample lasts `seconds` at the least.
  SpeedRun Run(double seconds) const;

 private:
  std::size_t cells_ = 0;
  std::size_t refused_ = 0;
};

// Times a kernel on one batch after the other. kCalls batches are timed as if
// they were one. (Not the same one again, which would be in the caches as no
// other is.)
template <int kCalls, class Batch, class Result>
void TimeBatches(benchmark::State& state,
                 void (*run)(const Batch&, const Result&),
                 const std::vector<Batch>& batches, const Result& result) {
  std::size_t next = 0;
  for (auto _ : state) {
    for (int call = 0; call < kCalls; ++call) {
      run(batches[next], result);
      benchmark::ClobberMemory();
      if (++next == batches.size()) next = 0;
    }
  }
}

// What a call does: items and bytes are sums over the threads.
struct Work {
  std::size_t items;  // of a call, or of this thread's part of it
  double working_set_bytes;
  double bytes_per_item;
  double scene_bytes;
};
void SetWork(benchmark::State& state, const Work& work);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_BENCHMARKS_H_
