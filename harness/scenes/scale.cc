// A well-shaped scene of any size: a square of side 2^exponent at the origin.
//
// At the lower end the square is 16 of the smallest subnormals wide, at the
// upper end its far corner is half the largest finite number.
#include <cmath>
#include <limits>

#include "harness/scenes/families.h"

namespace pitbench {
template <class T>
Scene<T> ScaleScene(const SceneSpec& spec, Loop loop, SceneSize size,
                    std::uint64_t seed) {
  using Limits = std::numeric_limits<T>;
  // The smallest subnormal is 2^(min_exponent − digits).
  const auto exponent = static_cast<int>(
      spec.Number("exponent", Limits::min_exponent - Limits::digits + 4,
                  Limits::max_exponent - 1));
  const double side = std::ldexp(1.0, exponent);
  // The product rounds where it is subnormal in double, and then once to T.
  // For f32 the product is exact.
  const auto scaled = [side](const Point<double>& p) {
    return Rounded<T>(Point<double>{p.x * side, p.y * side});
  };
  return Assemble<T>(Placed<T, decltype(scaled)>{scaled}, spec, loop, size,
                     seed);
}

template Scene<float> ScaleScene(const SceneSpec&, Loop, SceneSize,
                                 std::uint64_t);
template Scene<double> ScaleScene(const SceneSpec&, Loop, SceneSize,
                                  std::uint64_t);

}  // namespace pitbench
