// Scenes of rays by name, and what they ask, answer by answer.
#ifndef PITBENCH_TESTS_RAYS_MADE_RAY_SCENE_H_
#define PITBENCH_TESTS_RAYS_MADE_RAY_SCENE_H_

#include <cstddef>
#include <map>
#include <string>

#include "harness/scenes/rays/ray_scene.h"
#include "harness/truth/ray_truth.h"

namespace pitbench {

inline constexpr RayLoop kRayLoops[] = {RayLoop::kOneTriangleRays,
                                        RayLoop::kOneRay, RayLoop::kRayPairs};
inline constexpr SceneSize kRaySize{.groups = 30, .size = 67};

template <class T>
RayScene<T> MakeRays(const std::string& name, RayLoop loop) {
  return MakeRayScene<T>(ParseScene(name), loop, kRaySize, kDefaultSeed);
}

// Calls test(triangle, ray) for every answer of the scene.
template <class T, class Test>
void ForEachRay(const RayScene<T>& scene, const Test& test) {
  for (const RayCall& call : scene.calls) {
    for (std::size_t i = 0; i < call.n; ++i) {
      test(scene.TriangleOf(call, i), scene.RayOf(call, i));
    }
  }
}

inline std::string With(const std::string& name, int number) {
  return name + std::to_string(number);
}

// How many answers of each kind there are.
template <class T>
std::map<RayPosition, std::size_t> Positions(const RayScene<T>& scene) {
  std::map<RayPosition, std::size_t> positions;
  ForEachRay(scene, [&](const Triangle3<T>& t, const Ray<T>& ray) {
    ++positions[Classify(t, ray)];
  });
  return positions;
}

}  // namespace pitbench

#endif  // PITBENCH_TESTS_RAYS_MADE_RAY_SCENE_H_
