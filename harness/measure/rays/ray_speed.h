// The cells of rays among what is timed; as speed.h has it for 2D.
#ifndef PITBENCH_HARNESS_MEASURE_RAYS_RAY_SPEED_H_
#define PITBENCH_HARNESS_MEASURE_RAYS_RAY_SPEED_H_

#include <cstdint>

#include "harness/input/name_filter.h"
#include "harness/measure/benchmarks.h"
#include "harness/measure/cells.h"

namespace pitbench {

// Adds the cells of the profile's scenes of rays that `filter` finds. One
// kernel of every loop stands there a second time (`…/twin`) and once more with
// two calls for one (`…/doubled`).
void AddRayCells(Benchmarks& benchmarks, const Profile& profile,
                 const NameFilter& filter, std::uint64_t seed);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_RAYS_RAY_SPEED_H_
