#include "harness/measure/speed.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "harness/measure/answers.h"
#include "harness/measure/rays/ray_speed.h"
#include "harness/measure/threads.h"
#include "kernels/placements.h"

namespace pitbench {
namespace {

// The kernel whose time is known to be that of its `…/twin` and half of that
// of its `…/doubled`, in every loop and scene.
bool IsControl(const Kernel& kernel) {
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

// `xy`: what PointsFor gives.
template <int kCalls, class T>
void TimeKernel(benchmark::State& state, const Kernel& kernel,
                const Scene<T>& scene, const Array<T>& xy) {
  Sink<T> sink(kernel, scene);
  const auto thread = static_cast<std::size_t>(state.thread_index());
  const auto threads = static_cast<std::size_t>(state.threads());
  if (threads > 1) PinThread(state.thread_index());
  std::vector<Batch<T>> batches;
  for (const Call& call : scene.calls) {
    batches.push_back(scene.BatchOf(
        threads > 1 ? PartOf(call, thread, threads) : call, xy.data()));
  }
  TimeBatches<kCalls>(state, FunctionOf<T>(kernel), batches, sink.Target());
  const Call& call = scene.calls.front();
  const auto bytes = static_cast<double>(scene.BytesRead(call));
  const bool first = thread == 0;
  SetWork(state,
          {.items = threads > 1 ? PartOf(call, thread, threads).n : call.n,
           .working_set_bytes = first ? bytes : 0,
           .bytes_per_item = first ? bytes / static_cast<double>(call.n) : 0,
           .scene_bytes = first ? static_cast<double>(scene.Bytes()) : 0});
}

// Adds the cells of scenes, which stay alive with what is added.
class Cells {
 public:
  explicit Cells(Benchmarks& benchmarks) : benchmarks_(benchmarks) {}

  template <class T>
  void Add(std::shared_ptr<const Scene<T>> scene, const ProfileScene& listed,
           const std::vector<const Kernel*>& kernels) {
    if (kernels.empty()) return;
    const SceneTruth truth = JudgeScene(*scene);
    std::shared_ptr<const Array<T>> side_by_side;  // one for all that read it
    for (const Kernel* kernel : kernels) {
      const std::optional<std::string> refusal =
          Refusal(*kernel, *scene, truth);
      const std::string name = CellName(*kernel, scene->name);
      benchmarks_.CountCell();
      if (refusal) {
        benchmarks_.Refuse(name, *refusal);
        continue;
      }
      const bool aos = kernel->loop == Loop::kOneTriangleAos;
      if (aos && !side_by_side) {
        side_by_side =
            std::make_shared<const Array<T>>(scene->PointsSideBySide());
      }
      const auto xy = aos ? side_by_side : std::make_shared<const Array<T>>();
      const auto time = [kernel, scene, xy](benchmark::State& state) {
        TimeKernel<1>(state, *kernel, *scene, *xy);
      };
      if (listed.threads) {
        benchmarks_.AddForThreads(name, time);
        continue;
      }
      benchmarks_.Add(name, time);
      if (IsControl(*kernel) && listed.methods.empty()) {
        benchmarks_.Add(name + "/twin", time);
        benchmarks_.Add(name + "/doubled",
                        [kernel, scene, xy](benchmark::State& state) {
                          TimeKernel<2>(state, *kernel, *scene, *xy);
                        });
      }
      if (placed_.insert(kernel).second) AddPlacements(*kernel, scene, truth);
    }
  }

 private:
  // The copies of a kernel whose code lies elsewhere, as `…/placed_<shift>`.
  template <class T>
  void AddPlacements(const Kernel& kernel,
                     const std::shared_ptr<const Scene<T>>& scene,
                     const SceneTruth& truth) {
    for (const Placement& placement : Placements()) {
      const Kernel& copy = placement.kernel;
      if (copy.method.key != kernel.method.key || copy.isa != kernel.isa ||
          copy.loop != kernel.loop || copy.scalar != kernel.scalar ||
          copy.output != kernel.output || Refusal(copy, *scene, truth)) {
        continue;
      }
      benchmarks_.Add(CellName(copy, scene->name) + "/placed_" +
                          std::to_string(placement.shift),
                      [&copy, scene](benchmark::State& state) {
                        TimeKernel<1>(state, copy, *scene, {});
                      });
    }
  }

  Benchmarks& benchmarks_;
  std::set<const Kernel*> placed_;  // in the first scene of a shard only
};

// A scene that no profile lists, for all that can be timed on it.
template <class T>
ProfileScene ListingOf(const Scene<T>& scene) {
  return {scene.name, {scene.loop}, ScalarOf<T>(), /*weights=*/true};
}

bool Lists(const ProfileScene& listed, Loop loop) {
  return std::find(listed.loops.begin(), listed.loops.end(), loop) !=
         listed.loops.end();
}

}  // namespace

SpeedRun MeasureSpeed(const Profile& profile, const std::regex& filter,
                      std::uint64_t seed) {
  Benchmarks benchmarks;
  Cells cells(benchmarks);
  const auto add = [&]<class T>(const ProfileScene& listed, Loop loop, T) {
    std::vector<const Kernel*> kernels = KernelsFor(listed, loop, filter);
    // Both layouts of the points by one scene, which may be large, judged once.
    if (loop == Loop::kOneTriangle && Lists(listed, Loop::kOneTriangleAos)) {
      const auto more = KernelsFor(listed, Loop::kOneTriangleAos, filter);
      kernels.insert(kernels.end(), more.begin(), more.end());
    }
    if (kernels.empty()) return;
    cells.Add(std::make_shared<const Scene<T>>(MakeScene<T>(
                  ParseScene(listed.name), loop, profile.speed_size, seed)),
              listed, kernels);
  };
  for (const ProfileScene& listed : profile.speed) {
    for (const Loop loop : listed.loops) {
      if (loop == Loop::kOneTriangleAos && Lists(listed, Loop::kOneTriangle)) {
        continue;  // with it
      }
      if (listed.scalar == Scalar::kF32) add(listed, loop, float{});
      if (listed.scalar == Scalar::kF64) add(listed, loop, double{});
      if (listed.scalar == Scalar::kI32) add(listed, loop, std::int32_t{});
      if (listed.scalar == Scalar::kI16) add(listed, loop, std::int16_t{});
      if (listed.scalar == Scalar::kU8) add(listed, loop, std::uint8_t{});
    }
  }
  AddRayCells(benchmarks, profile, filter, seed);
  return benchmarks.Run(profile.seconds_per_sample);
}

SpeedRun MeasureSpeedOn(const std::vector<Scene<float>>& f32,
                        const std::vector<Scene<double>>& f64,
                        const std::regex& filter, double seconds) {
  Benchmarks benchmarks;
  Cells cells(benchmarks);
  const auto add = [&]<class T>(const std::vector<Scene<T>>& scenes) {
    for (const Scene<T>& scene : scenes) {
      const ProfileScene listed = ListingOf(scene);
      cells.Add(std::make_shared<const Scene<T>>(scene), listed,
                KernelsFor(listed, scene.loop, filter));
    }
  };
  add(f32);
  add(f64);
  return benchmarks.Run(seconds);
}

template <class T>
SpeedRun MeasureKernels(const std::vector<const Kernel*>& kernels,
                        const Scene<T>& scene, double seconds) {
  Benchmarks benchmarks;
  Cells cells(benchmarks);
  cells.Add(std::make_shared<const Scene<T>>(scene), ListingOf(scene), kernels);
  return benchmarks.Run(seconds);
}

template SpeedRun MeasureKernels(const std::vector<const Kernel*>&,
                                 const Scene<float>&, double);
template SpeedRun MeasureKernels(const std::vector<const Kernel*>&,
                                 const Scene<double>&, double);
template SpeedRun MeasureKernels(const std::vector<const Kernel*>&,
                                 const Scene<std::int32_t>&, double);

}  // namespace pitbench
