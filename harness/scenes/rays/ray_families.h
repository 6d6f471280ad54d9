// The families of scenes of rays, and what they are drawn with. Reached through
// MakeRayScene (ray_scene.h).
#ifndef PITBENCH_HARNESS_SCENES_RAYS_RAY_FAMILIES_H_
#define PITBENCH_HARNESS_SCENES_RAYS_RAY_FAMILIES_H_

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "harness/scenes/families.h"
#include "harness/scenes/random.h"
#include "harness/scenes/rays/ray_scene.h"
#include "harness/scenes/special_numbers.h"
#include "harness/scenes/step.h"
#include "harness/truth/vector3.h"

namespace pitbench {

// rays_corpus and rays_uniform name their own size and do not use `size`.
template <class T>
RayScene<T> RaysUniformScene(const SceneSpec& spec, RayLoop loop,
                             SceneSize size, std::uint64_t seed);
template <class T>
RayScene<T> RaysNearEdgeScene(const SceneSpec& spec, RayLoop loop,
                              SceneSize size, std::uint64_t seed);
template <class T>
RayScene<T> RaysNearVertexScene(const SceneSpec& spec, RayLoop loop,
                                SceneSize size, std::uint64_t seed);
template <class T>
RayScene<T> RaysGrazingScene(const SceneSpec& spec, RayLoop loop,
                             SceneSize size, std::uint64_t seed);
template <class T>
RayScene<T> RaysNeedleScene(const SceneSpec& spec, RayLoop loop, SceneSize size,
                            std::uint64_t seed);
template <class T>
RayScene<T> RaysFarOriginScene(const SceneSpec& spec, RayLoop loop,
                               SceneSize size, std::uint64_t seed);
template <class T>
RayScene<T> RaysOffsetScene(const SceneSpec& spec, RayLoop loop, SceneSize size,
                            std::uint64_t seed);
template <class T>
RayScene<T> RaysDegenerateScene(const SceneSpec& spec, RayLoop loop,
                                SceneSize size, std::uint64_t seed);
template <class T>
RayScene<T> RaysSpecialScene(const SceneSpec& spec, RayLoop loop,
                             SceneSize size, std::uint64_t seed);
template <class T>
RayScene<T> RaysIcosphereScene(const SceneSpec& spec, RayLoop loop,
                               SceneSize size, std::uint64_t seed);
template <class T>
RayScene<T> RaysTiledPlaneScene(const SceneSpec& spec, RayLoop loop,
                                SceneSize size, std::uint64_t seed);
template <class T>
RayScene<T> RaysCorpusScene(const SceneSpec& spec, RayLoop loop, SceneSize size,
                            std::uint64_t seed);

#define PITBENCH_INSTANTIATE_RAYS(name)                                \
  template RayScene<float> name(const SceneSpec&, RayLoop, SceneSize,  \
                                std::uint64_t);                        \
  template RayScene<double> name(const SceneSpec&, RayLoop, SceneSize, \
                                 std::uint64_t)

template <class T>
Point3<T> Rounded(const Vector3& p) {
  return {static_cast<T>(p.x), static_cast<T>(p.y), static_cast<T>(p.z)};
}
template <class T>
Triangle3<double> Widened(const Triangle3<T>& t) {
  return {Widened(t.a), Widened(t.b), Widened(t.c)};
}
template <class T>
Triangle3<T> Rounded(const Triangle3<double>& t) {
  return {Rounded<T>(t.a), Rounded<T>(t.b), Rounded<T>(t.c)};
}

inline Vector3 InUnitCube(Random& random) {
  const double x = random.Unit();
  const double y = random.Unit();
  return {x, y, random.Unit()};
}
// A direction of length 1, all alike.
inline Vector3 AnyDirection(Random& random) {
  while (true) {
    const Vector3 p = 2 * InUnitCube(random) - Vector3{1, 1, 1};
    const double squared = Dot(p, p);
    if (squared > 0.01 && squared <= 1) return Unit(p);
  }
}

// Of a length from `least` to `most`. (A product of two draws would leave it to
// the compiler which comes first.)
inline Vector3 AnyWay(Random& random, double least, double most) {
  const double length = random.In(least, most);
  return length * AnyDirection(random);
}

inline Vector3 NormalOf(const Triangle3<double>& t) {
  return Cross(t.b - t.a, t.c - t.a);
}
// Random vertices in the unit cube, drawn until no altitude is smaller.
inline Triangle3<double> WellShaped3(Random& random) {
  while (true) {
    const Vector3 a = InUnitCube(random);
    const Vector3 b = InUnitCube(random);
    const Triangle3<double> t{a, b, InUnitCube(random)};
    const double longest =
        std::max({Length(t.b - t.a), Length(t.c - t.b), Length(t.a - t.c)});
    if (Length(NormalOf(t)) >= kWellShaped * longest) return t;
  }
}
inline Vector3 Mix(const Triangle3<double>& t, double u, double v) {
  return t.a + u * (t.b - t.a) + v * (t.c - t.a);
}

// Each coordinate rounded down to a multiple of 2^-bits.
inline Vector3 OnGrid(const Vector3& p, int bits) {
  return {OnGrid(p.x, bits), OnGrid(p.y, bits), OnGrid(p.z, bits)};
}
// A grid so fine that T has 8 bits left for a number below 1: for sixteenths of
// differences, and for sums up to 16. What is made of its points is exact in T,
// but no product of two is.
template <class T>
inline constexpr int kGridBits = std::numeric_limits<T>::digits - 8;

template <class T>
Ray<T> RayAlong(const Point3<T>& origin, const Point3<T>& direction) {
  return {origin, direction, 0, std::numeric_limits<T>::infinity()};
}
// From `from`, rounded, to `target`: t is 1 there, as the direction rounds.
template <class T>
Ray<T> RayTo(const Vector3& from, const Point3<T>& target) {
  const Point3<T> origin = Rounded<T>(from);
  return RayAlong(origin, Rounded<T>(Widened(target) - Widened(origin)));
}

// An origin 1 to 3 away from `target`, from which the triangle is not seen edge
// on: the ray makes 0.3 or more with its plane, as a sine. Any origin, where
// the triangle has lost its area to rounding.
inline Vector3 OriginBefore(Random& random, const Triangle3<double>& t,
                            const Vector3& target) {
  const Vector3 normal = NormalOf(t);
  const double length = Length(normal);
  while (true) {
    const Vector3 away = AnyDirection(random);
    if (std::abs(Dot(away, normal)) < 0.3 * length) continue;
    return target + random.In(1, 3) * away;
  }
}

// Vertices beginning with any of the three: the same side stays the front.
template <class T>
Triangle3<T> FromAnyVertex(Random& random, const Triangle3<T>& t) {
  const Point3<T> v[] = {t.a, t.b, t.c};
  const std::size_t first = random.Below(3);
  return {v[first], v[(first + 1) % 3], v[(first + 2) % 3]};
}

// The axis along which a step leads most across ab in the plane of the triangle
// abc, so that it does not only lead along the edge or out of the plane.
inline std::size_t AxisAcross(const Vector3& a, const Vector3& b,
                              const Vector3& c) {
  const Vector3 across = Cross(NormalOf({a, b, c}), b - a);
  const double x = std::abs(across.x);
  const double y = std::abs(across.y);
  const double z = std::abs(across.z);
  return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
}
template <class T>
T& Axis(Point3<T>& p, std::size_t axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

// The point at s of the way from v to w, rounded to T, and then moved by
// `steps` numbers across that edge of a triangle whose third vertex is `other`.
template <class T>
Point3<T> BesideEdge(const Vector3& v, const Vector3& w, const Vector3& other,
                     double s, std::int64_t steps) {
  Point3<T> p = Rounded<T>(v + s * (w - v));
  T& across = Axis(p, AxisAcross(v, w, other));
  across = Step(across, steps);
  return p;
}
// Moved by `ulps` numbers along one axis and by as many or fewer along the
// others.
template <class T>
Point3<T> BesideVertex(Random& random, Point3<T> p, std::int64_t ulps) {
  const std::size_t full = random.Below(3);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int64_t steps =
        axis == full ? EitherSign(random, ulps)
                     : static_cast<std::int64_t>(random.Below(
                           static_cast<std::uint64_t>(2 * ulps + 1))) -
                           ulps;
    T& coordinate = Axis(p, axis);
    coordinate = Step(coordinate, steps);
  }
  return p;
}

// Families draw a ray for a triangle, or a triangle for a ray:
//   Triangle3<T> DrawTriangle(Random&), Ray<T> DrawRay(Random&),
//   Ray<T> RayFor(Random&, const Triangle3<T>&),
//   Triangle3<T> TriangleFor(Random&, const Ray<T>&).
template <class Family>
struct RaysAsPoints : Family {
  auto DrawPoint(Random& random) { return this->DrawRay(random); }
  template <class TriangleType>
  auto PointFor(Random& random, const TriangleType& t) {
    return this->RayFor(random, t);
  }
};

template <class T, class Family>
RayScene<T> AssembleRays(const Family& family, const SceneSpec& spec,
                         RayLoop loop, SceneSize size, std::uint64_t seed) {
  RayScene<T> scene{.name = spec.name, .loop = loop};
  AddGroups(RaysAsPoints<Family>{family}, spec, size, seed, scene);
  return scene;
}

// A family of which a shape is drawn and a target on it or about it.
// Shape has
//   Triangle3<T> DrawTriangle(Random&),
//   Point3<T> Target(Random&, const Triangle3<T>&).
//
// Half of all rays begin on the grid, so that those to a target on it are
// exact.
template <class T, class Shape>
struct Aimed : Shape {
  Ray<T> RayFor(Random& random, const Triangle3<T>& t) {
    const Point3<T> target = this->Target(random, t);
    const Vector3 from = OriginBefore(random, Widened(t), Widened(target));
    return RayTo(Snapped(random, from), target);
  }
  Ray<T> DrawRay(Random& random) {
    const Vector3 from = 2 * InUnitCube(random) - Vector3{0.5, 0.5, 0.5};
    const Vector3 along = AnyWay(random, 1, 3);
    const bool snap = random.Below(2) == 0;
    const auto placed = [&](const Vector3& p) {
      return Rounded<T>(snap ? OnGrid(p, kGridBits<T>) : p);
    };
    return RayAlong(placed(from), placed(along));
  }
  // Moved so that its target is on the ray, at t from 0.5 to 1.5. Rounding the
  // vertices, up to 8 in magnitude, moves it a little again.
  Triangle3<T> TriangleFor(Random& random, const Ray<T>& ray) {
    const Triangle3<T> t = this->DrawTriangle(random);
    const Vector3 target = Widened(this->Target(random, t));
    const double at = 0.5 + static_cast<double>(random.Below(5)) / 4;
    const Vector3 move =
        Widened(ray.origin) + at * Widened(ray.direction) - target;
    return Rounded<T>(Triangle3<double>{
        Widened(t.a) + move, Widened(t.b) + move, Widened(t.c) + move});
  }

 private:
  static Vector3 Snapped(Random& random, const Vector3& p) {
    return random.Below(2) == 0 ? OnGrid(p, kGridBits<T>) : p;
  }
};

// A well-shaped triangle, on the grid or anywhere.
template <class T>
Triangle3<T> WellShapedOnGrid(Random& random, bool on_grid) {
  const Triangle3<double> t = WellShaped3(random);
  if (!on_grid) return Rounded<T>(t);
  constexpr int kBits = kGridBits<T>;
  return Rounded<T>(Triangle3<double>{OnGrid(t.a, kBits), OnGrid(t.b, kBits),
                                      OnGrid(t.c, kBits)});
}

// Half of the targets inside, about, and half around.
inline Vector3 InOrAround(Random& random, const Triangle3<double>& t) {
  const double u = random.In(-0.5, 1.5);
  return Mix(t, u, random.In(-0.5, 1.5 - std::max(u, 0.0)));
}

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_SCENES_RAYS_RAY_FAMILIES_H_
