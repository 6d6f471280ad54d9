// What every verification goes through, of points (verify.h) and of rays
// (rays/ray_verify.h).
#ifndef PITBENCH_HARNESS_MEASURE_VERIFY_ROUNDS_H_
#define PITBENCH_HARNESS_MEASURE_VERIFY_ROUNDS_H_

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "harness/measure/verify.h"
#include "harness/scenes/generate.h"

namespace pitbench {

// How much the scenes of a round hold, so that even the first round of a short
// verification meets all of them. 67 points a triangle: every vector length
// gets whole vectors and a tail. In some rounds they are long, so that blocks
// of the filter are filled too.
inline SceneSize SizeForRound(std::size_t points, std::size_t scenes,
                              std::uint64_t round) {
  if (round % 8 == 7) return {.groups = 4, .size = 5000};
  return {.groups = std::clamp<std::size_t>(points / (scenes * 67), 5, 300),
          .size = 67};
}

// Every scene in every loop, again and again with other seeds, until so many
// points have been judged: verify_on(name, loop, size, seed, so_far).
template <class LoopType, std::size_t kLoops, class VerifyOn>
Verification VerifyInRounds(
    const std::vector<std::string>& names,
    const std::array<LoopType, kLoops>& loops, std::size_t points,
    std::uint64_t seed,
    const std::function<void(const Verification&)>& progress,
    const VerifyOn& verify_on) {
  Verification so_far;
  for (std::uint64_t round = 0; so_far.points < points; ++round) {
    const SceneSize size = SizeForRound(points, kLoops * names.size(), round);
    for (const std::string& name : names) {
      for (const LoopType loop : loops) {
        verify_on(name, loop, size, seed + round, so_far);
      }
      if (progress) progress(so_far);
      if (so_far.points >= points) break;
    }
  }
  return so_far;
}

// "prefix" + each of the values.
inline void AddSwept(std::vector<std::string>& names, const std::string& prefix,
                     std::initializer_list<int> values) {
  for (const int value : values)
    names.push_back(prefix + std::to_string(value));
}

// Families whose kinds a loop could treat each in its own way.
inline void AddKinds(std::vector<std::string>& names, const std::string& prefix,
                     std::initializer_list<const char*> kinds) {
  for (const char* kind : kinds) names.push_back(prefix + kind);
}

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_VERIFY_ROUNDS_H_
