// The cells of a sweep: which kernels meet which scenes.
#ifndef PITBENCH_HARNESS_MEASURE_CELLS_H_
#define PITBENCH_HARNESS_MEASURE_CELLS_H_

#include <string>
#include <string_view>
#include <vector>

#include "harness/input/name_filter.h"
#include "harness/measure/slices.h"
#include "harness/scenes/generate.h"
#include "kernels/kernels.h"
#include "kernels/rays/ray_kernels.h"

namespace pitbench {

// A scene of a profile, the loops and the scalar for which it is made, and how
// much it holds.
template <class LoopOf>
struct ListedScene {
  std::string name;
  std::vector<LoopOf> loops;
  Scalar scalar;
  // Whether kernels that write weights (of rays: t, u and v) meet it too.
  bool weights;
  std::vector<std::string_view> methods = {};  // only these; all if empty
  std::vector<Isa> isas = {};                  // only these; all if empty
  // Whether it is timed by 1 to all CPUs at once, in a shard of its own.
  bool threads = false;
};
using ProfileScene = ListedScene<Loop>;
using RayProfileScene = ListedScene<RayLoop>;

struct Profile {
  std::string_view name;
  std::vector<ProfileScene> speed;
  std::vector<ProfileScene> accuracy;
  SceneSize accuracy_size;  // of the scenes that do not name their own
  SceneSize speed_size;
  SliceBudget speed_budget;
  std::vector<RayProfileScene> ray_speed = {};
  std::vector<RayProfileScene> ray_accuracy = {};
  // Of the rays' hard scenes: exact answers take longer in space.
  SceneSize RayAccuracySize() const {
    return {.groups = accuracy_size.groups / 6 + 1, .size = accuracy_size.size};
  }
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
  std::string name;  // e.g. "speed-one_triangle-f32"
  std::string kind;  // the command: "limits", "speed", "accuracy", "maps", …
  std::string filter;  // a regular expression on the names of cells, maps, …
};
std::vector<Shard> Shards(const Profile& profile);

// `loop/scene/method/scalar/isa`. KernelType is Kernel or RayKernel.
template <class KernelType>
std::string CellName(const KernelType& kernel, std::string_view scene) {
  std::string name(Name(kernel.loop, kernel.output));
  name.append("/").append(scene).append("/").append(kernel.method.key);
  name.append("/").append(Name(kernel.scalar));
  name.append("/").append(Name(kernel.isa));
  return name;
}
// What filters look at: the same, with `/threads` behind it where the scene is
// timed by several threads.
template <class KernelType, class LoopOf>
std::string CellName(const KernelType& kernel,
                     const ListedScene<LoopOf>& scene) {
  return CellName(kernel, scene.name) + (scene.threads ? "/threads" : "");
}

// The kernels that run here, meet `scene` in `loop`, and whose cell the filter
// finds.
std::vector<const Kernel*> KernelsFor(const ProfileScene& scene, Loop loop,
                                      const NameFilter& filter);
std::vector<const RayKernel*> KernelsFor(const RayProfileScene& scene,
                                         RayLoop loop,
                                         const NameFilter& filter);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_CELLS_H_
