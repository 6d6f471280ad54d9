#include "harness/measure/rays/ray_speed.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "harness/measure/measured_kernels.h"
#include "harness/measure/rays/ray_answers.h"

namespace pitbench {
namespace {

bool IsControl(const RayKernel& kernel) {
  return kernel.method.key == "moller_trumbore" &&
         kernel.output != RayOutput::kTuv &&
         (kernel.isa == Isa::kAvx2 || kernel.isa == Isa::kNeon);
}

// Where a kernel writes while it is timed.
template <class T>
struct Sink {
  Bits bits;
  std::array<Array<T>, 3> tuv;
  std::size_t nearest = kNoTriangle;

  explicit Sink(const RayScene<T>& scene) {
    std::size_t n = 1;
    for (const RayCall& call : scene.calls) n = std::max(n, call.n);
    bits.resize(BitBytes(n));
    for (Array<T>& values : tuv) values.resize(n);
  }
  RayResult<T> Target() {
    return {bits.data(), tuv[0].data(), tuv[1].data(), tuv[2].data(), &nearest};
  }
};

template <int kCalls, class T>
void TimeKernel(benchmark::State& state, const RayKernel& kernel,
                const RayScene<T>& scene) {
  Sink<T> sink(scene);
  std::vector<RayBatch<T>> batches;
  for (const RayCall& call : scene.calls)
    batches.push_back(scene.BatchOf(call));
  // What a library builds of the triangles is built here, before the timing.
  std::optional<KeptIndexes> kept;
  if (kernel.isa == Isa::kLibrary) {
    kept.emplace();
    for (const RayBatch<T>& batch : batches) {
      FunctionOf<T>(kernel)(batch, sink.Target());
    }
  }
  TimeBatches<kCalls>(state, FunctionOf<T>(kernel), batches, sink.Target());
  const RayCall& call = scene.calls.front();
  const auto bytes = static_cast<double>(scene.BytesRead(call));
  SetWork(state, {.items = call.n,
                  .working_set_bytes = bytes,
                  .bytes_per_item = bytes / static_cast<double>(call.n),
                  .scene_bytes = static_cast<double>(scene.Bytes())});
}

template <class T>
void AddScene(Benchmarks& benchmarks, const RayProfileScene& listed,
              const std::shared_ptr<const RayScene<T>>& scene,
              const std::vector<const RayKernel*>& kernels) {
  // Of methods that do not cull and of those that do.
  std::array<std::optional<SceneTruth>, 2> truths;
  for (const RayKernel* kernel : kernels) {
    const bool culls = kernel->method.culls_backface;
    std::optional<SceneTruth>& truth = truths[culls ? 1 : 0];
    if (!truth) truth = JudgeRays(*scene, culls);
    const std::string name = CellName(*kernel, scene->name);
    benchmarks.CountCell();
    if (const auto refusal = Refusal(*kernel, *scene, *truth)) {
      benchmarks.Refuse(name, *refusal);
      continue;
    }
    const auto time = [kernel, scene](benchmark::State& state) {
      TimeKernel<1>(state, *kernel, *scene);
    };
    benchmarks.Add(name, time);
    if (!IsControl(*kernel) || !listed.methods.empty()) continue;
    benchmarks.Add(name + "/twin", time);
    benchmarks.Add(name + "/doubled", [kernel, scene](benchmark::State& state) {
      TimeKernel<2>(state, *kernel, *scene);
    });
  }
}

}  // namespace

void AddRayCells(Benchmarks& benchmarks, const Profile& profile,
                 const std::regex& filter, std::uint64_t seed) {
  const auto add = [&]<class T>(const RayProfileScene& listed, RayLoop loop,
                                T) {
    std::vector<const RayKernel*> kernels = KernelsFor(listed, loop, filter);
    std::erase_if(kernels,
                  [](const RayKernel* kernel) { return !MayBeTimed(*kernel); });
    if (kernels.empty()) return;
    AddScene(benchmarks, listed,
             std::make_shared<const RayScene<T>>(MakeRayScene<T>(
                 ParseScene(listed.name), loop, profile.speed_size, seed)),
             kernels);
  };
  for (const RayProfileScene& listed : profile.ray_speed) {
    for (const RayLoop loop : listed.loops) {
      if (listed.scalar == Scalar::kF32) {
        add(listed, loop, float{});
      } else {
        add(listed, loop, double{});
      }
    }
  }
}

}  // namespace pitbench
