#include "harness/measure/rays/ray_scenes.h"

#include "harness/scenes/rays/ray_scene.h"

namespace pitbench {
namespace {

const std::vector<RayLoop> kEveryLoop = {RayLoop::kOneTriangleRays,
                                         RayLoop::kOneRay, RayLoop::kRayPairs};
const std::vector<RayLoop> kOneTriangle = {RayLoop::kOneTriangleRays};

void Add(std::vector<RayProfileScene>& scenes, const std::string& name,
         const std::vector<RayLoop>& loops, bool tuv,
         const std::vector<std::string_view>& methods = {},
         const std::vector<Isa>& isas = {}) {
  for (const Scalar scalar : {Scalar::kF32, Scalar::kF64}) {
    scenes.push_back({name,
                      IsRayMesh(name) ? std::vector{RayLoop::kRayPairs} : loops,
                      scalar, tuv, methods, isas});
  }
}

// How branches fare by the share of rays that hit, in percent; f32 alone unless
// `every_scalar`.
void AddHits(std::vector<RayProfileScene>& scenes,
             const std::vector<int>& percents, const char* sets,
             bool every_scalar, const std::vector<std::string_view>& methods,
             const std::vector<Isa>& isas) {
  for (const int percent : percents) {
    const std::string name = "rays_uniform:hit=" + std::to_string(percent) +
                             ":bytes=24k:sets=" + sets;
    Add(scenes, name, kOneTriangle, false, methods, isas);
    if (!every_scalar) scenes.pop_back();
  }
}

}  // namespace

bool IsRayMesh(const std::string& name) {
  return name.starts_with("rays_icosphere") ||
         name.starts_with("rays_tiled_plane");
}

void AddRays(std::vector<RayProfileScene>& scenes,
             const std::vector<std::string>& names, bool tuv) {
  for (const std::string& name : names) Add(scenes, name, kEveryLoop, tuv);
}

void AddSweptRays(std::vector<RayProfileScene>& scenes, int step) {
  const auto sweep = [&](const std::string& prefix, int low, int high,
                         bool powers) {
    for (int k = low; k <= high; k += step) {
      Add(scenes, prefix + std::to_string(powers ? 1 << k : k), kOneTriangle,
          true);
    }
  };
  Add(scenes, "rays_near_edge:ulps=0", kEveryLoop, true);
  sweep("rays_near_edge:ulps=", 0, 16, true);
  Add(scenes, "rays_near_vertex:ulps=0", kOneTriangle, true);
  sweep("rays_near_vertex:ulps=", 0, 16, true);
  sweep("rays_grazing:exponent=", 0, 40, false);
  sweep("rays_needle:aspect=", 0, 40, false);
  sweep("rays_far_origin:exponent=", 0, 40, false);
  sweep("rays_offset:ratio=", 0, 40, false);
  for (const char* surface :
       {"rays_icosphere:ulps=", "rays_tiled_plane:ulps="}) {
    for (const char* ulps : {"0", "1", "16"}) {
      Add(scenes, std::string(surface) + ulps, kOneTriangle, false);
    }
  }
  // A loop could treat these in its own way.
  for (const char* kind :
       {"collinear", "doubled", "single", "zero_direction", "parallel"}) {
    Add(scenes, std::string("rays_degenerate:kind=") + kind, kEveryLoop, false);
  }
  for (const char* kind :
       {"nan", "infinite", "minus_zero", "subnormal", "largest"}) {
    Add(scenes, std::string("rays_special:kind=") + kind, kEveryLoop, false);
  }
  Add(scenes, "rays_corpus", kEveryLoop, false);
}

void AddTimedRays(std::vector<RayProfileScene>& scenes, bool full) {
  const std::string reference = "rays_uniform:hit=50:bytes=24k:sets=";
  Add(scenes, reference + "fresh", kEveryLoop, full);
  const std::vector<Isa> some = {Isa::kScalar, Isa::kAvx2, Isa::kAvx512,
                                 Isa::kNeon, Isa::kSve2};
  const std::vector<std::string_view> way_out = {"moller_trumbore",
                                                 "moller_trumbore_early_out"};
  Add(scenes, reference + "fixed", kOneTriangle, false, way_out, some);
  // By the share of hits; in full, rays of which none or all hit are timed by
  // every method on fresh input (below).
  const std::vector<int> fresh =
      full ? std::vector{1, 10, 90} : std::vector{10, 90};
  const std::vector<int> fixed = full ? std::vector{0, 1, 10, 90, 100} : fresh;
  AddHits(scenes, fresh, "fresh", full, way_out, some);
  AddHits(scenes, fixed, "fixed", full, way_out, some);
  for (int n = 1; n <= 4096; n *= full ? 2 : 4) {
    Add(scenes, "rays_uniform:hit=50:n=" + std::to_string(n) + ":sets=fresh",
        kOneTriangle, false,
        {"moller_trumbore", "moller_trumbore_fma", "baldwin_weber",
         "baldwin_weber_fma"},
        some);
  }
  if (!full) return;
  for (const char* more : {"rays_uniform:hit=50:bytes=512k:sets=fresh",
                           "rays_uniform:hit=0:bytes=24k:sets=fresh",
                           "rays_uniform:hit=100:bytes=24k:sets=fresh"}) {
    Add(scenes, more, kEveryLoop, false);
  }
}

}  // namespace pitbench
