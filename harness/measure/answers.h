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
template <class SceneType, class CallType, class Visit>
void ForEachAnswer(const SceneType& scene, const CallType& call,
                   const Bits& bits, Visit visit) {
  const std::size_t row = scene.AnswersInRow(call);
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

// Which triangles a call of rays may name as nearest: the first of those with
// the least exact t among all that are hit. What is hit on its boundary may be
// left out, being in or out as the method likes.
struct NearestTruth {
  std::vector<std::size_t> allowed;
  bool none_allowed = false;
  std::size_t expected = 0;  // the nearest hit through an interior, if any
};

struct SceneTruth {
  std::vector<CallTruth> calls;            // as many as the scene has
  std::vector<NearestTruth> nearest = {};  // the same; loop one_ray only
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

// What exact arithmetic says of one answer.
struct Verdict {
  Position position;
  bool finite;
  bool strict;  // see CallTruth; of an interior or exterior one only
};

// The truth of a scene of points or of rays: verdict(call, i) for each answer.
template <class SceneType, class VerdictOf>
SceneTruth JudgeAnswers(const SceneType& scene, const VerdictOf& verdict_of) {
  SceneTruth truth;
  for (const auto& call : scene.calls) {
    CallTruth& judged = truth.calls.emplace_back();
    const std::size_t bytes = scene.OutputBytes(call);
    for (Bits* bits : {&judged.inside, &judged.boundary, &judged.strict,
                       &judged.not_finite}) {
      bits->resize(bytes);
    }
    for (std::size_t i = 0; i < scene.Answers(call); ++i) {
      const std::size_t bit = scene.BitOf(i);
      const Verdict verdict = verdict_of(call, i);
      if (verdict.strict) SetBit(judged.strict, bit);
      switch (verdict.position) {
        case Position::kInside:
          SetBit(judged.inside, bit);
          ++truth.interior;
          break;
        case Position::kBoundary:
          SetBit(judged.boundary, bit);
          ++truth.boundary;
          break;
        case Position::kOutside:
          ++truth.exterior;
          if (verdict.finite) break;
          SetBit(judged.not_finite, bit);
          ++truth.not_finite;
          break;
        case Position::kDegenerate:
          ++truth.degenerate;
          break;
      }
    }
  }
  return truth;
}

// Holds what a kernel wrote, bit by bit, against the truth of the scene.
template <class SceneType, class T>
void JudgeBits(const SceneType& scene, const SceneTruth& truth,
               Answers<T>& answers) {
  for (std::size_t c = 0; c < scene.calls.size(); ++c) {
    const Bits& bits = answers.bits[c];
    const CallTruth& judged = truth.calls[c];
    const std::size_t row = scene.AnswersInRow(scene.calls[c]);
    const std::size_t row_bytes = BitBytes(row);
    for (std::size_t byte = 0; byte < bits.size(); ++byte) {
      const unsigned said = bits[byte];
      const unsigned boundary = judged.boundary[byte];
      answers.boundary_accepted +=
          static_cast<std::size_t>(std::popcount(said & boundary));
      unsigned wrong = (said ^ judged.inside[byte]) & ~boundary & 0xff;
      for (; wrong != 0; wrong &= wrong - 1) {
        const auto bit = static_cast<std::size_t>(std::countr_zero(wrong));
        const std::size_t column = byte % row_bytes * 8 + bit;
        if (column >= row) {
          ++answers.stray_bits;
          continue;
        }
        answers.wrong.push_back(
            {c, byte / row_bytes * row + column, (said >> bit & 1) != 0});
      }
    }
  }
}

// What the kernel reads beside the scene's own arrays, for Scene::BatchOf:
// nothing but for loop one_triangle_aos.
template <class T>
Array<T> PointsFor(const Kernel& kernel, const Scene<T>& scene) {
  return kernel.loop == Loop::kOneTriangleAos ? scene.PointsSideBySide()
                                              : Array<T>();
}

// Answers of a kernel of loop pairs or one_triangle about cases: case i is
// point i and triangle i. Writes BitBytes(cases.n) bytes.
template <class T>
void AskCases(const Kernel& kernel, const Batch<T>& cases, std::uint8_t* bits);

// Runs the kernel once on every call of the scene and judges nothing: sets bits
// and weights only, in memory that `answers` may have already. Precondition:
// the scene's loop is LoopOfScenes of the kernel's, its scalar the kernel's,
// and the kernel's ISA runs here.
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
