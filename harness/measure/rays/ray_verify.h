// Whether ray kernels that promise to be right for every finite input are, as
// verify.h has it for 2D: hits, and of loop one_ray which triangle is nearest.
#ifndef PITBENCH_HARNESS_MEASURE_RAYS_RAY_VERIFY_H_
#define PITBENCH_HARNESS_MEASURE_RAYS_RAY_VERIFY_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "harness/measure/verify.h"
#include "kernels/rays/ray_kernels.h"

namespace pitbench {

// The scenes of a verification, every family of hard rays among them.
std::vector<std::string> HardRayScenes();

// As Verify, a ray and a triangle for a point and a triangle. Of a method that
// is not closed, what goes through an edge or a vertex may be in or out; of a
// closed one it has to be in. t, u and v are not looked at.
template <class T>
Verification VerifyRays(
    const std::vector<const RayKernel*>& kernels, std::size_t rays,
    std::uint64_t seed,
    const std::function<void(const Verification&)>& progress = {});

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_RAYS_RAY_VERIFY_H_
