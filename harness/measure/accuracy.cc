#include "harness/measure/accuracy.h"

#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

#include "harness/measure/answers.h"
#include "harness/measure/classes.h"
#include "harness/measure/scene_details.h"
#include "harness/measure/weight_errors.h"

namespace pitbench {
namespace {

using nlohmann::json;

template <class T>
json MeasureCell(const Kernel& kernel, SceneDetails<Scene<T>>& details) {
  const Scene<T>& scene = details.scene();
  const SceneTruth& truth = details.truth();
  const Answers<T> answers = Ask(kernel, scene, truth);
  json cell = CellOf(kernel, scene, truth);
  cell["accepts"] = Name(kernel.method.accepts);
  cell["classes"] = ErrorClasses(kernel, answers, details);
  cell["weights"] = nullptr;
  if constexpr (!std::is_integral_v<T>) {
    if (kernel.output == Output::kWeights) {
      cell["weights"] = WeightErrors(answers, details.Weighed());
    }
  }
  return cell;
}

template <class T>
void Append(json& cells, const ProfileScene& listed, Loop loop, SceneSize size,
            const std::vector<const Kernel*>& kernels, std::uint64_t seed) {
  const Scene<T> scene =
      MakeScene<T>(ParseScene(listed.name), loop, size, seed);
  for (json& cell : MeasureAccuracyOn(scene, kernels)) {
    cells.push_back(std::move(cell));
  }
}

}  // namespace

template <class T>
json MeasureAccuracyOn(const Scene<T>& scene,
                       const std::vector<const Kernel*>& kernels) {
  const SceneTruth truth = JudgeScene(scene);
  SceneDetails<Scene<T>> details(scene, truth);
  json cells = json::array();
  for (const Kernel* kernel : kernels) {
    if (kernel->method.finite_only && truth.not_finite != 0) continue;
    cells.push_back(MeasureCell(*kernel, details));
  }
  return cells;
}

template json MeasureAccuracyOn(const Scene<float>&,
                                const std::vector<const Kernel*>&);
template json MeasureAccuracyOn(const Scene<double>&,
                                const std::vector<const Kernel*>&);
template json MeasureAccuracyOn(const Scene<std::int32_t>&,
                                const std::vector<const Kernel*>&);
template json MeasureAccuracyOn(const Scene<std::int16_t>&,
                                const std::vector<const Kernel*>&);
template json MeasureAccuracyOn(const Scene<std::uint8_t>&,
                                const std::vector<const Kernel*>&);

json MeasureAccuracy(const Profile& profile, const NameFilter& filter,
                     std::uint64_t seed) {
  json cells = json::array();
  for (const ProfileScene& listed : profile.accuracy) {
    for (const Loop loop : listed.loops) {
      const std::vector<const Kernel*> kernels =
          KernelsFor(listed, loop, filter);
      if (kernels.empty()) continue;
      const SceneSize size = profile.accuracy_size;
      switch (listed.scalar) {
        case Scalar::kF32:
          Append<float>(cells, listed, loop, size, kernels, seed);
          break;
        case Scalar::kF64:
          Append<double>(cells, listed, loop, size, kernels, seed);
          break;
        case Scalar::kI32:
          Append<std::int32_t>(cells, listed, loop, size, kernels, seed);
          break;
        case Scalar::kI16:
          Append<std::int16_t>(cells, listed, loop, size, kernels, seed);
          break;
        case Scalar::kU8:
          Append<std::uint8_t>(cells, listed, loop, size, kernels, seed);
          break;
      }
    }
  }
  return cells;
}

}  // namespace pitbench
