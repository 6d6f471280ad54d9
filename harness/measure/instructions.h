// How many instructions of a compiled kernel an item takes, and which ones its
// loop repeats.
#ifndef PITBENCH_HARNESS_MEASURE_INSTRUCTIONS_H_
#define PITBENCH_HARNESS_MEASURE_INSTRUCTIONS_H_

#include <nlohmann/json_fwd.hpp>

#include "harness/input/name_filter.h"
#include "harness/measure/instruction_trace.h"
#include "kernels/kernels.h"
#include "kernels/rays/ray_kernels.h"

namespace pitbench {

// Traces a kernel, which must run here and not be of loop grid, on random
// items, half of them inside.
SteadyLoop TraceKernel(const Kernel& kernel);
// The same, and not one that writes t, u and v.
SteadyLoop TraceKernel(const RayKernel& kernel);

// instructions.json without its context: of the kernels that run here, write
// no weights (of rays: loop one_triangle_rays on the widest ISA), and whose
// `loop/method/scalar/isa` the filter finds. Where nothing can be traced, no
// rows and the reason.
nlohmann::json InstructionsOf(const NameFilter& filter);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_INSTRUCTIONS_H_
