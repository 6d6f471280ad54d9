#include "harness/measure/speed.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "harness/measure/answers.h"
#include "harness/measure/parts.h"
#include "harness/measure/rays/ray_speed.h"
#include "harness/measure/threads.h"
#include "kernels/placements.h"

namespace pitbench {
namespace {

bool MayBeControl(const Kernel& kernel) {
  return kernel.method.key == "edge_function" &&
         kernel.output == Output::kInside;
}

// A scene as its calls find it: shared by all of its rows, so that no row has
// arrays that lie better than another's.
template <class T>
struct PreparedScene {
  std::shared_ptr<const Scene<T>> scene;
  Array<T> xy;  // for kernels that read the points side by side
  std::vector<Batch<T>> batches = {};
  // Where the kernels write.
  Bits bits = {};
  std::array<Array<T>, 3> weights = {};

  PreparedScene(std::shared_ptr<const Scene<T>> of, bool side_by_side)
      : scene(std::move(of)),
        xy(side_by_side ? scene->PointsSideBySide() : Array<T>()) {
    std::size_t bytes = 0;
    for (const Call& call : scene->calls) {
      batches.push_back(scene->BatchOf(call, xy.data()));
      bytes = std::max(bytes, scene->OutputBytes(call));
    }
    bits.resize(bytes);
  }

  void MakeRoomForWeights() {
    std::size_t items = 0;
    for (const Call& call : scene->calls) items = std::max(items, call.n);
    for (Array<T>& w : weights) w.resize(items);
  }

  Result<T> Target() {
    Result<T> result{.bits = bits.data()};
    for (std::size_t k = 0; k < 3; ++k) result.w[k] = weights[k].data();
    return result;
  }

  // Where a part of a call writes, which begins with a whole byte.
  Result<T> TargetOf(const Call& call, const Call& part) {
    const std::size_t items =
        std::max(part.point - call.point, part.triangle - call.triangle);
    Result<T> result = Target();
    result.bits += items / 8;
    for (T*& w : result.w) w = w == nullptr ? nullptr : w + items;
    return result;
  }
};

template <class T>
using Prepared = std::shared_ptr<PreparedScene<T>>;

// Times the calls of a scene in parts, each of which writes behind the one
// before it as the call would. A long call is the only one of its scene.
template <class T>
PartsTimer TimedParts(const Kernel& kernel, const Prepared<T>& prepared) {
  const Scene<T>& scene = *prepared->scene;
  const std::size_t parts = scene.calls.front().n / kItemsOfPart;
  return [run = FunctionOf<T>(kernel), parts, &scene, prepared](
             std::size_t first, std::vector<double>& seconds) {
    seconds.clear();
    const Call& call = scene.calls[first % scene.calls.size()];
    for (std::size_t index = 0; index < parts; ++index) {
      const Call part = PartOf(call, scene.loop, index, parts);
      const Batch<T> batch = scene.BatchOf(part, prepared->xy.data());
      const Result<T> result = prepared->TargetOf(call, part);
      const auto start = std::chrono::steady_clock::now();
      run(batch, result);
      std::atomic_signal_fence(std::memory_order_acq_rel);
      seconds.push_back(SecondsSince(start));
    }
  };
}

template <int kCalls, class T>
TimedCalls Timed(const Kernel& kernel, const Prepared<T>& prepared) {
  TimedCalls calls =
      TimedBatches<kCalls>(FunctionOf<T>(kernel),
                           std::shared_ptr<const std::vector<Batch<T>>>(
                               prepared, &prepared->batches),
                           prepared->Target(), prepared);
  const Scene<T>& scene = *prepared->scene;
  if (scene.loop != Loop::kGrid &&
      WorkOfCall(scene).working_set_bytes >= kBytesOfLongCall) {
    calls.time_parts = TimedParts(kernel, prepared);
  }
  return calls;
}

// The same calls by several threads, each of which has its part of every call.
template <class T>
TimedCalls TimedOnThreads(const Kernel& kernel, const Prepared<T>& prepared,
                          std::size_t threads) {
  struct Part {
    std::vector<Batch<T>> batches;
    Bits bits;
  };
  auto parts = std::make_shared<std::vector<Part>>(threads);
  for (std::size_t thread = 0; thread < threads; ++thread) {
    Part& part = (*parts)[thread];
    for (const Call& call : prepared->scene->calls) {
      part.batches.push_back(prepared->scene->BatchOf(
          PartOf(call, prepared->scene->loop, thread, threads),
          prepared->xy.data()));
    }
    part.bits.resize(prepared->bits.size());
  }
  return {prepared->batches.size(),
          [run = FunctionOf<T>(kernel), prepared, parts](std::size_t first,
                                                         std::size_t count) {
            return SecondsOfThreads(parts->size(), [&](std::size_t thread) {
              Part& part = (*parts)[thread];
              RunBatches(run, part.batches, Result<T>{.bits = part.bits.data()},
                         first, count);
            });
          }};
}

// Adds the cells of scenes, which stay alive with what is added.
class Cells {
 public:
  explicit Cells(Benchmarks& benchmarks) : benchmarks_(benchmarks) {}

