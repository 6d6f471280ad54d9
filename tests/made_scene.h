// Scenes by name, and what they ask, answer by answer.
#ifndef PITBENCH_TESTS_MADE_SCENE_H_
#define PITBENCH_TESTS_MADE_SCENE_H_

#include <string>

#include "harness/scenes/generate.h"

namespace pitbench {

inline constexpr Loop kLoops[] = {Loop::kOneTriangle, Loop::kOnePoint,
                                  Loop::kPairs};
inline constexpr SceneSize kSize{.groups = 20, .size = 67};

template <class T>
Scene<T> Make(const std::string& name, Loop loop) {
  return MakeScene<T>(ParseScene(name), loop, kSize, kDefaultSeed);
}

// Calls test(triangle, point) for every answer of the scene.
template <class T, class Test>
void ForEachAnswer(const Scene<T>& scene, const Test& test) {
  for (const Call& call : scene.calls) {
    for (std::size_t i = 0; i < scene.Answers(call); ++i) {
      test(scene.TriangleOf(call, i), scene.PointOf(call, i));
    }
  }
}

}  // namespace pitbench

#endif  // PITBENCH_TESTS_MADE_SCENE_H_
