// What is slow to know about a scene, known once for all kernels that meet it.
#ifndef PITBENCH_HARNESS_MEASURE_SCENE_DETAILS_H_
#define PITBENCH_HARNESS_MEASURE_SCENE_DETAILS_H_

#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <utility>
#include <vector>

#include "harness/measure/answers.h"
#include "harness/measure/failures.h"
#include "harness/measure/variants.h"
#include "harness/measure/weight_errors.h"

namespace pitbench {

// What is known of an answer of a scene: its input and what was said of it, as
// accuracy.schema.json has it; how far its point lies from the boundary of its
// triangle, in ulps, exactly (BoundaryDistanceInUlps) and by an estimate to
// choose by (DistanceEstimate).
template <class T>
nlohmann::json InputOf(const Scene<T>& scene, const AnswerPlace& place,
                       bool said_inside);
template <class T>
double DistanceOf(const Scene<T>& scene, const AnswerPlace& place);
template <class T>
double DistanceEstimateOf(const Scene<T>& scene, const AnswerPlace& place);

// SceneType is Scene<T> or RayScene<T>.
template <class SceneType>
class SceneDetails {
 public:
  // Both outlive this.
  SceneDetails(const SceneType& scene, const SceneTruth& truth)
      : scene_(scene), truth_(truth) {
    std::size_t answers = 0;
    for (std::size_t c = 0; c < scene.calls.size(); ++c) {
      first_.push_back(answers);
      const std::size_t n = scene.Answers(scene.calls[c]);
      if (!scene.query.empty()) {
        for (std::size_t i = 0; i < n; ++i) {
          const std::uint32_t query = scene.query.at(answers + i);
          if (query >= queries_.size()) queries_.resize(query + 1);
          queries_[query].push_back({c, i});
        }
      }
      answers += n;
    }
    estimates_.assign(answers, -1.0);
  }

  const SceneType& scene() const { return scene_; }
  const SceneTruth& truth() const { return truth_; }

  // The estimate is kept once it is known.
  double Estimate(const AnswerPlace& place) {
    double& estimate = estimates_[first_[place.call] + place.answer];
    if (estimate < 0) estimate = DistanceEstimateOf(scene_, place);
    return estimate;
  }
  double Distance(const AnswerPlace& place) const {
    return DistanceOf(scene_, place);
  }
  nlohmann::json Input(const AnswerPlace& place, bool said_inside) const {
    return InputOf(scene_, place, said_inside);
  }

  // The answers to each query of a mesh scene; empty for other scenes.
  const std::vector<std::vector<AnswerPlace>>& Queries() const {
    return queries_;
  }

  const Variants<SceneType>& GetVariants() {
    if (variants_.empty()) variants_.push_back(MakeVariants(scene_, truth_));
    return variants_.front();
  }

  // Memory for the answers to a variant, used again and again.
  auto& Scratch() { return scratch_; }

  // Some answers and their exact weights (of rays: t, u and v).
  const auto& Weighed() {
    if (weighed_.empty()) weighed_ = WeighAnswers(scene_);
    return weighed_;
  }

 private:
  const SceneType& scene_;
  const SceneTruth& truth_;
  std::vector<std::size_t> first_;  // of each call's answers in estimates_
  std::vector<double> estimates_;   // −1 where not yet known
  std::vector<std::vector<AnswerPlace>> queries_;
  std::vector<Variants<SceneType>> variants_;  // one, once asked for
  decltype(WeighAnswers(std::declval<const SceneType&>())) weighed_;
  Answers<typename SceneType::Coordinate> scratch_;
};

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_SCENE_DETAILS_H_
