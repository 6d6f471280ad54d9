// A kernel by the names that the command line gives.
#ifndef PITBENCH_HARNESS_COMMAND_FIND_KERNEL_H_
#define PITBENCH_HARNESS_COMMAND_FIND_KERNEL_H_

#include <string>
#include <string_view>
#include <vector>

#include "kernels/kernels.h"
#include "kernels/rays/ray_kernels.h"

namespace pitbench {

// f32 or f64. Throws InputError for another name.
Scalar FloatScalar(const std::string& name);

// The kernel that answers single cases by a method, for a scalar: of loop
// pairs, or of one_triangle where the method has no other; on `isa`, or on the
// widest that runs here if that is empty. Throws InputError if there is none or
// it does not run here; suggests a method or one of `others`, which the caller
// takes for a method as well.
const Kernel& FindCaseKernel(const std::string& method, Scalar scalar,
                             const std::string& isa,
                             const std::vector<std::string_view>& others = {});

// The same of a ray method: the kernel of loop ray_pairs that writes hits
// alone.
const RayKernel& FindRayPairsKernel(
    const std::string& method, Scalar scalar, const std::string& isa,
    const std::vector<std::string_view>& others = {});

// Whether a method given by name is one for rays: where `said_so`, and where
// only rays have one of that name.
bool MeansRays(const std::string& method, bool said_so);

// What a misspelt method may have meant, besides those of points.
std::vector<std::string_view> RayMethodKeys();

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_COMMAND_FIND_KERNEL_H_
