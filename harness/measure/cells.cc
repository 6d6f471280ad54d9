#include "harness/measure/cells.h"

#include <algorithm>
#include <map>
#include <set>

namespace pitbench {
std::vector<Shard> Shards(const Profile& profile) {
  // Speed: what is compared with each other, so each loop and scalar. Accuracy:
  // each family and scalar, all meshes as one. The maps are one shard.
  std::vector<Shard> shards;
  std::set<std::string> names;
  const auto add = [&](const std::string& kind, const std::string& part,
                       Scalar scalar, const std::string& filter) {
    Shard shard{kind + "-" + part + "-" + std::string(Name(scalar)), kind,
                filter};
    if (names.insert(shard.name).second) shards.push_back(shard);
  };
  for (const ProfileScene& scene : profile.speed) {
    for (const Loop loop : scene.loops) {
      const std::string name(Name(loop));
      add("speed", name, scene.scalar,
          "^" + name + "(_weights)?/.*/" + std::string(Name(scene.scalar)) +
              "/");
    }
  }
  for (const ProfileScene& scene : profile.accuracy) {
    const std::string family = ParseScene(scene.name).family;
    const bool mesh = family.starts_with("mesh_");
    add("accuracy", mesh ? "mesh" : family, scene.scalar,
        "^[^/]*/" + (mesh ? "mesh_.*/" : family + "[:/].*/") +
            std::string(Name(scene.scalar)) + "/");
  }
  shards.push_back({.name = "maps", .kind = "maps", .filter = "."});
  return shards;
}

std::string CellName(const Kernel& kernel, std::string_view scene) {
  std::string name(Name(kernel.loop, kernel.output));
  name.append("/").append(scene).append("/").append(kernel.method.key);
  name.append("/").append(Name(kernel.scalar));
  name.append("/").append(Name(kernel.isa));
  return name;
}

std::vector<const Kernel*> KernelsFor(const ProfileScene& scene, Loop loop,
                                      const std::regex& filter) {
  std::vector<const Kernel*> found;
  // RunsHere asks the CPU, which is slow on a virtual one: once an ISA.
  std::map<Isa, bool> runs_here;
  for (const Kernel& kernel : AllKernels()) {
    if (kernel.loop != loop || kernel.scalar != scene.scalar) continue;
    if (kernel.output == Output::kWeights && !scene.weights) continue;
    if (!scene.methods.empty() &&
        std::find(scene.methods.begin(), scene.methods.end(),
                  kernel.method.key) == scene.methods.end()) {
      continue;
    }
    const auto known = runs_here.find(kernel.isa);
    const bool runs = known != runs_here.end()
                          ? known->second
                          : (runs_here[kernel.isa] = RunsHere(kernel.isa));
    if (!runs) continue;
    if (!std::regex_search(CellName(kernel, scene.name), filter)) continue;
    found.push_back(&kernel);
  }
  return found;
}

}  // namespace pitbench
