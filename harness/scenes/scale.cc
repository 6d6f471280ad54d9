// A well-shaped scene of any size: a square of side 2^exponent at the origin.
//
// At the lower end the square is 16 of the smallest subnormals wide, at the
// upper end its far corner is half the largest finite number.
#include <cmath>
#include <limits>

#include "harness/scenes/families.h"

namespace pitbench {
namespace {

template <class T>
struct Scale {
  double side;

  // The product rounds where it is subnormal in double, and then once to T.
  // For f32 the product is exact.
  Point<T> Scaled(const Point<double>& p) const {
    return Rounded<T>(Point<double>{p.x * side, p.y * side});
  }
  Triangle<T> DrawTriangle(Random& random) const {
    const Triangle<double> t = WellShaped(random);
    return {Scaled(t.a), Scaled(t.b), Scaled(t.c)};
  }
  Point<T> DrawPoint(Random& random) const {
    return Scaled(InUnitSquare(random));
  }
  Point<T> PointFor(Random& random, const Triangle<T>&) const {
    return DrawPoint(random);
  }
  Triangle<T> TriangleFor(Random& random, const Point<T>&) const {
    return DrawTriangle(random);
  }
};

}  // namespace

template <class T>
Scene<T> ScaleScene(const SceneSpec& spec, Loop loop, SceneSize size,
                    std::uint64_t seed) {
  using Limits = std::numeric_limits<T>;
  // The smallest subnormal is 2^(min_exponent − digits).
  const auto exponent = static_cast<int>(
      spec.Number("exponent", Limits::min_exponent - Limits::digits + 4,
                  Limits::max_exponent - 1));
  return Assemble<T>(Scale<T>{std::ldexp(1.0, exponent)}, spec, loop, size,
                     seed);
}

template Scene<float> ScaleScene(const SceneSpec&, Loop, SceneSize,
                                 std::uint64_t);
template Scene<double> ScaleScene(const SceneSpec&, Loop, SceneSize,
                                  std::uint64_t);

}  // namespace pitbench
