// How fast each kernel is, where it is right.
//
// A time means nothing without knowing what it is the time of, so every cell
// is first asked for its answers and refused if rounding cannot explain a
// wrong one. Then three things mislead, and each has its measure:
//   - the same points again and again train the branch predictor, so a scene
//     changes its sets from call to call (its fixed twin shows by how much
//     that matters);
//   - the machine's pace drifts, so the repetitions of all cells of a shard are
//     run in random order and compared only within the shard;
//   - a difference may be no difference, so one kernel of every loop is
//     registered twice (`…/twin`): what the two seem to differ by is noise.
// Repetitions are kept, not averaged: the analysis makes intervals of them.
#ifndef PITBENCH_HARNESS_MEASURE_SPEED_H_
#define PITBENCH_HARNESS_MEASURE_SPEED_H_

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <regex>

#include "harness/measure/cells.h"

namespace pitbench {

inline constexpr int kRepetitions = 9;

struct SpeedRun {
  nlohmann::json file;  // Google Benchmark's format, without "pitbench" in
                        // its context
  std::size_t cells = 0;
  std::size_t refused = 0;
};

// Times the cells of the profile's scenes for speed that `filter` finds, on
// the CPU that this process is pinned to.
SpeedRun MeasureSpeed(const Profile& profile, const std::regex& filter,
                      std::uint64_t seed);

// The same for scenes in memory; `seconds` is the least a sample lasts.
SpeedRun MeasureSpeedOn(const std::vector<Scene<float>>& f32,
                        const std::vector<Scene<double>>& f64,
                        const std::regex& filter, double seconds);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_SPEED_H_
