// Whether kernels that promise to be right for every finite input are: all
// their answers to hard scenes, boundary points included, held against truth.
#ifndef PITBENCH_HARNESS_MEASURE_VERIFY_H_
#define PITBENCH_HARNESS_MEASURE_VERIFY_H_

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "harness/measure/answers.h"
#include "harness/scenes/scene.h"
#include "kernels/kernels.h"

namespace pitbench {

// The scenes of a verification, every family of hard ones among them.
std::vector<std::string> HardScenes(Scalar scalar);

struct Verification {
  std::size_t points = 0;    // triangles and points, each judged once
  std::size_t boundary = 0;  // of these, points on a boundary
  std::size_t answers = 0;   // of all kernels together
  std::size_t wrong = 0;
  std::string first_wrong;  // in words; empty if none is
  // Exact truth alone: how much it judged (rays under both rules twice), and
  // the seconds that took.
  std::size_t judged = 0;
  double truth_seconds = 0;
};

// The truth that judge() makes, timed.
template <class Judge>
SceneTruth TimedTruth(const Judge& judge, Verification& so_far) {
  const auto start = std::chrono::steady_clock::now();
  SceneTruth truth = judge();
  const std::chrono::duration<double> time =
      std::chrono::steady_clock::now() - start;
  so_far.truth_seconds += time.count();
  so_far.judged +=
      truth.interior + truth.exterior + truth.boundary + truth.degenerate;
  return truth;
}

// Judges `kernels`, which all have scalar T and run here, on `points` points
// or a few more: every scene in every loop, again and again with other seeds.
// progress(so far) is called after every scene.
template <class T>
Verification Verify(
    const std::vector<const Kernel*>& kernels, std::size_t points,
    std::uint64_t seed,
    const std::function<void(const Verification&)>& progress = {});

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_VERIFY_H_