  template <class T>
  void Add(const std::shared_ptr<const Scene<T>>& scene,
           const ProfileScene& listed,
           const std::vector<const Kernel*>& kernels) {
    if (kernels.empty()) return;
    const SceneTruth truth = JudgeScene(*scene);
    std::array<Prepared<T>, 2> prepared;  // points apart, points side by side
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
      Prepared<T>& own = prepared[aos ? 1 : 0];
      if (!own) own = std::make_shared<PreparedScene<T>>(scene, aos);
      if (kernel->output == Output::kWeights) own->MakeRoomForWeights();
      const bool control =
          listed.methods.empty() && IsControl(*kernel, kernels, MayBeControl);
      AddRows(*kernel, name, listed, own, control);
      if (!listed.threads && placed_.insert(kernel).second) {
        AddPlacements(*kernel, own, truth);
      }
    }
  }

 private:
  template <class T>
  void AddRows(const Kernel& kernel, const std::string& name,
               const ProfileScene& listed, const Prepared<T>& prepared,
               bool control) {
    const Work work = WorkOfCall(*prepared->scene);
    if (listed.threads) {
      for (const int threads : ThreadCounts()) {
        const auto count = static_cast<std::size_t>(threads);
        benchmarks_.Add(name + "/threads:" + std::to_string(threads),
                        TimedOnThreads(kernel, prepared, count), work, threads);
      }
      return;
    }
    const TimedCalls once = Timed<1>(kernel, prepared);
    benchmarks_.Add(name, once, work);
    if (control) {
      benchmarks_.Add(name + "/twin", once, work);
      // A long call is the only one of its scene: the second time it finds in
      // the last cache some of what it left there.
      if (!once.time_parts) {
        benchmarks_.Add(name + "/doubled", Timed<2>(kernel, prepared), work);
      }
    }
  }

  // The copies of a kernel whose code lies elsewhere, as `…/placed_<shift>`.
  template <class T>
  void AddPlacements(const Kernel& kernel, const Prepared<T>& prepared,
                     const SceneTruth& truth) {
    for (const Placement& placement : Placements()) {
      const Kernel& copy = placement.kernel;
      if (copy.method.key != kernel.method.key || copy.isa != kernel.isa ||
          copy.loop != kernel.loop || copy.scalar != kernel.scalar ||
          copy.output != kernel.output ||
          Refusal(copy, *prepared->scene, truth)) {
        continue;
      }
      benchmarks_.Add(CellName(copy, prepared->scene->name) + "/placed_" +
                          std::to_string(placement.shift),
                      Timed<1>(copy, prepared), WorkOfCall(*prepared->scene));
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

SpeedRun MeasureSpeed(const Profile& profile, const NameFilter& filter,
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
  return benchmarks.Run(profile.speed_budget);
}

SpeedRun MeasureSpeedOn(const std::vector<Scene<float>>& f32,
                        const std::vector<Scene<double>>& f64,
                        const NameFilter& filter, const SliceBudget& budget) {
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
  return benchmarks.Run(budget);
}

template <class T>
SpeedRun MeasureKernels(const std::vector<const Kernel*>& kernels,
                        const Scene<T>& scene, const SliceBudget& budget) {
  Benchmarks benchmarks;
  Cells cells(benchmarks);
  cells.Add(std::make_shared<const Scene<T>>(scene), ListingOf(scene), kernels);
  return benchmarks.Run(budget);
}

template SpeedRun MeasureKernels(const std::vector<const Kernel*>&,
                                 const Scene<float>&, const SliceBudget&);
template SpeedRun MeasureKernels(const std::vector<const Kernel*>&,
                                 const Scene<double>&, const SliceBudget&);
template SpeedRun MeasureKernels(const std::vector<const Kernel*>&,
                                 const Scene<std::int32_t>&,
                                 const SliceBudget&);

}  // namespace pitbench
