#include "harness/measure/classes.h"

#include <cstdint>
#include <nlohmann/json.hpp>

#include "harness/measure/class_counts.h"

namespace pitbench {

using nlohmann::json;

template <class T>
json ErrorClasses(const Kernel& kernel, const Answers<T>& answers,
                  SceneDetails<Scene<T>>& details) {
  json classes;
  AddWrong(answers, details, classes);
  AddChanged(kernel, answers, details, classes);
  if (!kernel.method.finite_only) AddNotFinite(kernel, details, classes);
  AddClaims(answers, details, classes);
  return classes;
}

template json ErrorClasses(const Kernel&, const Answers<float>&,
                           SceneDetails<Scene<float>>&);
template json ErrorClasses(const Kernel&, const Answers<double>&,
                           SceneDetails<Scene<double>>&);
template json ErrorClasses(const Kernel&, const Answers<std::int32_t>&,
                           SceneDetails<Scene<std::int32_t>>&);
template json ErrorClasses(const Kernel&, const Answers<std::int16_t>&,
                           SceneDetails<Scene<std::int16_t>>&);
template json ErrorClasses(const Kernel&, const Answers<std::uint8_t>&,
                           SceneDetails<Scene<std::uint8_t>>&);

}  // namespace pitbench
