#include "harness/measure/cells.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <set>
#include <span>

#include "harness/measure/measured_kernels.h"

namespace pitbench {
namespace {

template <class T>
bool Among(const std::vector<T>& allowed, const T& one) {
  return allowed.empty() ||
         std::find(allowed.begin(), allowed.end(), one) != allowed.end();
}

// A library takes so long for a point that where the points lie in memory makes
// no difference, and with an index to build for each of a million triangles a
// call would take seconds.
constexpr std::int64_t kLargestForLibraries = 64 << 10;

bool TooLargeForLibraries(const std::string& scene) {
  // A scene of the user's own has a name that need not be one of ours.
  if (scene.find(":bytes=") == std::string::npos) return false;
  const SceneSpec spec = ParseScene(scene);
  return spec.Number("bytes", 1, std::numeric_limits<std::int64_t>::max()) >
         kLargestForLibraries;
}

// The cells of a loop and a scalar.
std::string LoopFilter(const std::string& loop, const std::string& with_output,
                       const std::string& scalar) {
  return "^" + loop + "(" + with_output + ")?/.*/" + scalar + "/[^/]*$";
}

bool WritesMore(const Kernel& kernel) {
  return kernel.output == Output::kWeights;
}
bool WritesMore(const RayKernel& kernel) {
  return kernel.output == RayOutput::kTuv;
}

template <class KernelType, class LoopOf>
std::vector<const KernelType*> Meeting(std::span<const KernelType> kernels,
                                       const ListedScene<LoopOf>& scene,
                                       LoopOf loop, const NameFilter& filter) {
  std::vector<const KernelType*> found;
  for (const KernelType& kernel : kernels) {
    if (kernel.loop != loop || kernel.scalar != scene.scalar) continue;
    if (WritesMore(kernel) && !scene.weights) continue;
    if (!Among(scene.methods, kernel.method.key)) continue;
    if (!Among(scene.isas, kernel.isa)) continue;
    if (!RunsHere(kernel.isa)) continue;
    if (!filter.Finds(CellName(kernel, scene))) continue;
    found.push_back(&kernel);
  }
  return found;
}

}  // namespace

std::vector<Shard> Shards(const Profile& profile) {
  // Speed: what is compared with each other, so each loop and scalar, and the
  // pixels of the grid with the same as points, whatever the scalar. Accuracy:
  // each family and scalar, all meshes as one. The limits of the machine are
  // measured before the speed and again after it, since a machine that others
  // share changes; the maps are one shard, and so is each count.
  std::vector<Shard> shards = {
      {.name = "limits", .kind = "limits", .filter = "."}};
  std::set<std::string> names;
  const auto add = [&](const std::string& kind, const std::string& part,
                       Scalar scalar, const std::string& filter) {
    Shard shard{kind + "-" + part + "-" + std::string(Name(scalar)), kind,
                filter};
    if (names.insert(shard.name).second) shards.push_back(shard);
  };
  for (const ProfileScene& scene : profile.speed) {
    for (const Loop loop : scene.loops) {
      const std::string name(Name(LoopOfScenes(loop)));
      if (!IsFloat(scene.scalar)) {
        if (names.insert("speed-grid").second) {
          shards.push_back({"speed-grid", "speed", "^[^/]*/grid_"});
        }
        continue;
      }
      const std::string scalar(Name(scene.scalar));
      if (scene.threads) {
        add("speed", "threads", scene.scalar,
            std::string("/").append(scalar).append("/[^/]*/threads$"));
        continue;
      }
      add("speed", name, scene.scalar,
          LoopFilter(name, "_weights|_aos", scalar));
    }
  }
  for (const RayProfileScene& scene : profile.ray_speed) {
    for (const RayLoop loop : scene.loops) {
      const std::string name(Name(loop));
      add("speed", name, scene.scalar,
          LoopFilter(name, "_tuv", std::string(Name(scene.scalar))));
    }
  }
  shards.push_back({.name = "limits_after", .kind = "limits", .filter = "."});
  const auto add_accuracy = [&](const auto& scenes) {
    for (const auto& scene : scenes) {
      const std::string family = ParseScene(scene.name).family;
      const bool mesh = family.starts_with("mesh_");
      add("accuracy", mesh ? "mesh" : family, scene.scalar,
          "^[^/]*/" + (mesh ? "mesh_.*/" : family + "[:/].*/") +
              std::string(Name(scene.scalar)) + "/");
    }
  };
  add_accuracy(profile.accuracy);
  add_accuracy(profile.ray_accuracy);
  shards.push_back({.name = "operations", .kind = "operations", .filter = "."});
  // A trap for each instruction takes its time, and a narrow ISA has the most
  // of them: of those only what tells why one is slower than the one below it.
  // Those for arm64 are emulated (emulated_loops.h), which is fast.
  const std::string widest = RunsHere(Isa::kAvx512) ? "avx512" : "avx2";
  const std::string narrow =
      profile.name == "full"
          ? "|/(scalar|ssse3|sse4|avx2)$"
          : "|/(?!double_double)[a-z0-9_]+/f32/(ssse3|sse4)$";
  const std::string traced =
      profile.name == "tiny"
          ? "^one_triangle/.*/f32/(" + widest + "|neon)$"
          : "/" + widest + "$|^one_triangle/.*/(avx2|neon|sve|sve2)$" + narrow;
  shards.push_back(
      {.name = "instructions", .kind = "instructions", .filter = traced});
  shards.push_back({.name = "maps", .kind = "maps", .filter = "."});
  return shards;
}

std::vector<const Kernel*> KernelsFor(const ProfileScene& scene, Loop loop,
                                      const NameFilter& filter) {
  std::vector<const Kernel*> found =
      Meeting(MeasuredKernels(), scene, loop, filter);
  if (TooLargeForLibraries(scene.name)) {
    std::erase_if(found, [](const Kernel* kernel) {
      return kernel->isa == Isa::kLibrary;
    });
  }
  return found;
}

std::vector<const RayKernel*> KernelsFor(const RayProfileScene& scene,
                                         RayLoop loop,
                                         const NameFilter& filter) {
  return Meeting(MeasuredRayKernels(), scene, loop, filter);
}

}  // namespace pitbench
