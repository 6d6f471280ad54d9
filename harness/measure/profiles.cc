// The scenes of the profiles.
#include <string>

#include "harness/input/nearest.h"
#include "harness/measure/cells.h"
#include "harness/measure/input_scenes.h"
#include "harness/measure/rays/ray_scenes.h"
#include "harness/scenes/rays/ray_scene.h"

namespace pitbench {
namespace {

using Scenes = std::vector<ProfileScene>;

const std::vector<Loop> kFloatLoops = {Loop::kOneTriangle, Loop::kOnePoint,
                                       Loop::kPairs};
const std::vector<Loop> kEveryFloatLoop = {
    Loop::kOneTriangle, Loop::kOneTriangleAos, Loop::kOnePoint, Loop::kPairs};

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
    // In f32 about the 29 binades from which differences round in f64.
    add("cancellation:binades=",
        f32 ? Range(20, 36, 2 * step) : Range(0, 60, 10 * step), true);
    // From where every determinant is exact to all the bits of the scalar.
    add("whole_numbers:bits=",
        f32 ? Range(8, 24, step) : Range(20, 53, 3 * step), true);
    const std::vector<int> mesh_ulps =
        step == 1 ? std::vector{0, 1, 2, 4, 16, 256, 4096}
                  : std::vector{0, 1, 16};
    for (const char* mesh : {"mesh_pair", "mesh_fan", "mesh_triangulation"}) {
      add(std::string(mesh) + ":ulps=", mesh_ulps, false);
    }
  }
}

void AddScenes(Scenes& scenes, std::initializer_list<const char*> names,
               bool weights, const std::vector<Loop>& loops = kFloatLoops) {
  for (const Scalar scalar : {Scalar::kF32, Scalar::kF64}) {
    for (const char* name : names) {
      scenes.push_back({name, loops, scalar, weights});
    }
  }
}

void AddGrid(Scenes& scenes, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    scenes.push_back({name, {Loop::kGrid}, Scalar::kI32, false});
  }
}

