// Your own triangles and points, as --triangles and --points give them.
#ifndef PITBENCH_HARNESS_COMMAND_OWN_SCENES_H_
#define PITBENCH_HARNESS_COMMAND_OWN_SCENES_H_

#include <string>
#include <vector>

#include "harness/scenes/scene.h"

namespace pitbench {

// A scene for every loop that they fit, from two CSV files. Throws InputError.
// T is float or double.
template <class T>
std::vector<Scene<T>> OwnScenes(const std::string& triangles_file,
                                const std::string& points_file);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_COMMAND_OWN_SCENES_H_
