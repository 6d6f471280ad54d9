#include "harness/measure/scene_details.h"

#include <cstdint>
#include <nlohmann/json.hpp>

#include "harness/measure/distance_estimate.h"
#include "harness/truth/weights.h"

namespace pitbench {

template <class T>
nlohmann::json InputOf(const Scene<T>& scene, const AnswerPlace& place,
                       bool said_inside) {
  const Call& call = scene.calls[place.call];
  const Triangle<T> t = scene.TriangleOf(call, place.answer);
  const Point<T> p = scene.PointOf(call, place.answer);
  return {{"a", Hex(t.a.x, t.a.y)},
          {"b", Hex(t.b.x, t.b.y)},
          {"c", Hex(t.c.x, t.c.y)},
          {"p", Hex(p.x, p.y)},
          {"said", said_inside ? "inside" : "outside"}};
}
template <class T>
double DistanceOf(const Scene<T>& scene, const AnswerPlace& place) {
  const Call& call = scene.calls[place.call];
  return BoundaryDistanceInUlps(scene.TriangleOf(call, place.answer),
                                scene.PointOf(call, place.answer));
}

template <class T>
double DistanceEstimateOf(const Scene<T>& scene, const AnswerPlace& place) {
  const Call& call = scene.calls[place.call];
  return DistanceEstimate(scene.TriangleOf(call, place.answer),
                          scene.PointOf(call, place.answer));
}

#define PITBENCH_INSTANTIATE(T)                                               \
  template nlohmann::json InputOf(const Scene<T>&, const AnswerPlace&, bool); \
  template double DistanceOf(const Scene<T>&, const AnswerPlace&);            \
  template double DistanceEstimateOf(const Scene<T>&, const AnswerPlace&)
PITBENCH_INSTANTIATE(float);
PITBENCH_INSTANTIATE(double);
PITBENCH_INSTANTIATE(std::int32_t);
PITBENCH_INSTANTIATE(std::int16_t);
PITBENCH_INSTANTIATE(std::uint8_t);
#undef PITBENCH_INSTANTIATE

}  // namespace pitbench
