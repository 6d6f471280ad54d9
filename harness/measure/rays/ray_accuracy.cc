#include "harness/measure/rays/ray_accuracy.h"

#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "harness/measure/class_counts.h"
#include "harness/measure/rays/ray_details.h"
#include "harness/measure/scene_details.h"

namespace pitbench {
namespace {

using nlohmann::json;

template <class T>
json Classes(const RayKernel& kernel, const Answers<T>& answers,
             SceneDetails<RayScene<T>>& details) {
  json classes;
  AddWrong(answers, details, classes);
  // Which triangle is nearest may change where two are equally near.
  if (kernel.output != RayOutput::kNearest) {
    AddChanged(kernel, answers, details, classes);
    AddNotFinite(kernel, details, classes);
    AddClaims(answers, details, classes);
  }
  // A triangle seen from behind by a method that culls is another question, so
  // what turns triangles round says nothing of it.
  if (kernel.method.culls_backface) {
    for (const char* name :
         {"reversed_winding", "swapped_vertices", "negated"}) {
      classes.erase(name);
    }
  }
  return classes;
}

template <class T>
json MeasureCell(const RayKernel& kernel, SceneDetails<RayScene<T>>& details) {
  const RayScene<T>& scene = details.scene();
  const SceneTruth& truth = details.truth();
  const Answers<T> answers = Ask(kernel, scene, truth);
  json cell = CellOf(kernel, scene, truth);
  cell["culls_backface"] = kernel.method.culls_backface;
  cell["classes"] = Classes(kernel, answers, details);
  if (kernel.output == RayOutput::kTuv) {
    cell["tuv"] = TuvErrors(answers, details.Weighed());
  }
  return cell;
}

}  // namespace

template <class T>
json MeasureRayAccuracyOn(const RayScene<T>& scene,
                          const std::vector<const RayKernel*>& kernels) {
  json cells = json::array();
  for (const bool culls : {false, true}) {
    std::unique_ptr<SceneTruth> truth;
    std::unique_ptr<SceneDetails<RayScene<T>>> details;
    for (const RayKernel* kernel : kernels) {
      if (kernel->method.culls_backface != culls) continue;
      if (!truth) {
        truth = std::make_unique<SceneTruth>(JudgeRays(scene, culls));
        details = std::make_unique<SceneDetails<RayScene<T>>>(scene, *truth);
      }
      cells.push_back(MeasureCell(*kernel, *details));
    }
  }
  return cells;
}

template json MeasureRayAccuracyOn(const RayScene<float>&,
                                   const std::vector<const RayKernel*>&);
template json MeasureRayAccuracyOn(const RayScene<double>&,
                                   const std::vector<const RayKernel*>&);

json MeasureRayAccuracy(const Profile& profile, const NameFilter& filter,
                        std::uint64_t seed) {
  json cells = json::array();
  const auto add = [&]<class T>(const RayProfileScene& listed, RayLoop loop,
                                T) {
    const std::vector<const RayKernel*> kernels =
        KernelsFor(listed, loop, filter);
    if (kernels.empty()) return;
    const RayScene<T> scene = MakeRayScene<T>(ParseScene(listed.name), loop,
                                              profile.RayAccuracySize(), seed);
    for (json& cell : MeasureRayAccuracyOn(scene, kernels)) {
      cells.push_back(std::move(cell));
    }
  };
  for (const RayProfileScene& listed : profile.ray_accuracy) {
    for (const RayLoop loop : listed.loops) {
      if (listed.scalar == Scalar::kF32) {
        add(listed, loop, float{});
      } else {
        add(listed, loop, double{});
      }
    }
  }
  return cells;
}

}  // namespace pitbench
