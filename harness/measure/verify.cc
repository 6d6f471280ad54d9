#include "harness/measure/verify.h"

#include <array>
#include <cstdio>
#include <map>

#include "harness/measure/answers.h"
#include "harness/measure/verify_rounds.h"
#include "harness/scenes/generate.h"
#include "harness/truth/expected.h"

namespace pitbench {
namespace {

// The bits that a kernel with that boundary rule should write for a call.
template <class T>
Bits ExpectedBits(const Scene<T>& scene, const Call& call,
                  const CallTruth& truth, Boundary rule) {
  Bits bits = truth.inside;
  for (std::size_t i = 0; i < scene.Answers(call); ++i) {
    if (BitAt(truth.boundary, i) &&
        BoundaryCounts(rule, scene.TriangleOf(call, i),
                       scene.PointOf(call, i))) {
      bits[i / 8] = static_cast<std::uint8_t>(bits[i / 8] | 1u << (i % 8));
    }
  }
  return bits;
}

template <class T>
std::string Describe(const Kernel& kernel, const Scene<T>& scene,
                     const Call& call, std::size_t answer, bool said) {
  const Triangle<T> t = scene.TriangleOf(call, answer);
  const Point<T> p = scene.PointOf(call, answer);
  char text[400];
  std::snprintf(text, sizeof(text),
                "%s on %s, scene %s, says %s of\n%a,%a,%a,%a,%a,%a,%a,%a\n"
                "which is %s under the rule %s",
                std::string(kernel.method.key).c_str(),
                std::string(Name(kernel.isa)).c_str(), scene.name.c_str(),
                said ? "inside" : "outside", static_cast<double>(t.a.x),
                static_cast<double>(t.a.y), static_cast<double>(t.b.x),
                static_cast<double>(t.b.y), static_cast<double>(t.c.x),
                static_cast<double>(t.c.y), static_cast<double>(p.x),
                static_cast<double>(p.y),
                std::string(Name(Classify(t, p))).c_str(),
                std::string(Name(kernel.method.boundary)).c_str());
  return text;
}

template <class T>
void VerifyOn(const Scene<T>& scene, const std::vector<const Kernel*>& kernels,
              Verification& so_far) {
  const SceneTruth truth =
      TimedTruth([&] { return JudgeScene(scene); }, so_far);
  so_far.points +=
      truth.interior + truth.exterior + truth.boundary + truth.degenerate;
  so_far.boundary += truth.boundary;
  std::map<Boundary, std::vector<Bits>> expected;
  Bits said;
  for (const Kernel* kernel : kernels) {
    if (LoopOfScenes(kernel->loop) != scene.loop) continue;
    const Array<T> xy = PointsFor(*kernel, scene);
    std::vector<Bits>& right = expected[kernel->method.boundary];
    for (std::size_t c = 0; c < scene.calls.size(); ++c) {
      const Call& call = scene.calls[c];
      if (right.size() == c) {
        right.push_back(
            ExpectedBits(scene, call, truth.calls[c], kernel->method.boundary));
      }
      said.assign(right[c].size(), 0xff);
      FunctionOf<T> (*kernel)(scene.BatchOf(call, xy.data()),
                              Result<T>{.bits = said.data()});
      so_far.answers += call.n;
      if (said == right[c]) continue;
      for (std::size_t i = 0; i < 8 * said.size(); ++i) {
        if (BitAt(said, i) == BitAt(right[c], i)) continue;
        if (so_far.wrong++ != 0) continue;
        so_far.first_wrong =
            i < call.n ? Describe(*kernel, scene, call, i, BitAt(said, i))
                       : "a bit past the last answer is set";
      }
    }
  }
}

}  // namespace

std::vector<std::string> HardScenes(Scalar scalar) {
  std::vector<std::string> names;
  AddSwept(names, "near_edge:ulps=", {0, 1, 2, 3, 5, 16, 256, 65536});
  AddSwept(names, "near_vertex:ulps=", {0, 1, 2, 16, 4096});
  AddSwept(names, "on_edge:percent=", {50});
  if (scalar == Scalar::kF32) {
    AddSwept(names, "needle:aspect=", {2, 6, 12, 18, 22, 26, 36});
    AddSwept(names, "offset:ratio=", {2, 8, 14, 18, 21, 23, 24});
    AddSwept(names,
             "scale:exponent=", {-145, -126, -76, -63, -38, 38, 64, 126});
    AddSwept(names, "exponent_spread:binades=", {4, 16, 28, 29, 40, 60});
    AddSwept(names, "cancellation:binades=", {0, 20, 28, 29, 60});
    AddSwept(names, "whole_numbers:bits=", {5, 12, 22, 24});
    for (const char* at : {"edge", "vertex"}) {
      AddSwept(names, std::string("on_boundary:at=") + at + ":binades=", {240});
    }
  } else {
    AddSwept(names, "needle:aspect=", {2, 10, 25, 40, 48, 54, 60});
    AddSwept(names, "offset:ratio=", {2, 16, 30, 44, 49, 51, 52});
    AddSwept(names, "scale:exponent=",
             {-1070, -1022, -538, -270, 256, 511, 512, 1022});
    AddSwept(names, "exponent_spread:binades=", {4, 28, 53, 60, 90, 120});
    AddSwept(names, "cancellation:binades=", {0, 2, 20, 53, 120});
    AddSwept(names, "whole_numbers:bits=", {5, 26, 51, 53});
    for (const char* at : {"edge", "vertex"}) {
      AddSwept(names,
               std::string("on_boundary:at=") + at + ":binades=", {2000});
    }
  }
  AddKinds(names, "degenerate:kind=", {"collinear", "doubled", "single"});
  AddKinds(names, "special:kind=",
           {"nan", "infinite", "minus_zero", "subnormal", "largest"});
  for (const char* mesh : {"pair", "fan", "triangulation"}) {
    AddSwept(names, "mesh_" + std::string(mesh) + ":ulps=", {0, 1, 16});
  }
  names.emplace_back("corpus");
  return names;
}

template <class T>
Verification Verify(const std::vector<const Kernel*>& kernels,
                    std::size_t points, std::uint64_t seed,
                    const std::function<void(const Verification&)>& progress) {
  constexpr std::array kLoops = {Loop::kOneTriangle, Loop::kOnePoint,
                                 Loop::kPairs};
  return VerifyInRounds(
      HardScenes(ScalarOf<T>()), kLoops, points, seed, progress,
      [&](const std::string& name, Loop loop, SceneSize size,
          std::uint64_t round_seed, Verification& so_far) {
        VerifyOn(MakeScene<T>(ParseScene(name), loop, size, round_seed),
                 kernels, so_far);
      });
}

template Verification Verify<float>(
    const std::vector<const Kernel*>&, std::size_t, std::uint64_t,
    const std::function<void(const Verification&)>&);
template Verification Verify<double>(
    const std::vector<const Kernel*>&, std::size_t, std::uint64_t,
    const std::function<void(const Verification&)>&);

}  // namespace pitbench
