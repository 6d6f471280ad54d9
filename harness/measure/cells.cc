#include "harness/measure/cells.h"

#include <map>
#include <set>

#include "harness/input/nearest.h"

namespace pitbench {
namespace {

const std::vector<Loop> kFloatLoops = {Loop::kOneTriangle, Loop::kOnePoint,
                                       Loop::kPairs};

// `family:key=value` for each value, for all float loops.
void AddSwept(std::vector<ProfileScene>& scenes, std::string_view prefix,
              const std::vector<int>& values, Scalar scalar) {
  for (const int value : values) {
    scenes.push_back({std::string(prefix) + std::to_string(value), kFloatLoops,
                      scalar, true});
  }
}

// The hard scenes: distance from the edge, needles, distance from the origin.
// The range of the last two grows with the digits of the scalar, up to where
// nothing is left of the triangle.
void AddHard(std::vector<ProfileScene>& scenes, int step) {
  for (const Scalar scalar : {Scalar::kF32, Scalar::kF64}) {
    const int digits = scalar == Scalar::kF32 ? 24 : 53;
    std::vector<int> ulps = {0};
    for (int k = 0; k <= 16; k += step) ulps.push_back(1 << k);
    AddSwept(scenes, "near_edge:ulps=", ulps, scalar);
    std::vector<int> exponents;
    const int exponent_step = scalar == Scalar::kF32 ? 2 * step : 4 * step;
    for (int e = 0; e < digits; e += exponent_step) exponents.push_back(e);
    AddSwept(scenes, "needle:aspect=", exponents, scalar);
    AddSwept(scenes, "offset:ratio=", exponents, scalar);
  }
}

void AddScenes(std::vector<ProfileScene>& scenes,
               std::initializer_list<const char*> names, bool weights) {
  for (const Scalar scalar : {Scalar::kF32, Scalar::kF64}) {
    for (const char* name : names) {
      scenes.push_back({name, kFloatLoops, scalar, weights});
    }
  }
}

void AddGrid(std::vector<ProfileScene>& scenes,
             std::initializer_list<const char*> names) {
  for (const char* name : names) {
    scenes.push_back({name, {Loop::kGrid}, Scalar::kI32, false});
  }
}

// Hard scenes that are timed. Their sets share no points, so a call does not
// find them in L1; all of them together fit a megabyte or two, so in L2.
constexpr SceneSize kHardSpeedSize{.groups = 64, .size = 512};

std::vector<Profile> MakeProfiles() {
  Profile tiny{.name = "tiny",
               .speed = {},
               .accuracy = {},
               .accuracy_size = {.groups = 16, .size = 67},
               .speed_size = {.groups = 4, .size = 67},
               .seconds_per_sample = 1e-4};
  AddScenes(tiny.speed, {"uniform:hit=50:bytes=24k:sets=fresh"}, true);
  AddScenes(tiny.speed, {"uniform:hit=50:bytes=24k:sets=fixed"}, false);
  AddScenes(tiny.speed, {"near_edge:ulps=1:sets=fresh"}, false);
  AddGrid(tiny.speed, {"grid_80x50:sets=fresh"});
  AddGrid(tiny.accuracy, {"grid_80x50:sets=fixed"});
  AddHard(tiny.accuracy, 8);

  // 67 points a triangle: every vector length gets whole vectors and a tail.
  Profile quick{.name = "quick",
                .speed = {},
                .accuracy = {},
                .accuracy_size = {.groups = 1600, .size = 67},
                .speed_size = kHardSpeedSize,
                .seconds_per_sample = 10e-3};
  AddScenes(quick.speed, {"uniform:hit=50:bytes=24k:sets=fresh"}, true);
  AddScenes(quick.speed, {"uniform:hit=50:bytes=24k:sets=fixed"}, false);
  AddGrid(quick.speed, {"grid_80x50:sets=fresh", "grid_80x50:sets=fixed"});
  AddScenes(quick.accuracy, {"uniform:hit=50:bytes=24k:sets=fresh"}, true);
  AddGrid(quick.accuracy, {"grid_80x50:sets=fresh"});
  AddHard(quick.accuracy, 2);

  Profile full{.name = "full",
               .speed = {},
               .accuracy = {},
               .accuracy_size = {.groups = 4000, .size = 67},
               .speed_size = kHardSpeedSize,
               .seconds_per_sample = 5e-2};
  AddScenes(full.speed,
            {"uniform:hit=50:bytes=24k:sets=fresh",
             "uniform:hit=50:bytes=512k:sets=fresh"},
            true);
  AddScenes(full.speed,
            {"uniform:hit=50:bytes=24k:sets=fixed",
             "uniform:hit=10:bytes=24k:sets=fresh",
             "uniform:hit=90:bytes=24k:sets=fresh",
             "uniform:hit=50:bytes=64M:sets=fresh"},
            false);
  AddScenes(full.speed,
            {"near_edge:ulps=1:sets=fresh", "near_edge:ulps=1:sets=fixed",
             "needle:aspect=12:sets=fresh", "needle:aspect=12:sets=fixed",
             "offset:ratio=8:sets=fresh", "offset:ratio=8:sets=fixed"},
            false);
  AddGrid(full.speed, {"grid_80x50:sets=fresh", "grid_80x50:sets=fixed"});
  AddScenes(full.accuracy, {"uniform:hit=50:bytes=24k:sets=fresh"}, true);
  AddGrid(full.accuracy, {"grid_80x50:sets=fresh"});
  AddHard(full.accuracy, 1);
  return {tiny, quick, full};
}

}  // namespace

const Profile& FindProfile(std::string_view name) {
  static const std::vector<Profile> profiles = MakeProfiles();
  std::vector<std::string_view> names;
  for (const Profile& profile : profiles) {
    if (profile.name == name) return profile;
    names.push_back(profile.name);
  }
  throw SceneError(NoSuch("profile", name, names));
}

Profile WithScenes(const Profile& profile,
                   const std::vector<std::string>& scenes) {
  Profile chosen = profile;
  chosen.speed.clear();
  for (const std::string& name : scenes) {
    if (ParseScene(name).family == "grid_80x50") {
      AddGrid(chosen.speed, {name.c_str()});
    } else {
      AddScenes(chosen.speed, {name.c_str()}, true);
    }
  }
  chosen.accuracy = chosen.speed;
  return chosen;
}

std::vector<Shard> Shards(const Profile& profile) {
  // Speed: what is compared with each other, so each loop and scalar. Accuracy:
  // each family and scalar. Maps: all in one, they take a second.
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
    add("accuracy", family, scene.scalar,
        "^[^/]*/" + family + "[:/].*/" + std::string(Name(scene.scalar)) + "/");
  }
  shards.push_back({"maps", "maps", "/"});
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
