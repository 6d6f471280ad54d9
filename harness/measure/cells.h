// The cells of a sweep: which kernels meet which scenes.
#ifndef PITBENCH_HARNESS_MEASURE_CELLS_H_
#define PITBENCH_HARNESS_MEASURE_CELLS_H_

#include <regex>
#include <string>
#include <string_view>
#include <vector>

#include "harness/scenes/generate.h"
#include "kernels/kernels.h"

namespace pitbench {

// A scene of a profile, the loops and the scalar for which it is made, and how
// much it holds.
struct ProfileScene {
  std::string name;
  std::vector<Loop> loops;
  Scalar scalar;
  bool weights;  // whether kernels that write weights meet it too
  std::vector<std::string_view> methods = {};  // only these; all if empty
};

struct Profile {
  std::string_view name;
  std::vector<ProfileScene> speed;
  std::vector<ProfileScene> accuracy;
  SceneSize accuracy_size;  // of the scenes that do not name their own
  SceneSize speed_size;
  double seconds_per_sample;  // how long one repetition lasts, at the least
};

// The profiles `tiny` (for tests), `quick` and `full`. Throws SceneError for
// another name.
const Profile& FindProfile(std::string_view name);

// The profile with these scenes, for every loop and scalar that they fit, in
// place of its own. Throws SceneError for a name that is none.
Profile WithScenes(const Profile& profile,
                   const std::vector<std::string>& scenes);

// A shard: the part of a profile that one process works off into one file.
struct Shard {
  std::string name;    // e.g. "speed-one_triangle-f32"
  std::string kind;    // the command: "speed", "accuracy" or "maps"
  std::string filter;  // a regular expression on the names of cells, or of maps
};
std::vector<Shard> Shards(const Profile& profile);

// `loop/scene/method/scalar/isa`
std::string CellName(const Kernel& kernel, std::string_view scene);

// The kernels that run here, meet `scene` in `loop`, and whose cell the filter
// finds.
std::vector<const Kernel*> KernelsFor(const ProfileScene& scene, Loop loop,
                                      const std::regex& filter);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_CELLS_H_