// Its pixels as a list of points, in every scalar that there is.
void AddGridPoints(Scenes& scenes, const char* name) {
  for (const Scalar scalar : {Scalar::kI32, Scalar::kI16, Scalar::kU8}) {
    scenes.push_back({name, {Loop::kOneTriangle}, scalar, false});
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

// What points exactly on edges cost a method that looks at them twice, and for
// comparison one that does not.
void AddOnBoundary(Scenes& scenes, Scalar scalar, std::string name) {
  name.append(":sets=fresh");
  scenes.push_back({name,
                    {Loop::kOneTriangle},
                    scalar,
                    false,
                    {"edge_function_fma", "shewchuk_adaptive", "exact"}});
}
void AddEdgeShares(Scenes& scenes, std::initializer_list<int> percents) {
  for (const Scalar scalar : {Scalar::kF32, Scalar::kF64}) {
    for (const int percent : percents) {
      AddOnBoundary(scenes, scalar,
                    "on_edge:percent=" + std::to_string(percent));
    }
  }
}

// The worst of it: nothing but such points, with exponents over so many percent
// of the range of the scalar.
void AddWorstBoundaries(Scenes& scenes, std::initializer_list<int> percents) {
  for (const Scalar scalar : {Scalar::kF32, Scalar::kF64}) {
    const int most = scalar == Scalar::kF32 ? 240 : 2000;
    for (const char* at : {"edge", "vertex"}) {
      for (const int percent : percents) {
        std::string name = "on_boundary:at=";
        name.append(at).append(":binades=");
        AddOnBoundary(scenes, scalar,
                      name + std::to_string(most * percent / 100));
      }
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
               .speed_budget = {.seconds = 1e-4}};
  AddScenes(tiny.speed, {"uniform:hit=50:bytes=24k:sets=fresh"}, true);
  AddScenes(tiny.speed, {"uniform:hit=50:bytes=24k:sets=fixed"}, false);
  AddScenes(tiny.speed, {"near_edge:ulps=1:sets=fresh"}, false);
  AddEdgeShares(tiny.speed, {0, 100});
  AddWorstBoundaries(tiny.speed, {100});
  AddGrid(tiny.speed, {"grid_80x50:sets=fresh"});
  AddGridPoints(tiny.speed, "grid_points_80x50:sets=fixed");
  AddHitRates(tiny.speed, Scalar::kF32, {0, 100}, {"fresh", "fixed"});
  AddSizes(tiny.speed, Scalar::kF32, PointCounts(0, 12, 6), "fresh");
  AddThreads(tiny.speed, Scalar::kF32, "1M");
  AddSideBySide(tiny.speed, Scalar::kF32,
                {"uniform:hit=50:bytes=24k:sets=fresh"});
  AddGrid(tiny.accuracy, {"grid_80x50:sets=fixed"});
  AddGridPoints(tiny.accuracy, "grid_points_80x50:sets=fixed");
  AddSwept(tiny.accuracy, 16, {Loop::kOneTriangle});
  AddKinds(tiny.accuracy);
  AddRays(tiny.ray_speed, {"rays_uniform:hit=50:bytes=24k:sets=fresh"}, false);
  AddRays(tiny.ray_accuracy, {"rays_uniform:hit=50:bytes=24k:sets=fresh"},
          true);
  AddSweptRays(tiny.ray_accuracy, 16);
  return tiny;
}

// 67 points a triangle: every vector length gets whole vectors and a tail.
Profile Quick() {
  Profile quick{.name = "quick",
                .speed = {},
                .accuracy = {},
                .accuracy_size = {.groups = 900, .size = 67},
                .speed_size = kHardSpeedSize,
                .speed_budget = {.seconds = 1e-3}};
  AddScenes(quick.speed, {"uniform:hit=50:bytes=24k:sets=fresh"}, true,
            kEveryFloatLoop);
  AddScenes(quick.speed, {"uniform:hit=50:bytes=24k:sets=fixed"}, false);
  AddGrid(quick.speed, {"grid_80x50:sets=fresh", "grid_80x50:sets=fixed"});
  AddGridPoints(quick.speed, "grid_points_80x50:sets=fresh");
  AddEdgeShares(quick.speed, {0, 1, 10, 100});
  AddWorstBoundaries(quick.speed, {100});
  AddHitRates(quick.speed, Scalar::kF32, {0, 1, 10, 90, 100},
              {"fresh", "fixed"});
  AddSizes(quick.speed, Scalar::kF32, {1}, "fresh");
  AddSizes(quick.speed, Scalar::kF32, PointCounts(4, 12, 2), "fresh");
  AddSizes(quick.speed, Scalar::kF32, PointCounts(16, 24, 4), "fresh");
  quick.speed.push_back({"uniform:hit=50:bytes=512k:sets=fresh",
                         {Loop::kOnePoint},
                         Scalar::kF32,
                         false});
  AddThreads(quick.speed, Scalar::kF32, "64M");
  AddSideBySide(quick.speed, Scalar::kF32,
                {"uniform:hit=50:n=16777216:sets=fresh"});
  AddScenes(quick.accuracy, {"uniform:hit=50:bytes=24k:sets=fresh"}, true,
            kEveryFloatLoop);
  AddGrid(quick.accuracy, {"grid_80x50:sets=fresh"});
  AddGridPoints(quick.accuracy, "grid_points_80x50:sets=fixed");
  AddSwept(quick.accuracy, 2, {Loop::kOneTriangle});
  AddKinds(quick.accuracy);
  AddTimedRays(quick.ray_speed, /*full=*/false);
  AddRays(quick.ray_accuracy, {"rays_uniform:hit=50:bytes=24k:sets=fresh"},
          true);
  AddSweptRays(quick.ray_accuracy, 8);
  return quick;
}

Profile Full() {
  Profile full{.name = "full",
               .speed = {},
               .accuracy = {},
               .accuracy_size = {.groups = 2000, .size = 67},
               .speed_size = kHardSpeedSize,
               .speed_budget = {.seconds = 2.5e-3, .patience = 6}};
  AddScenes(full.speed,
            {"uniform:hit=50:bytes=24k:sets=fresh",
             "uniform:hit=50:bytes=512k:sets=fresh"},
            true, kEveryFloatLoop);
  AddScenes(full.speed,
            {"uniform:hit=50:bytes=24k:sets=fixed",
             "uniform:hit=10:bytes=24k:sets=fresh",
             "uniform:hit=90:bytes=24k:sets=fresh",
             "uniform:hit=50:bytes=4M:sets=fresh",
             "uniform:hit=50:bytes=64M:sets=fresh"},
            false);
  AddScenes(full.speed,
            {"near_edge:ulps=1:sets=fresh", "near_edge:ulps=1:sets=fixed",
             "needle:aspect=12:sets=fresh", "needle:aspect=12:sets=fixed",
             "offset:ratio=8:sets=fresh", "offset:ratio=8:sets=fixed"},
            false, {Loop::kOneTriangle});
  AddGrid(full.speed, {"grid_80x50:sets=fresh", "grid_80x50:sets=fixed"});
  AddGridPoints(full.speed, "grid_points_80x50:sets=fresh");
  AddEdgeShares(full.speed, {0, 1, 2, 5, 10, 20, 50, 100});
  AddWorstBoundaries(full.speed, {0, 25, 50, 75, 100});
  for (const Scalar scalar : {Scalar::kF32, Scalar::kF64}) {
    AddHitRates(full.speed, scalar, {0, 1, 100}, {"fresh", "fixed"});
    AddHitRates(full.speed, scalar, {10, 90}, {"fixed"});  // fresh: above
    // Every power of two where methods overtake each other; f64 has the sizes
    // of the caches beyond in larger steps.
    const int step = scalar == Scalar::kF32 ? 1 : 4;
    AddSizes(full.speed, scalar, PointCounts(0, 12, 1), "fresh");
    AddSizes(full.speed, scalar, PointCounts(12 + step, 24, step), "fresh");
    AddSizes(full.speed, scalar, PointCounts(0, 16, 4), "fixed");
    AddSideBySide(full.speed, scalar, {"uniform:hit=50:bytes=64M:sets=fresh"});
    AddThreads(full.speed, scalar, "64M");
    AddThreads(full.speed, scalar, "128M");
  }
  AddScenes(full.accuracy, {"uniform:hit=50:bytes=24k:sets=fresh"}, true,
            kEveryFloatLoop);
  AddGrid(full.accuracy, {"grid_80x50:sets=fresh"});
  AddGridPoints(full.accuracy, "grid_points_80x50:sets=fresh");
  AddSwept(full.accuracy, 1, kFloatLoops);
  AddKinds(full.accuracy);
  AddTimedRays(full.ray_speed, /*full=*/true);
  AddRays(full.ray_accuracy, {"rays_uniform:hit=50:bytes=24k:sets=fresh"},
          true);
  AddSweptRays(full.ray_accuracy, 4);
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
  chosen.ray_speed.clear();
  for (const std::string& name : scenes) {
    if (ParseScene(name).family == "grid_80x50") {
      AddGrid(chosen.speed, {name.c_str()});
    } else if (ParseScene(name).family == "grid_points_80x50") {
      AddGridPoints(chosen.speed, name.c_str());
    } else if (IsRayFamily(ParseScene(name).family)) {
      AddRays(chosen.ray_speed, {name}, /*tuv=*/true);
    } else {
      AddScenes(chosen.speed, {name.c_str()}, true, kEveryFloatLoop);
    }
  }
  chosen.accuracy = chosen.speed;
  chosen.ray_accuracy = chosen.ray_speed;
  return chosen;
}

}  // namespace pitbench
