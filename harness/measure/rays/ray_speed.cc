#include "harness/measure/rays/ray_speed.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "harness/measure/measured_kernels.h"
#include "harness/measure/rays/ray_answers.h"

namespace pitbench {
namespace {

bool MayBeControl(const RayKernel& kernel) {
  return kernel.method.key == "moller_trumbore" &&
         kernel.output != RayOutput::kTuv;
}

// A scene as its calls find it, shared by all of its rows.
template <class T>
struct PreparedScene {
  std::shared_ptr<const RayScene<T>> scene;
  std::vector<RayBatch<T>> batches = {};
  // Where the kernels write.
  Bits bits = {};
  std::array<Array<T>, 3> tuv = {};
  std::size_t nearest = kNoTriangle;

  explicit PreparedScene(std::shared_ptr<const RayScene<T>> of)
      : scene(std::move(of)) {
    std::size_t n = 1;
    for (const RayCall& call : scene->calls) {
      batches.push_back(scene->BatchOf(call));
      n = std::max(n, call.n);
    }
    bits.resize(BitBytes(n));
    for (Array<T>& values : tuv) values.resize(n);
  }

  RayResult<T> Target() {
    return {bits.data(), tuv[0].data(), tuv[1].data(), tuv[2].data(), &nearest};
  }
};

template <int kCalls, class T>
TimedCalls Timed(const RayKernel& kernel,
                 const std::shared_ptr<PreparedScene<T>>& prepared,
                 const std::shared_ptr<KeptIndexes>& kept) {
  return TimedBatches<kCalls>(FunctionOf<T>(kernel),
                              std::shared_ptr<const std::vector<RayBatch<T>>>(
                                  prepared, &prepared->batches),
                              prepared->Target(), std::pair(prepared, kept));
}

// `kept`: what libraries build of the triangles, before anything is timed.
template <class T>
void AddScene(Benchmarks& benchmarks, const RayProfileScene& listed,
              const std::shared_ptr<const RayScene<T>>& scene,
              const std::vector<const RayKernel*>& kernels,
              const std::shared_ptr<KeptIndexes>& kept) {
  const auto prepared = std::make_shared<PreparedScene<T>>(scene);
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
    if (kernel->isa == Isa::kLibrary) {
      for (const RayBatch<T>& batch : prepared->batches) {
        FunctionOf<T> (*kernel)(batch, prepared->Target());
      }
    }
    const Work work = WorkOfCall(*scene);
    const TimedCalls once = Timed<1>(*kernel, prepared, kept);
    benchmarks.Add(name, once, work);
    if (!listed.methods.empty() || !IsControl(*kernel, kernels, MayBeControl)) {
      continue;
    }
    benchmarks.Add(name + "/twin", once, work);
    benchmarks.Add(name + "/doubled", Timed<2>(*kernel, prepared, kept), work);
  }
}

}  // namespace

void AddRayCells(Benchmarks& benchmarks, const Profile& profile,
                 const NameFilter& filter, std::uint64_t seed) {
  const auto kept = std::make_shared<KeptIndexes>();
  const auto add = [&]<class T>(const RayProfileScene& listed, RayLoop loop,
                                T) {
    std::vector<const RayKernel*> kernels = KernelsFor(listed, loop, filter);
    std::erase_if(kernels,
                  [](const RayKernel* kernel) { return !MayBeTimed(*kernel); });
    if (kernels.empty()) return;
    AddScene(benchmarks, listed,
             std::make_shared<const RayScene<T>>(MakeRayScene<T>(
                 ParseScene(listed.name), loop, profile.speed_size, seed)),
             kernels, kept);
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
