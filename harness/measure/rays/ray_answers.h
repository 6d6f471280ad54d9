// The true answers of a scene of rays, and a kernel's answers held against
// them. Where the words of answers.h fit they are used: inside is a hit.
#ifndef PITBENCH_HARNESS_MEASURE_RAYS_RAY_ANSWERS_H_
#define PITBENCH_HARNESS_MEASURE_RAYS_RAY_ANSWERS_H_

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "harness/measure/answers.h"
#include "harness/scenes/rays/ray_scene.h"

namespace pitbench {

// Of loops one_triangle_rays and ray_pairs: a bit an answer, hits through the
// interior in `inside`, those through edges and vertices in `boundary`. Of loop
// one_ray the same bits, triangle by triangle: what may be the nearest is told
// by NearestIsRight. A method that culls is asked another question, so its
// truth is another: triangles seen from behind are missed. Coplanar rays are
// misses that rounding may take for hits (not `strict`).
template <class T>
SceneTruth JudgeRays(const RayScene<T>& scene, bool culls_backface);

// What a kernel wrote for a scene. Answers::weights are t, u and v. Of output
// kNearest, `bits` holds the one bit of the nearest triangle, if any, and
// weights[0] the t of each call.
template <class T>
void Run(const RayKernel& kernel, const RayScene<T>& scene,
         Answers<T>& answers);

// The same, judged. Of output kNearest a wrong answer is a triangle said to be
// nearest that is not hit (said_inside), or the nearest triangle where another
// or none is said.
template <class T>
Answers<T> Ask(const RayKernel& kernel, const RayScene<T>& scene,
               const SceneTruth& truth);

// A wrong answer in words: "says hit of a ray from …, which is miss".
template <class T>
std::string Describe(const RayScene<T>& scene, const Wrong& wrong);

// Why the kernel must not be timed on this scene, or nothing: a wrong answer
// that rounding (RoundingMayDecide with kSlack) does not excuse.
template <class T>
std::optional<std::string> Refusal(const RayKernel& kernel,
                                   const RayScene<T>& scene,
                                   const SceneTruth& truth);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_RAYS_RAY_ANSWERS_H_
