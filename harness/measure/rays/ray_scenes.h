// The scenes of rays of the profiles.
#ifndef PITBENCH_HARNESS_MEASURE_RAYS_RAY_SCENES_H_
#define PITBENCH_HARNESS_MEASURE_RAYS_RAY_SCENES_H_

#include <string>
#include <vector>

#include "harness/measure/cells.h"

namespace pitbench {

// Whether the scene of this name is a mesh: asked pair by pair only.
bool IsRayMesh(const std::string& name);

// These scenes, for f32 and f64 and every loop that they fit.
void AddRays(std::vector<RayProfileScene>& scenes,
             const std::vector<std::string>& names, bool tuv);

// The families of which a parameter is swept, step 1 the finest, and the kinds
// of input that has to be missed.
void AddSweptRays(std::vector<RayProfileScene>& scenes, int step);

// What is timed: the reference scene, its fixed twin where branches matter, and
// from one ray to many where a set-up does; `tuv` as well in full.
void AddTimedRays(std::vector<RayProfileScene>& scenes, bool full);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_RAYS_RAY_SCENES_H_
