#include "harness/measure/benchmarks.h"

#include <sstream>
#include <string_view>

#include "harness/measure/threads.h"

namespace pitbench {
namespace {

// The repetitions, their rates by the time that passed. Google Benchmark's are
// by the time that the process had the CPU; but what passes is what a user
// waits for, no bookkeeping of a scheduler or hypervisor can bend it, and the
// limits of the machine are measured by it too. (UseRealTime would say the
// same and become part of every name, as it does of those of several threads.)
// Its aggregates are left out.
nlohmann::json ByRealTime(const nlohmann::json& rows) {
  constexpr std::string_view kClock = "/real_time";
  nlohmann::json kept = nlohmann::json::array();
  for (const nlohmann::json& row : rows) {
    if (row.at("run_type") != "iteration") continue;
    kept.push_back(row);
    bool by_real_time = false;
    for (const char* key : {"name", "run_name"}) {
      if (!row.contains(key)) continue;
      std::string name = row.at(key);
      const std::size_t at = name.find(kClock);
      if (at == std::string::npos) continue;
      by_real_time = true;
      kept.back()[key] = name.erase(at, kClock.size());
    }
    const auto rate = kept.back().find("items_per_second");
    if (by_real_time || rate == kept.back().end()) continue;
    *rate = rate->get<double>() * row.at("cpu_time").get<double>() /
            row.at("real_time").get<double>();
  }
  return kept;
}

}  // namespace

Benchmarks::Benchmarks() { benchmark::ClearRegisteredBenchmarks(); }

void Benchmarks::Add(const std::string& name, const Function& function) {
  benchmark::RegisterBenchmark(name.c_str(), function)
      ->Unit(benchmark::kNanosecond);
}

void Benchmarks::AddForThreads(const std::string& name,
                               const Function& function) {
  benchmark::internal::Benchmark* row =
      benchmark::RegisterBenchmark(name.c_str(), function)
          ->Unit(benchmark::kNanosecond)
          ->UseRealTime();
  for (const int threads : ThreadCounts()) row->Threads(threads);
}

void Benchmarks::Refuse(const std::string& name, const std::string& why) {
  ++refused_;
  Add(name,
      [why](benchmark::State& state) { state.SkipWithError(why.c_str()); });
}

// Flags and not settings of each benchmark: those would become part of its
// name.
SpeedRun Benchmarks::Run(double seconds) const {
  if (cells_ == 0) return {};
  std::vector<std::string> flags = {
      "pitbench", "--benchmark_enable_random_interleaving=true",
      "--benchmark_repetitions=" + std::to_string(kRepetitions),
      "--benchmark_min_time=" + std::to_string(seconds)};
  std::vector<char*> argv;
  argv.reserve(flags.size());
  for (std::string& flag : flags) argv.push_back(flag.data());
  int argc = static_cast<int>(argv.size());
  benchmark::Initialize(&argc, argv.data());
  std::ostringstream text;
  benchmark::JSONReporter reporter;
  reporter.SetOutputStream(&text);
  reporter.SetErrorStream(&text);
  const OccupancyMeter meter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  const Occupancy occupancy = meter.Read();
  nlohmann::json file = nlohmann::json::parse(text.str());
  file["context"].erase("host_name");
  file["context"].erase("executable");
  file["benchmarks"] = ByRealTime(file["benchmarks"]);
  return {file, cells_, refused_, occupancy};
}

void SetWork(benchmark::State& state, const Work& work) {
  state.SetItemsProcessed(static_cast<std::int64_t>(
      static_cast<std::size_t>(state.iterations()) * work.items));
  state.counters["items"] = static_cast<double>(work.items);
  state.counters["working_set_bytes"] = work.working_set_bytes;
  state.counters["bytes_per_item"] = work.bytes_per_item;
  state.counters["scene_bytes"] = work.scene_bytes;
}

}  // namespace pitbench
