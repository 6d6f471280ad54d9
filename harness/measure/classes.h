// In how many ways a kernel is wrong about a scene, each counted by itself.
//
//   false_inside         says inside of a point that is outside, or of a
//                        triangle without an area
//   false_outside        says outside of a point that is inside
//   boundary_accepted    says inside of a point on the boundary: no error, but
//                        the method's own choice
//   not_finite_accepted  says inside where a coordinate is NaN or infinite
//   reversed_winding, rotated_vertices, swapped_vertices, negated,
//   scaled_by_power_of_two
//                        says something else of the same thing told otherwise
//                        (variants.h); points off the boundary only
//   hole, double_hit     no triangle, or more than one, of a mesh claims a
//                        point of its interior
#ifndef PITBENCH_HARNESS_MEASURE_CLASSES_H_
#define PITBENCH_HARNESS_MEASURE_CLASSES_H_

#include <cstddef>
#include <nlohmann/json_fwd.hpp>

#include "harness/measure/scene_details.h"

namespace pitbench {

// "classes" of harness/schema/accuracy.schema.json. `answers` are those of
// Ask(kernel, scene, truth).
template <class T>
nlohmann::json ErrorClasses(const Kernel& kernel, const Answers<T>& answers,
                            SceneDetails<Scene<T>>& details);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_CLASSES_H_
