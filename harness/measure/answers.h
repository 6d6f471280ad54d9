// The true answers of a scene, and a kernel's answers held against them.
#ifndef PITBENCH_HARNESS_MEASURE_ANSWERS_H_
#define PITBENCH_HARNESS_MEASURE_ANSWERS_H_

#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "harness/scenes/scene.h"

namespace pitbench {

using Bits = std::vector<std::uint8_t>;

inline bool BitAt(const Bits& bits, std::size_t i) {
  return (bits[i / 8] >> (i % 8) & 1) != 0;
}
inline void SetBit(Bits& bits, std::size_t i) {
  bits[i / 8] = static_cast<std::uint8_t>(bits[i / 8] | 1u << (i % 8));
}

// Calls visit(i) for every answer i of `call` whose bit is set in `bits`, which
// has none past the end of a row.
template <class T, class Visit>
void ForEachAnswer(const Scene<T>& scene, const Call& call, const Bits& bits,
                   Visit visit) {
  const std::size_t row = scene.loop == Loop::kGrid ? scene.width : call.n;
  const std::size_t row_bytes = BitBytes(row);
  for (std::size_t byte = 0; byte < bits.size(); ++byte) {
    for (unsigned left = bits[byte]; left != 0; left &= left - 1) {
      visit(byte / row_bytes * row + byte % row_bytes * 8 +
            static_cast<std::size_t>(std::countr_zero(left)));
    }
  }
}

// Truth for one call, in the layout of the kernel's own output: a bit an
// answer. Interior points are in `inside`, boundary points in `boundary`,
// those outside or of a degenerate triangle in neither.
struct CallTruth {
  Bits inside;
  Bits boundary;
  // Finite, of a triangle with an area, and not on its boundary: no boundary
  // rule and no change of winding, order, sign or scale alters the answer.
  Bits strict;
  Bits not_finite;  // some coordinate is NaN or infinite
};

struct SceneTruth {
  std::vector<CallTruth> calls;  // as many as the scene has
  // How many answers of the scene are of each kind.
  std::size_t interior = 0;
  std::size_t exterior = 0;  // those that are not finite included
  std::size_t boundary = 0;
  std::size_t degenerate = 0;
  std::size_t not_finite = 0;
};

template <class T>
SceneTruth JudgeScene(const Scene<T>& scene);

// A wrong answer: a kernel said inside of a point that is outside (or of a
// degenerate triangle), or the reverse. Boundary points are never wrong.
struct Wrong {
  std::size_t call;
  std::size_t answer;  // within the call
  bool said_inside;
};

// What a kernel wrote for a scene.
template <class T>
struct Answers {
  std::vector<Bits> bits;            // one a call
  std::vector<Array<T>> weights[3];  // one a call; empty without weights
  std::vector<Wrong> wrong;
  std::size_t boundary_accepted = 0;
  std::size_t stray_bits = 0;  // set past the last answer of a row
};

// Runs the kernel once on every call of the scene and judges nothing: sets bits
// and weights only, in memory that `answers` may have already. Precondition:
// the kernel's loop and scalar are the scene's, and its ISA runs here.
template <class T>
void Run(const Kernel& kernel, const Scene<T>& scene, Answers<T>& answers);

template <class T>
Answers<T> Run(const Kernel& kernel, const Scene<T>& scene) {
  Answers<T> answers;
  Run(kernel, scene, answers);
  return answers;
}

// The same, judged.
template <class T>
Answers<T> Ask(const Kernel& kernel, const Scene<T>& scene,
               const SceneTruth& truth);

// Why the kernel must not be timed on this scene, or nothing. An answer may be
// wrong only where rounding may decide (RoundingMayDecide with kSlack), or
// where the method declares that it accepts less than the triangle; weights
// may be off by as much as that.
template <class T>
std::optional<std::string> Refusal(const Kernel& kernel, const Scene<T>& scene,
                                   const SceneTruth& truth);

// The rounding errors that a kernel is allowed before it is timed, in units of
// u·(M/h)² (see RoundingMayDecide): a dozen roundings of every method, doubled
// for good measure.
inline constexpr double kSlack = 32;

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_ANSWERS_H_
