// What is slow to know about a scene, known once for all kernels that meet it.
#ifndef PITBENCH_HARNESS_MEASURE_SCENE_DETAILS_H_
#define PITBENCH_HARNESS_MEASURE_SCENE_DETAILS_H_

#include <cstddef>
#include <vector>

#include "harness/measure/answers.h"
#include "harness/measure/variants.h"
#include "harness/measure/weight_errors.h"

namespace pitbench {

// An answer of a scene.
struct AnswerPlace {
  std::size_t call;
  std::size_t answer;  // within the call
};

template <class T>
class SceneDetails {
 public:
  // Both outlive this.
  SceneDetails(const Scene<T>& scene, const SceneTruth& truth);

  const Scene<T>& scene() const { return scene_; }
  const SceneTruth& truth() const { return truth_; }

  // How far the answer's point lies from the boundary of its triangle, in ulps
  // (BoundaryDistanceInUlps): an estimate to choose by (DistanceEstimate), kept
  // once it is known; and exactly.
  double Estimate(const AnswerPlace& place);
  double Distance(const AnswerPlace& place) const;

  // The answers to each query of a mesh scene; empty for other scenes.
  const std::vector<std::vector<AnswerPlace>>& Queries() const {
    return queries_;
  }

  const Variants<T>& GetVariants();

  // Memory for the answers to a variant, used again and again.
  Answers<T>& Scratch() { return scratch_; }

  // Some answers and their exact weights.
  const std::vector<WeighedAnswer>& Weighed();

 private:
  const Scene<T>& scene_;
  const SceneTruth& truth_;
  std::vector<std::size_t> first_;  // of each call's answers in estimates_
  std::vector<double> estimates_;   // −1 where not yet known
  std::vector<std::vector<AnswerPlace>> queries_;
  std::vector<Variants<T>> variants_;  // one, once asked for
  std::vector<WeighedAnswer> weighed_;
  Answers<T> scratch_;
};

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_SCENE_DETAILS_H_
