// Generated scenes with their truth, made once a program.
#ifndef PITBENCH_TESTS_JUDGED_SCENE_H_
#define PITBENCH_TESTS_JUDGED_SCENE_H_

#include <map>
#include <string>
#include <utility>

#include "harness/measure/answers.h"
#include "harness/scenes/generate.h"

namespace pitbench {

template <class T>
struct JudgedScene {
  Scene<T> scene;
  SceneTruth truth;
};

// The scene of that name, 20 groups of 67 items where the name does not say
// how much it holds.
template <class T>
const JudgedScene<T>& FindJudgedScene(const std::string& name, Loop loop) {
  static std::map<std::pair<std::string, Loop>, JudgedScene<T>> scenes;
  const auto found = scenes.find({name, loop});
  if (found != scenes.end()) return found->second;
  const Scene<T> scene = MakeScene<T>(ParseScene(name), loop,
                                      {.groups = 20, .size = 67}, kDefaultSeed);
  return scenes
      .emplace(std::pair{name, loop}, JudgedScene<T>{scene, JudgeScene(scene)})
      .first->second;
}

}  // namespace pitbench

#endif  // PITBENCH_TESTS_JUDGED_SCENE_H_
