// Far from the origin: a unit square whose corner is at (2^ratio, 2^ratio).
#include <cmath>

#include "harness/scenes/families.h"

namespace pitbench {
template <class T>
Scene<T> OffsetScene(const SceneSpec& spec, Loop loop, SceneSize size,
                     std::uint64_t seed) {
  const auto ratio = static_cast<int>(spec.Number("ratio", 0, 60));
  const double corner = std::ldexp(1.0, ratio);
  const auto moved = [corner](const Point<double>& p) {
    return Rounded<T>(Point<double>{p.x + corner, p.y + corner});
  };
  return Assemble<T>(Placed<T, decltype(moved)>{moved}, spec, loop, size, seed);
}

template Scene<float> OffsetScene(const SceneSpec&, Loop, SceneSize,
                                  std::uint64_t);
template Scene<double> OffsetScene(const SceneSpec&, Loop, SceneSize,
                                   std::uint64_t);

}  // namespace pitbench
