// How fast each kernel is, where it is right.
//
// A time means nothing without knowing what it is the time of, so every cell
// is first asked for its answers and refused if rounding cannot explain a
// wrong one. Then three things mislead, and each has its measure:
//   - the same points again and again train the branch predictor, so a scene
//     changes its sets from call to call (its fixed twin shows by how much
//     that matters);
//   - the machine is disturbed and its pace drifts, so all cells of a shard are
//     timed together in short slices (slices.h), and compared only within the
//     shard;
//   - a difference may be no difference, so one kernel of every loop is
//     registered twice (`…/twin`): what the two seem to differ by is noise; and
//     a real one may be missed, so it is there a third time with two calls for
//     one (`…/doubled`), which has to come out at twice the time (not where a
//     call is timed in parts: of its scene there is one call only);
//   - where code lies changes its time, so some kernels are timed with theirs
//     in other places too (`…/placed_<bytes>`, kernels/placements.h).
// Repetitions are kept, not averaged: the analysis makes intervals of them.
#ifndef PITBENCH_HARNESS_MEASURE_SPEED_H_
#define PITBENCH_HARNESS_MEASURE_SPEED_H_

#include <cstdint>

#include "harness/input/name_filter.h"
#include "harness/measure/benchmarks.h"
#include "harness/measure/cells.h"

namespace pitbench {

// Times the cells of the profile's scenes for speed that `filter` finds, on
// the CPU that this process is pinned to.
SpeedRun MeasureSpeed(const Profile& profile, const NameFilter& filter,
                      std::uint64_t seed);

// The same for scenes in memory.
SpeedRun MeasureSpeedOn(const std::vector<Scene<float>>& f32,
                        const std::vector<Scene<double>>& f64,
                        const NameFilter& filter, const SliceBudget& budget);

// The same for kernels that need not be of AllKernels(), all of the scene's
// loop and scalar.
template <class T>
SpeedRun MeasureKernels(const std::vector<const Kernel*>& kernels,
                        const Scene<T>& scene, const SliceBudget& budget);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_SPEED_H_
