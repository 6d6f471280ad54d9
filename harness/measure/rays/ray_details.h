// What SceneDetails (scene_details.h) asks of a scene of rays.
#ifndef PITBENCH_HARNESS_MEASURE_RAYS_RAY_DETAILS_H_
#define PITBENCH_HARNESS_MEASURE_RAYS_RAY_DETAILS_H_

#include <gmpxx.h>

#include <array>
#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "harness/measure/failures.h"
#include "harness/measure/rays/ray_answers.h"
#include "harness/measure/variants.h"

namespace pitbench {

template <class T>
nlohmann::json InputOf(const RayScene<T>& scene, const AnswerPlace& place,
                       bool said_inside);
// EdgeDistanceInUlps; 0 of a coplanar or degenerate answer, which has no u and
// no v.
template <class T>
double DistanceOf(const RayScene<T>& scene, const AnswerPlace& place);
// The same in double precision, to choose by.
template <class T>
double DistanceEstimateOf(const RayScene<T>& scene, const AnswerPlace& place);

// The variants of variants.h. NaN and infinity go into triangles and rays.
template <class T>
Variants<RayScene<T>> MakeVariants(const RayScene<T>& scene,
                                   const SceneTruth& truth);

// A hit whose t, u and v are known exactly.
struct ExactHit {
  std::size_t call;
  std::size_t answer;
  std::array<mpq_class, 3> tuv;
};

// The first hits of each call, some 512 in all.
template <class T>
std::vector<ExactHit> WeighAnswers(const RayScene<T>& scene);

// "tuv" of harness/schema/accuracy.schema.json.
template <class T>
nlohmann::json TuvErrors(const Answers<T>& answers,
                         const std::vector<ExactHit>& hits);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_RAYS_RAY_DETAILS_H_
