// The scenes of the profiles.
#include <string>

#include "harness/input/nearest.h"
#include "harness/measure/cells.h"

namespace pitbench {
namespace {

using Scenes = std::vector<ProfileScene>;

const std::vector<Loop> kFloatLoops = {Loop::kOneTriangle, Loop::kOnePoint,
                                       Loop::kPairs};

// 0, 2^0, 2^step, … 2^16.
std::vector<int> PowersOfTwo(int step) {
  std::vector<int> values = {0};
  for (int k = 0; k <= 16; k += step) values.push_back(1 << k);
  return values;
}

// low, low + step, …, and high.
std::vector<int> Range(int low, int high, int step) {
  std::vector<int> values;
  for (int k = low; k < high; k += step) values.push_back(k);
  values.push_back(high);
  return values;
}

// The families of which a parameter is swept: step 1 is the finest. They meet
// the loops `swept`, but one that all loops meet: the arithmetic of a method is
// the same in every loop.
void AddSwept(Scenes& scenes, int step, const std::vector<Loop>& swept) {
  for (const Scalar scalar : {Scalar::kF32, Scalar::kF64}) {
    const auto add = [&](std::string_view prefix,
                         const std::vector<int>& values, bool weights) {
      for (const int value : values) {
        const std::string name = std::string(prefix) + std::to_string(value);
        scenes.push_back({name,
                          name == "near_edge:ulps=1" ? kFloatLoops : swept,
                          scalar, weights});
      }
    };
    const bool f32 = scalar == Scalar::kF32;
    add("near_edge:ulps=", PowersOfTwo(step), true);
    add("near_vertex:ulps=", PowersOfTwo(4 * step), true);
    add("needle:aspect=", Range(0, 40, 2 * step), true);
    // Up to where the square is as large as an ulp of its place.
    add("offset:ratio=", f32 ? Range(0, 24, 2 * step) : Range(0, 52, 4 * step),
        true);
    // All there is, in 16 parts.
    add("scale:exponent=",
        f32 ? Range(-145, 127, 17 * step) : Range(-1070, 1023, 131 * step),
        true);
    add("exponent_spread:binades=",
        f32 ? Range(0, 60, 6 * step) : Range(0, 120, 12 * step), true);
    const std::vector<int> mesh_ulps =
        step == 1 ? std::vector{0, 1, 2, 4, 16, 256, 4096}
                  : std::vector{0, 1, 16};
    for (const char* mesh : {"mesh_pair", "mesh_fan", "mesh_triangulation"}) {
      add(std::string(mesh) + ":ulps=", mesh_ulps, false);
    }
  }
}

void AddScenes(Scenes& scenes, std::initializer_list<const char*> names,
               bool weights) {
  for (const Scalar scalar : {Scalar::kF32, Scalar::kF64}) {
    for (const char* name : names) {
      scenes.push_back({name, kFloatLoops, scalar, weights});
    }
  }
}

void AddGrid(Scenes& scenes, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    scenes.push_back({name, {Loop::kGrid}, Scalar::kI32, false});
  }
}

// The families that all loops meet, since a loop could treat them in its own
// way; their weights are of no use, where they have any.
void AddKinds(Scenes& scenes) {
  AddScenes(scenes,
            {"degenerate:kind=collinear", "degenerate:kind=doubled",
             "degenerate:kind=single", "special:kind=nan",
             "special:kind=infinite", "special:kind=minus_zero",
             "special:kind=subnormal", "special:kind=largest", "corpus"},
            false);
}

// What points on edges cost a method that looks at them twice, and for
// comparison one that does not.
void AddEdgeShares(Scenes& scenes, std::initializer_list<int> percents) {
  for (const Scalar scalar : {Scalar::kF32, Scalar::kF64}) {
    for (const int percent : percents) {
      scenes.push_back(
          {"edge_share:percent=" + std::to_string(percent) + ":sets=fresh",
           {Loop::kOneTriangle},
           scalar,
           false,
           {"edge_function_fma", "shewchuk_adaptive", "exact"}});
    }
  }
}

// Hard scenes that are timed. Their sets share no points, so a call does not
// find them in L1; all of them together fit a megabyte or two, so in L2.
constexpr SceneSize kHardSpeedSize{.groups = 64, .size = 512};

Profile Tiny() {
  Profile tiny{.name = "tiny",
               .speed = {},
               .accuracy = {},
               .accuracy_size = {.groups = 16, .size = 67},
               .speed_size = {.groups = 4, .size = 67},
               .seconds_per_sample = 1e-4};
  AddScenes(tiny.speed, {"uniform:hit=50:bytes=24k:sets=fresh"}, true);
  AddScenes(tiny.speed, {"uniform:hit=50:bytes=24k:sets=fixed"}, false);
  AddScenes(tiny.speed, {"near_edge:ulps=1:sets=fresh"}, false);
  AddEdgeShares(tiny.speed, {0, 100});
  AddGrid(tiny.speed, {"grid_80x50:sets=fresh"});
  AddGrid(tiny.accuracy, {"grid_80x50:sets=fixed"});
  AddSwept(tiny.accuracy, 16, {Loop::kOneTriangle});
  AddKinds(tiny.accuracy);
  return tiny;
}

// 67 points a triangle: every vector length gets whole vectors and a tail.
Profile Quick() {
  Profile quick{.name = "quick",
                .speed = {},
                .accuracy = {},
                .accuracy_size = {.groups = 900, .size = 67},
                .speed_size = kHardSpeedSize,
                .seconds_per_sample = 4e-3};
  AddScenes(quick.speed, {"uniform:hit=50:bytes=24k:sets=fresh"}, true);
  AddScenes(quick.speed, {"uniform:hit=50:bytes=24k:sets=fixed"}, false);
  AddGrid(quick.speed, {"grid_80x50:sets=fresh", "grid_80x50:sets=fixed"});
  AddEdgeShares(quick.speed, {0, 1, 10, 100});
  AddScenes(quick.accuracy, {"uniform:hit=50:bytes=24k:sets=fresh"}, true);
  AddGrid(quick.accuracy, {"grid_80x50:sets=fresh"});
  AddSwept(quick.accuracy, 2, {Loop::kOneTriangle});
  AddKinds(quick.accuracy);
  return quick;
}

Profile Full() {
  Profile full{.name = "full",
               .speed = {},
               .accuracy = {},
               .accuracy_size = {.groups = 2000, .size = 67},
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
  AddEdgeShares(full.speed, {0, 1, 2, 5, 10, 20, 50, 100});
  AddScenes(full.accuracy, {"uniform:hit=50:bytes=24k:sets=fresh"}, true);
  AddGrid(full.accuracy, {"grid_80x50:sets=fresh"});
  AddSwept(full.accuracy, 1, kFloatLoops);
  AddKinds(full.accuracy);
  return full;
}

}  // namespace

const Profile& FindProfile(std::string_view name) {
  static const std::vector<Profile> profiles = {Tiny(), Quick(), Full()};
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

}  // namespace pitbench
