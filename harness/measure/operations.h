// How many operations of each kind a kernel takes, from a kernel that counts.
#ifndef PITBENCH_HARNESS_MEASURE_OPERATIONS_H_
#define PITBENCH_HARNESS_MEASURE_OPERATIONS_H_

#include <array>
#include <cstddef>
#include <nlohmann/json_fwd.hpp>

#include "harness/input/name_filter.h"
#include "kernels/counting/counting.h"

namespace pitbench {

// By counting::Kind. An operation on n lanes counts n times, so that a vector
// of n points that takes one multiplication makes 1 a point.
using OperationCounts = std::array<double, counting::kKinds>;

struct CountedKernel {
  OperationCounts per_call;  // set-up, and whatever else a call takes
  OperationCounts per_item;  // a point or ray, a triangle, a pair; in loop grid
                             // a triangle with all its 80 × 50 pixels
};

// Runs one of CountingKernels() on n and on 2n random items, half of them
// inside: what the second n took is per item, the rest per call.
CountedKernel CountOperations(const Kernel& kernel);
// The same of CountingRayKernels(), half of the rays hitting; in loop one_ray
// none.
CountedKernel CountOperations(const RayKernel& kernel);

// operations.json without its context: of those kernels whose
// `loop/method/scalar` the filter finds.
nlohmann::json OperationsOf(const NameFilter& filter);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_OPERATIONS_H_
