// How right each ray kernel is; as accuracy.h has it for 2D.
#ifndef PITBENCH_HARNESS_MEASURE_RAYS_RAY_ACCURACY_H_
#define PITBENCH_HARNESS_MEASURE_RAYS_RAY_ACCURACY_H_

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "harness/input/name_filter.h"
#include "harness/measure/cells.h"
#include "harness/scenes/rays/ray_scene.h"

namespace pitbench {

// The cells of the profile's scenes of rays that `filter` finds, as
// harness/schema/accuracy.schema.json has them.
nlohmann::json MeasureRayAccuracy(const Profile& profile,
                                  const NameFilter& filter, std::uint64_t seed);

// The same for a scene in memory.
template <class T>
nlohmann::json MeasureRayAccuracyOn(
    const RayScene<T>& scene, const std::vector<const RayKernel*>& kernels);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_RAYS_RAY_ACCURACY_H_
