// A scene in other words: changed so that the exact answers stay what they are,
// or so that every answer has to be "outside".
#ifndef PITBENCH_HARNESS_MEASURE_VARIANTS_H_
#define PITBENCH_HARNESS_MEASURE_VARIANTS_H_

#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "harness/measure/answers.h"

namespace pitbench {

// Answers of a scene that its variants repeat: whole calls from the first on,
// the last of them cut short where it is longer than that.
inline constexpr std::size_t kExamined = 16000;

template <class SceneType>
struct Variants {
  // The class that an answer falls into when it changes, and the scene that
  // changes it. Answer i of call c is about the same thing as in the scene.
  //   reversed_winding        B and C exchanged
  //   rotated_vertices        (A, B, C) become (B, C, A)
  //   swapped_vertices        A and B exchanged; counted only where exchanging
  //                           B and C changes nothing, so that it shows what
  //                           the order does beyond the winding
  //   negated                 every coordinate times −1
  //   scaled_by_power_of_two  times 2^20, or 2^-20 where that overflows; not
  //                           there where either leaves the normal numbers
  // The pixels of loop grid stay where they are: no negated, no scaled there.
  std::vector<std::pair<std::string_view, SceneType>> changed;
  std::size_t of = 0;  // how many answers can change: CallTruth::strict

  // NaN, +∞ and −∞ in turn put into one coordinate after the other: of every
  // second triangle and of every second point. `not_finite_bits` tells the
  // answers that this makes not finite. Nothing for integers, and for a scene
  // that has such answers of its own.
  std::optional<SceneType> not_finite;
  std::vector<Bits> not_finite_bits;
  std::size_t not_finite_of = 0;
};

template <class T>
Variants<Scene<T>> MakeVariants(const Scene<T>& scene, const SceneTruth& truth);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_VARIANTS_H_
