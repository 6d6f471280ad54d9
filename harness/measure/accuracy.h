// How often and how badly each kernel is wrong.
#ifndef PITBENCH_HARNESS_MEASURE_ACCURACY_H_
#define PITBENCH_HARNESS_MEASURE_ACCURACY_H_

#include <cstdint>
#include <nlohmann/json_fwd.hpp>

#include "harness/input/name_filter.h"
#include "harness/measure/cells.h"

namespace pitbench {

// The cells of the profile's scenes for accuracy that `filter` finds, as the
// array "cells" of harness/schema/accuracy.schema.json.
nlohmann::json MeasureAccuracy(const Profile& profile, const NameFilter& filter,
                               std::uint64_t seed);

// The same for one scene in memory and every kernel that fits it.
template <class T>
nlohmann::json MeasureAccuracyOn(const Scene<T>& scene,
                                 const std::vector<const Kernel*>& kernels);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_ACCURACY_H_
