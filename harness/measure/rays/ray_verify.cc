#include "harness/measure/rays/ray_verify.h"

#include <array>
#include <optional>

#include "harness/measure/rays/ray_answers.h"
#include "harness/measure/rays/ray_scenes.h"
#include "harness/measure/verify_rounds.h"
#include "harness/scenes/generate.h"
#include "harness/scenes/rays/ray_scene.h"
#include "harness/scenes/spec.h"

namespace pitbench {
namespace {

// Adds to `answers` what a closed method has missed on a boundary. Where that
// is the nearest hit, a farther one is no right answer either.
template <class T>
void JudgeBoundary(const RayScene<T>& scene, const SceneTruth& truth,
                   RayOutput output, Answers<T>& answers) {
  for (std::size_t c = 0; c < scene.calls.size(); ++c) {
    const RayCall& call = scene.calls[c];
    const Bits& said = answers.bits[c];
    const Bits& boundary = truth.calls[c].boundary;
    if (output != RayOutput::kNearest) {
      ForEachAnswer(scene, call, boundary, [&](std::size_t i) {
        if (!BitAt(said, i)) answers.wrong.push_back({c, i, false});
      });
      continue;
    }
    const std::vector<std::size_t>& allowed = truth.nearest[c].allowed;
    if (allowed.empty() || !BitAt(boundary, allowed.front())) continue;
    if (!BitAt(said, allowed.front())) {
      answers.wrong.push_back({c, allowed.front(), false});
    }
  }
}

template <class T>
void VerifyOn(const RayScene<T>& scene,
              const std::vector<const RayKernel*>& kernels,
              Verification& so_far) {
  std::array<std::optional<SceneTruth>, 2> truths;  // two-sided, culled
  bool counted = false;
  for (const RayKernel* kernel : kernels) {
    if (kernel->loop != scene.loop) continue;
    std::optional<SceneTruth>& truth =
        truths.at(kernel->method.culls_backface ? 1 : 0);
    if (!truth) {
      truth = TimedTruth(
          [&] { return JudgeRays(scene, kernel->method.culls_backface); },
          so_far);
    }
    if (!counted) {
      counted = true;
      so_far.points += truth->interior + truth->exterior + truth->boundary +
                       truth->degenerate;
      so_far.boundary += truth->boundary;
    }
    Answers<T> answers = Ask(*kernel, scene, *truth);
    for (const RayCall& call : scene.calls) so_far.answers += call.n;
    if (kernel->method.boundary == Boundary::kClosed) {
      JudgeBoundary(scene, *truth, kernel->output, answers);
    }
    const bool none_before = so_far.wrong == 0;
    so_far.wrong += answers.wrong.size() + answers.stray_bits;
    if (!none_before || so_far.wrong == 0) continue;
    so_far.first_wrong = std::string(kernel->method.key) + " on " +
                         std::string(Name(kernel->isa)) + ", loop " +
                         std::string(Name(kernel->loop, kernel->output)) +
                         ", scene " + scene.name + ", ";
    so_far.first_wrong += answers.wrong.empty()
                              ? "sets a bit past the last answer"
                              : Describe(scene, answers.wrong.front());
  }
}

}  // namespace

std::vector<std::string> HardRayScenes() {
  std::vector<std::string> names;
  AddSwept(names, "rays_near_edge:ulps=", {0, 1, 2, 3, 5, 16, 256, 65536});
  AddSwept(names, "rays_near_vertex:ulps=", {0, 1, 2, 16, 4096});
  AddSwept(names, "rays_grazing:exponent=", {4, 12, 22, 30, 40});
  AddSwept(names, "rays_needle:aspect=", {2, 6, 12, 18, 26, 40});
  AddSwept(names, "rays_far_origin:exponent=", {4, 12, 20, 24, 40});
  AddSwept(names, "rays_offset:ratio=", {2, 8, 14, 21, 24, 40});
  AddKinds(names, "rays_degenerate:kind=",
           {"collinear", "doubled", "single", "zero_direction", "parallel"});
  AddKinds(names, "rays_special:kind=",
           {"nan", "infinite", "minus_zero", "subnormal", "largest"});
  AddSwept(names, "rays_icosphere:ulps=", {0, 1, 16});
  AddSwept(names, "rays_tiled_plane:ulps=", {0, 1, 16});
  names.emplace_back("rays_corpus");
  return names;
}

template <class T>
Verification VerifyRays(
    const std::vector<const RayKernel*>& kernels, std::size_t rays,
    std::uint64_t seed,
    const std::function<void(const Verification&)>& progress) {
  constexpr std::array kLoops = {RayLoop::kOneTriangleRays, RayLoop::kOneRay,
                                 RayLoop::kRayPairs};
  return VerifyInRounds(
      HardRayScenes(), kLoops, rays, seed, progress,
      [&](const std::string& name, RayLoop loop, SceneSize size,
          std::uint64_t round_seed, Verification& so_far) {
        if (IsRayMesh(name) && loop != RayLoop::kRayPairs) return;
        VerifyOn(MakeRayScene<T>(ParseScene(name), loop, size, round_seed),
                 kernels, so_far);
      });
}

template Verification VerifyRays<float>(
    const std::vector<const RayKernel*>&, std::size_t, std::uint64_t,
    const std::function<void(const Verification&)>&);
template Verification VerifyRays<double>(
    const std::vector<const RayKernel*>&, std::size_t, std::uint64_t,
    const std::function<void(const Verification&)>&);

}  // namespace pitbench
