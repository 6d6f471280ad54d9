// What has no answer but a miss, exactly: triangles without area, rays without
// direction, rays parallel to the triangle's plane.
//
// The vertices of a triangle without area are small multiples of one vector on
// the grid, added to one point of it, so they are exact in T and their products
// round: where one of two products is rounded and the other is not, as by a
// contracted multiply-add, such a triangle seems to have an area. Half of the
// collinear ones are multiples ±2^-k of one vector instead, of as many bits as
// T has, so their differences round as well.
#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <utility>

#include "harness/scenes/rays/ray_families.h"

namespace pitbench {
namespace {

// Of size 0.5 or more in one component at least.
Vector3 AnyVector(Random& random) {
  while (true) {
    const Vector3 v = 2 * InUnitCube(random) - Vector3{1, 1, 1};
    if (Dot(v, v) >= 0.75) return v;
  }
}

template <class T>
struct Degenerate {
  std::string_view kind;

  static Triangle3<T> Collinear(Random& random, const std::array<int, 3>& k) {
    const Vector3 base = OnGrid(InUnitCube(random), kGridBits<T>);
    const Vector3 along = OnGrid(AnyVector(random), kGridBits<T>);
    return Rounded<T>(Triangle3<double>{
        base + k[0] * along, base + k[1] * along, base + k[2] * along});
  }
  static Triangle3<T> Multiples(Random& random) {
    const Vector3 v = Widened(Rounded<T>(InUnitCube(random)));
    const auto multiple = [&](int power) {
      const double s = std::ldexp(1.0, -power);
      return Rounded<T>((random.Below(2) == 0 ? s : -s) * v);
    };
    const auto first = static_cast<int>(random.Below(4));
    const auto second = first + 1 + static_cast<int>(random.Below(4));
    const Point3<T> a = multiple(first);
    const Point3<T> b = multiple(second);
    return FromAnyVertex<T>(random, {a, b, multiple(second + 1)});
  }

  Triangle3<T> DrawTriangle(Random& random) const {
    if (kind == "zero_direction" || kind == "parallel") {
      return WellShapedOnGrid<T>(random, true);
    }
    if (kind == "single") return Collinear(random, {1, 1, 1});
    if (kind == "doubled") {
      return FromAnyVertex(random, Collinear(random, {-1, -1, 2}));
    }
    if (random.Below(2) == 0) return Multiples(random);
    std::array<int, 5> steps = {-2, -1, 0, 1, 2};
    for (std::size_t i = 0; i < 3; ++i) {
      std::swap(steps[i], steps[i + random.Below(5 - i)]);
    }
    return Collinear(random, {steps[0], steps[1], steps[2]});
  }

  Ray<T> DrawRay(Random& random) const {
    const Vector3 from = OnGrid(InUnitCube(random), kGridBits<T>);
    const Vector3 along = OnGrid(AnyVector(random), kGridBits<T>);
    return RayAlong(Rounded<T>(from),
                    Rounded<T>(kind == "zero_direction" ? 0 * along : along));
  }

  // Parallel: the direction is a sum of quarters of the edges; half of the rays
  // lie in the plane. Else half go to a point of the line through the vertices
  // (a point of the triangle, where it has an area).
  Ray<T> RayFor(Random& random, const Triangle3<T>& rounded) const {
    const Triangle3<double> t = Widened(rounded);
    const auto quarters = [&random] {
      return (static_cast<double>(random.Below(9)) - 4) / 4;
    };
    const double u = quarters();
    const double v = quarters();
    const Vector3 target = Mix(t, u, v);
    if (kind == "parallel") {
      const Vector3 from = random.Below(2) == 0
                               ? target
                               : OnGrid(InUnitCube(random), kGridBits<T>);
      double along = 0;
      while (along == 0) along = quarters();
      const Vector3 direction = along * (t.b - t.a) + quarters() * (t.c - t.a);
      return RayAlong(Rounded<T>(from), Rounded<T>(direction));
    }
    const Vector3 from = target + AnyWay(random, 1, 3);
    if (kind == "zero_direction") {
      const Vector3 origin = random.Below(2) == 0 ? target : from;
      const T zero = random.Below(2) == 0 ? T{0} : -T{0};
      return RayAlong(Rounded<T>(origin), {T{0}, zero, -zero});
    }
    const Vector3 off =
        random.Below(2) == 0 ? Vector3{0, 0, 0} : 0.5 * AnyVector(random);
    return RayTo(from, Rounded<T>(target + off));
  }

  // Parallel: a triangle with a multiple of the direction for an edge, or with
  // two such edges' sum. The ray begins in the plane of half of them.
  Triangle3<T> TriangleFor(Random& random, const Ray<T>& ray) const {
    if (kind != "parallel") return DrawTriangle(random);
    const Vector3 along = Widened(ray.direction);
    Vector3 side = OnGrid(AnyVector(random), kGridBits<T>);
    while (Length(Cross(side, along)) < 0.1) {
      side = OnGrid(AnyVector(random), kGridBits<T>);
    }
    const Vector3 a = random.Below(2) == 0
                          ? Widened(ray.origin) + along - 0.25 * side
                          : OnGrid(InUnitCube(random), kGridBits<T>);
    const double s = static_cast<double>(random.Below(5)) / 4;
    return FromAnyVertex(random,
                         Rounded<T>(Triangle3<double>{a, a + 0.5 * along,
                                                      a + side + s * along}));
  }
};

}  // namespace

template <class T>
RayScene<T> RaysDegenerateScene(const SceneSpec& spec, RayLoop loop,
                                SceneSize size, std::uint64_t seed) {
  const Degenerate<T> family{spec.Word(
      "kind",
      {"collinear", "doubled", "single", "zero_direction", "parallel"})};
  return AssembleRays<T>(family, spec, loop, size, seed);
}

PITBENCH_INSTANTIATE_RAYS(RaysDegenerateScene);

}  // namespace pitbench
