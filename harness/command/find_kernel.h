// A kernel by the names that the command line gives.
#ifndef PITBENCH_HARNESS_COMMAND_FIND_KERNEL_H_
#define PITBENCH_HARNESS_COMMAND_FIND_KERNEL_H_

#include <string>
#include <string_view>
#include <vector>

#include "kernels/kernels.h"

namespace pitbench {

// f32 or f64. Throws InputError for another name.
Scalar FloatScalar(const std::string& name);

// The kernel of loop pairs for a method and scalar: on `isa`, or on the widest
// that runs here if that is empty. Throws InputError if there is none or it
// does not run here; suggests a method or one of `others`, which the caller
// takes for a method as well.
const Kernel& FindPairsKernel(const std::string& method, Scalar scalar,
                              const std::string& isa,
                              const std::vector<std::string_view>& others = {});

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_COMMAND_FIND_KERNEL_H_
