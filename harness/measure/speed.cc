#include "harness/measure/speed.h"

#include <benchmark/benchmark.h>

#include <array>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "harness/measure/answers.h"

namespace pitbench {
namespace {

// The kernel that is registered twice in every loop and scene.
bool IsTwin(const Kernel& kernel) {
  return kernel.method.key == "edge_function" &&
         kernel.output == Output::kInside &&
         (kernel.isa == Isa::kAvx2 || kernel.isa == Isa::kNeon);
}

// Where a kernel writes while it is timed.
template <class T>
struct Sink {
  Bits bits;
  std::array<Array<T>, 3> weights;

  Sink(const Kernel& kernel, const Scene<T>& scene) {
    std::size_t bytes = 0;
    std::size_t items = 0;
    for (const Call& call : scene.calls) {
      bytes = std::max(bytes, scene.OutputBytes(call));
      items = std::max(items, call.n);
    }
    bits.resize(bytes);
    if (kernel.output == Output::kWeights) {
      for (Array<T>& w : weights) w.resize(items);
    }
  }
  Result<T> Target() {
    Result<T> result{.bits = bits.data()};
    for (std::size_t k = 0; k < 3; ++k) {
      result.w[k] = weights[k].empty() ? nullptr : weights[k].data();
    }
    return result;
  }
};

template <class T>
void TimeKernel(benchmark::State& state, const Kernel& kernel,
                const Scene<T>& scene) {
  Sink<T> sink(kernel, scene);
  const Result<T> result = sink.Target();
  const KernelFunction<T> run = FunctionOf<T>(kernel);
  std::vector<Batch<T>> batches;
  for (const Call& call : scene.calls) batches.push_back(scene.BatchOf(call));
  std::size_t next = 0;
  for (auto _ : state) {
    run(batches[next], result);
    benchmark::ClobberMemory();
    if (++next == batches.size()) next = 0;
  }
  const Call& call = scene.calls.front();
  const auto items = static_cast<double>(call.n);
  const auto bytes = static_cast<double>(scene.BytesRead(call));
  state.SetItemsProcessed(static_cast<std::int64_t>(
      static_cast<std::size_t>(state.iterations()) * call.n));
  state.counters["items"] = items;
  state.counters["working_set_bytes"] = bytes;
  state.counters["bytes_per_item"] = bytes / items;
}

// The scenes of a run stay alive until it is over, with what is registered.
class Registry {
 public:
  Registry() { benchmark::ClearRegisteredBenchmarks(); }

  template <class T>
  void Add(std::shared_ptr<const Scene<T>> scene,
           const std::vector<const Kernel*>& kernels) {
    if (kernels.empty()) return;
    const SceneTruth truth = JudgeScene(*scene);
    for (const Kernel* kernel : kernels) {
      const std::optional<std::string> refusal =
          Refusal(*kernel, *scene, truth);
      const std::string name = CellName(*kernel, scene->name);
      ++cells;
      if (refusal) {
        ++refused;
        Register(name, [why = *refusal](benchmark::State& state) {
          state.SkipWithError(why.c_str());
        });
        continue;
      }
      const auto time = [kernel, scene](benchmark::State& state) {
        TimeKernel(state, *kernel, *scene);
      };
      Register(name, time);
      if (IsTwin(*kernel)) Register(name + "/twin", time);
    }
  }

  std::size_t cells = 0;
  std::size_t refused = 0;

 private:
  template <class Function>
  void Register(const std::string& name, Function function) {
    benchmark::RegisterBenchmark(name.c_str(), function)
        ->Unit(benchmark::kNanosecond);
  }
};

// Runs what is registered, each sample for `seconds` at the least, and returns
// Google Benchmark's report. Flags and not settings of each benchmark: those
// would become part of its name.
nlohmann::json Run(double seconds) {
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
  benchmark::RunSpecifiedBenchmarks(&reporter);
  nlohmann::json file = nlohmann::json::parse(text.str());
  file["context"].erase("host_name");
  file["context"].erase("executable");
  return file;
}

}  // namespace

SpeedRun MeasureSpeed(const Profile& profile, const std::regex& filter,
                      std::uint64_t seed) {
  Registry registry;
  const auto add = [&]<class T>(const ProfileScene& listed, Loop loop, T) {
    const std::vector<const Kernel*> kernels = KernelsFor(listed, loop, filter);
    if (kernels.empty()) return;
    registry.Add(std::make_shared<const Scene<T>>(MakeScene<T>(
                     ParseScene(listed.name), loop, profile.speed_size, seed)),
                 kernels);
  };
  for (const ProfileScene& listed : profile.speed) {
    for (const Loop loop : listed.loops) {
      if (listed.scalar == Scalar::kF32) add(listed, loop, float{});
      if (listed.scalar == Scalar::kF64) add(listed, loop, double{});
      if (listed.scalar == Scalar::kI32) add(listed, loop, std::int32_t{});
    }
  }
  if (registry.cells == 0) return {};
  return {Run(profile.seconds_per_sample), registry.cells, registry.refused};
}

SpeedRun MeasureSpeedOn(const std::vector<Scene<float>>& f32,
                        const std::vector<Scene<double>>& f64,
                        const std::regex& filter, double seconds) {
  Registry registry;
  const auto add = [&]<class T>(const std::vector<Scene<T>>& scenes) {
    for (const Scene<T>& scene : scenes) {
      const ProfileScene listed{
          scene.name, {scene.loop}, ScalarOf<T>(), /*weights=*/true};
      registry.Add(std::make_shared<const Scene<T>>(scene),
                   KernelsFor(listed, scene.loop, filter));
    }
  };
  add(f32);
  add(f64);
  if (registry.cells == 0) return {};
  return {Run(seconds), registry.cells, registry.refused};
}

}  // namespace pitbench
