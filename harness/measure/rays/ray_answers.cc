#include "harness/measure/rays/ray_answers.h"

#include <algorithm>
#include <cstdio>

namespace pitbench {
namespace {

template <class T>
NearestTruth NearestOf(const RayScene<T>& scene, const RayCall& call,
                       const CallTruth& truth) {
  struct Hit {
    std::size_t triangle;
    bool boundary;
    mpq_class t;
  };
  std::vector<Hit> hits;
  for (std::size_t i = 0; i < call.n; ++i) {
    const bool boundary = BitAt(truth.boundary, i);
    if (!boundary && !BitAt(truth.inside, i)) continue;
    hits.push_back(
        {i, boundary,
         ExactTuv(scene.TriangleOf(call, i), scene.RayOf(call, i))[0]});
  }
  std::stable_sort(hits.begin(), hits.end(),
                   [](const Hit& a, const Hit& b) { return a.t < b.t; });
  NearestTruth nearest;
  for (const Hit& hit : hits) {
    nearest.allowed.push_back(hit.triangle);
    if (hit.boundary) continue;
    nearest.expected = hit.triangle;
    return nearest;
  }
  nearest.none_allowed = true;
  return nearest;
}

template <class T>
void JudgeNearest(const RayScene<T>& scene, const SceneTruth& truth,
                  Answers<T>& answers) {
  for (std::size_t c = 0; c < scene.calls.size(); ++c) {
    const CallTruth& judged = truth.calls[c];
    const NearestTruth& nearest = truth.nearest[c];
    std::size_t said = kNoTriangle;
    for (std::size_t i = 0; i < scene.calls[c].n; ++i) {
      if (BitAt(answers.bits[c], i)) said = i;
    }
    if (said == kNoTriangle) {
      if (!nearest.none_allowed) {
        answers.wrong.push_back({c, nearest.expected, false});
      }
      continue;
    }
    if (BitAt(judged.boundary, said)) ++answers.boundary_accepted;
    if (std::find(nearest.allowed.begin(), nearest.allowed.end(), said) !=
        nearest.allowed.end()) {
      continue;
    }
    if (BitAt(judged.inside, said) || BitAt(judged.boundary, said)) {
      answers.wrong.push_back({c, nearest.expected, false});
    } else {
      answers.wrong.push_back({c, said, true});
    }
  }
}

}  // namespace

template <class T>
std::string Describe(const RayScene<T>& scene, const Wrong& wrong) {
  const RayCall& call = scene.calls[wrong.call];
  const Triangle3<T> t = scene.TriangleOf(call, wrong.answer);
  const Ray<T> ray = scene.RayOf(call, wrong.answer);
  std::string text = wrong.said_inside ? "says hit of" : "says miss of";
  const auto add = [&text](const char* before, const Point3<T>& p) {
    char buffer[160];
    std::snprintf(buffer, sizeof(buffer), "%s(%a, %a, %a)", before,
                  static_cast<double>(p.x), static_cast<double>(p.y),
                  static_cast<double>(p.z));
    text += buffer;
  };
  add(" a ray from ", ray.origin);
  add(" along ", ray.direction);
  add(" and the triangle ", t.a);
  add(" ", t.b);
  add(" ", t.c);
  return text + ", which is " + std::string(Name(Classify(t, ray)));
}

template <class T>
SceneTruth JudgeRays(const RayScene<T>& scene, bool culls_backface) {
  SceneTruth truth =
      JudgeAnswers(scene, [&](const RayCall& call, std::size_t i) -> Verdict {
        const Triangle3<T> t = scene.TriangleOf(call, i);
        const Ray<T> ray = scene.RayOf(call, i);
        const bool either_side = !culls_backface;
        switch (Classify(t, ray)) {
          case RayPosition::kHit:
            return {either_side || IsFrontFacing(t, ray) ? Position::kInside
                                                         : Position::kOutside,
                    true, true};
          case RayPosition::kBoundary:
            if (either_side || IsFrontFacing(t, ray)) {
              return {Position::kBoundary, true, false};
            }
            return {Position::kOutside, true, true};
          case RayPosition::kMiss: {
            const bool finite = IsFinite(t, ray);
            return {Position::kOutside, finite, finite};
          }
          case RayPosition::kCoplanar:
            return {Position::kOutside, true, false};
          case RayPosition::kDegenerate:
            break;
        }
        return {Position::kDegenerate, true, false};
      });
  if (scene.loop == RayLoop::kOneRay) {
    for (std::size_t c = 0; c < scene.calls.size(); ++c) {
      truth.nearest.push_back(NearestOf(scene, scene.calls[c], truth.calls[c]));
    }
  }
  return truth;
}

template <class T>
void Run(const RayKernel& kernel, const RayScene<T>& scene,
         Answers<T>& answers) {
  const std::size_t calls = scene.calls.size();
  const bool tuv = kernel.output == RayOutput::kTuv;
  const bool nearest = kernel.output == RayOutput::kNearest;
  answers.bits.resize(calls);
  for (auto& w : answers.weights) w.resize(tuv ? calls : 0);
  if (nearest) answers.weights[0].resize(calls);
  for (std::size_t c = 0; c < calls; ++c) {
    const RayCall& call = scene.calls[c];
    Bits& bits = answers.bits[c];
    bits.resize(BitBytes(call.n));
    RayResult<T> result;
    std::size_t index = kNoTriangle;
    if (nearest) {
      answers.weights[0][c].resize(1);
      result.t = answers.weights[0][c].data();
      result.nearest = &index;
    } else {
      result.bits = bits.data();
    }
    if (tuv) {
      T** const to[] = {&result.t, &result.u, &result.v};
      for (std::size_t k = 0; k < 3; ++k) {
        answers.weights[k][c].resize(call.n);
        *to[k] = answers.weights[k][c].data();
      }
    }
    FunctionOf<T>(kernel)(scene.BatchOf(call), result);
    if (nearest) {
      std::fill(bits.begin(), bits.end(), std::uint8_t{0});
      if (index < call.n) SetBit(bits, index);
    }
  }
}

template <class T>
Answers<T> Ask(const RayKernel& kernel, const RayScene<T>& scene,
               const SceneTruth& truth) {
  Answers<T> answers;
  Run(kernel, scene, answers);
  if (kernel.output == RayOutput::kNearest) {
    JudgeNearest(scene, truth, answers);
  } else {
    JudgeBits(scene, truth, answers);
  }
  return answers;
}

template <class T>
std::optional<std::string> Refusal(const RayKernel& kernel,
                                   const RayScene<T>& scene,
                                   const SceneTruth& truth) {
  const Answers<T> answers = Ask(kernel, scene, truth);
  if (answers.stray_bits != 0) return "sets bits past the last answer";
  for (const Wrong& wrong : answers.wrong) {
    const RayCall& call = scene.calls[wrong.call];
    const Triangle3<T> t = scene.TriangleOf(call, wrong.answer);
    const Ray<T> ray = scene.RayOf(call, wrong.answer);
    if (!IsFinite(t, ray) || !RoundingMayDecide(t, ray, kSlack)) {
      return Describe(scene, wrong) + ", and rounding cannot be why";
    }
  }
  return std::nullopt;
}

#define PITBENCH_INSTANTIATE(T)                                         \
  template SceneTruth JudgeRays(const RayScene<T>&, bool);              \
  template void Run(const RayKernel&, const RayScene<T>&, Answers<T>&); \
  template Answers<T> Ask(const RayKernel&, const RayScene<T>&,         \
                          const SceneTruth&);                           \
  template std::string Describe(const RayScene<T>&, const Wrong&);      \
  template std::optional<std::string> Refusal(                          \
      const RayKernel&, const RayScene<T>&, const SceneTruth&)
PITBENCH_INSTANTIATE(float);
PITBENCH_INSTANTIATE(double);
#undef PITBENCH_INSTANTIATE

}  // namespace pitbench
