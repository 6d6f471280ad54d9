#include "harness/scenes/generate.h"

#include <type_traits>

#include "harness/scenes/families.h"

namespace pitbench {

template <class T>
Scene<T> MakeScene(const SceneSpec& spec, Loop loop, SceneSize size,
                   std::uint64_t seed) {
  constexpr bool kInteger = std::is_same_v<T, std::int32_t>;
  const bool grid = spec.family == "grid_80x50";
  if (grid != kInteger || grid != (loop == Loop::kGrid)) {
    throw SceneError("scene '" + spec.name + "' has no meaning for loop " +
                     std::string(Name(loop)) + " and scalar " +
                     std::string(Name(ScalarOf<T>())));
  }
  if constexpr (kInteger) {
    return GridScene(spec, seed);
  } else {
    if (spec.family == "uniform") return UniformScene<T>(spec, loop, seed);
    if (spec.family == "near_edge") {
      return NearEdgeScene<T>(spec, loop, size, seed);
    }
    if (spec.family == "needle") return NeedleScene<T>(spec, loop, size, seed);
    if (spec.family == "offset") return OffsetScene<T>(spec, loop, size, seed);
    throw SceneError("scene '" + spec.name +
                     "' is not generated: it takes your own files");
  }
}

template Scene<float> MakeScene(const SceneSpec&, Loop, SceneSize,
                                std::uint64_t);
template Scene<double> MakeScene(const SceneSpec&, Loop, SceneSize,
                                 std::uint64_t);
template Scene<std::int32_t> MakeScene(const SceneSpec&, Loop, SceneSize,
                                       std::uint64_t);

}  // namespace pitbench
