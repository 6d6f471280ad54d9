#include "harness/measure/scene_details.h"

#include <cstdint>

#include "harness/measure/distance_estimate.h"
#include "harness/truth/weights.h"

namespace pitbench {

template <class T>
SceneDetails<T>::SceneDetails(const Scene<T>& scene, const SceneTruth& truth)
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

template <class T>
double SceneDetails<T>::Estimate(const AnswerPlace& place) {
  double& estimate = estimates_[first_[place.call] + place.answer];
  if (estimate < 0) {
    const Call& call = scene_.calls[place.call];
    estimate = DistanceEstimate(scene_.TriangleOf(call, place.answer),
                                scene_.PointOf(call, place.answer));
  }
  return estimate;
}

template <class T>
double SceneDetails<T>::Distance(const AnswerPlace& place) const {
  const Call& call = scene_.calls[place.call];
  return BoundaryDistanceInUlps(scene_.TriangleOf(call, place.answer),
                                scene_.PointOf(call, place.answer));
}

template <class T>
const Variants<T>& SceneDetails<T>::GetVariants() {
  if (variants_.empty()) variants_.push_back(MakeVariants(scene_, truth_));
  return variants_.front();
}

template <class T>
const std::vector<WeighedAnswer>& SceneDetails<T>::Weighed() {
  if (weighed_.empty()) weighed_ = WeighAnswers(scene_);
  return weighed_;
}

template class SceneDetails<float>;
template class SceneDetails<double>;
template class SceneDetails<std::int32_t>;

}  // namespace pitbench
