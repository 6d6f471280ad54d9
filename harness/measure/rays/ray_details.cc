#include "harness/measure/rays/ray_details.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "harness/measure/error_size.h"
#include "harness/truth/vector3.h"
#include "harness/truth/weights.h"

namespace pitbench {
namespace {

using nlohmann::json;

constexpr std::size_t kWeighed = 512;

bool HasTuv(RayPosition position) {
  return position == RayPosition::kHit || position == RayPosition::kBoundary ||
         position == RayPosition::kMiss;
}

}  // namespace

template <class T>
json InputOf(const RayScene<T>& scene, const AnswerPlace& place,
             bool said_inside) {
  const RayCall& call = scene.calls[place.call];
  const Triangle3<T> t = scene.TriangleOf(call, place.answer);
  const Ray<T> ray = scene.RayOf(call, place.answer);
  const auto hex = [](const Point3<T>& p) { return Hex(p.x, p.y, p.z); };
  return {{"a", hex(t.a)},
          {"b", hex(t.b)},
          {"c", hex(t.c)},
          {"origin", hex(ray.origin)},
          {"direction", hex(ray.direction)},
          {"range", Hex(ray.t_min, ray.t_max)},
          {"said", said_inside ? "inside" : "outside"}};
}

template <class T>
double DistanceOf(const RayScene<T>& scene, const AnswerPlace& place) {
  const RayCall& call = scene.calls[place.call];
  const Triangle3<T> t = scene.TriangleOf(call, place.answer);
  const Ray<T> ray = scene.RayOf(call, place.answer);
  if (!IsFinite(t, ray) || !HasTuv(Classify(t, ray))) return 0;
  return EdgeDistanceInUlps(t, ray);
}

template <class T>
double DistanceEstimateOf(const RayScene<T>& scene, const AnswerPlace& place) {
  const RayCall& call = scene.calls[place.call];
  const Triangle3<T> t = scene.TriangleOf(call, place.answer);
  const Ray<T> ray = scene.RayOf(call, place.answer);
  const Vector3 a = Widened(t.a);
  const Vector3 e1 = Widened(t.b) - a;
  const Vector3 e2 = Widened(t.c) - a;
  const Vector3 d = Widened(ray.direction);
  const Vector3 s = Widened(ray.origin) - a;
  const Vector3 p = Cross(d, e2);
  const double determinant = Dot(e1, p);
  const double u = Dot(s, p) / determinant;
  const double v = Dot(d, Cross(s, e1)) / determinant;
  const double least =
      std::min({std::abs(u), std::abs(v), std::abs(1 - u - v)});
  const double ulps =
      least / static_cast<double>(std::numeric_limits<T>::epsilon());
  return std::isfinite(ulps) ? ulps : 0;
}

template <class T>
std::vector<ExactHit> WeighAnswers(const RayScene<T>& scene) {
  std::vector<ExactHit> hits;
  if (scene.calls.empty()) return hits;
  const std::size_t some = kWeighed / scene.calls.size() + 1;
  for (std::size_t c = 0; c < scene.calls.size(); ++c) {
    const RayCall& call = scene.calls[c];
    std::size_t here = 0;
    for (std::size_t i = 0; i < call.n && here < some; ++i) {
      if (hits.size() == kWeighed) return hits;
      const Triangle3<T> t = scene.TriangleOf(call, i);
      const Ray<T> ray = scene.RayOf(call, i);
      if (Classify(t, ray) != RayPosition::kHit) continue;
      hits.push_back({c, i, ExactTuv(t, ray)});
      ++here;
    }
  }
  return hits;
}

template <class T>
json TuvErrors(const Answers<T>& answers, const std::vector<ExactHit>& hits) {
  std::array<ErrorSize, 3> sizes;
  std::size_t missing = 0;
  for (const ExactHit& hit : hits) {
    for (std::size_t k = 0; k < 3; ++k) {
      const T computed = answers.weights[k][hit.call][hit.answer];
      if (!std::isfinite(computed)) {  // missed, so that there is none
        if (k == 0) ++missing;
        continue;
      }
      if (k == 0) {
        sizes[k].Add(UlpError(computed, hit.tuv[k]));
        continue;
      }
      // In ulps of 1, as weights have it.
      mpq_class off(static_cast<double>(computed));
      off -= hit.tuv[k];
      sizes[k].Add(std::abs(off.get_d()) /
                   static_cast<double>(std::numeric_limits<T>::epsilon()));
    }
  }
  json errors = {{"rays", hits.size()}, {"missed", missing}};
  constexpr const char* kNames[] = {"t", "u", "v"};
  for (std::size_t k = 0; k < 3; ++k) {
    errors[kNames[k]] = {{"largest_ulps", sizes[k].largest()},
                         {"mean_ulps", sizes[k].mean()}};
  }
  return errors;
}

#define PITBENCH_INSTANTIATE(T)                                               \
  template json InputOf(const RayScene<T>&, const AnswerPlace&, bool);        \
  template double DistanceOf(const RayScene<T>&, const AnswerPlace&);         \
  template double DistanceEstimateOf(const RayScene<T>&, const AnswerPlace&); \
  template std::vector<ExactHit> WeighAnswers(const RayScene<T>&);            \
  template json TuvErrors(const Answers<T>&, const std::vector<ExactHit>&)
PITBENCH_INSTANTIATE(float);
PITBENCH_INSTANTIATE(double);
#undef PITBENCH_INSTANTIATE

}  // namespace pitbench
