// The families of scenes, one file each, and what they are drawn with. Reached
// through MakeScene (generate.h).
#ifndef PITBENCH_HARNESS_SCENES_FAMILIES_H_
#define PITBENCH_HARNESS_SCENES_FAMILIES_H_

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "harness/scenes/generate.h"
#include "harness/scenes/random.h"

namespace pitbench {

// Scenes of float and double. A family that names its own size does not use
// `size`.
template <class T>
Scene<T> UniformScene(const SceneSpec& spec, Loop loop, SceneSize size,
                      std::uint64_t seed);
template <class T>
Scene<T> NearEdgeScene(const SceneSpec& spec, Loop loop, SceneSize size,
                       std::uint64_t seed);
template <class T>
Scene<T> NearVertexScene(const SceneSpec& spec, Loop loop, SceneSize size,
                         std::uint64_t seed);
template <class T>
Scene<T> OnEdgeScene(const SceneSpec& spec, Loop loop, SceneSize size,
                     std::uint64_t seed);
template <class T>
Scene<T> OnBoundaryScene(const SceneSpec& spec, Loop loop, SceneSize size,
                         std::uint64_t seed);
template <class T>
Scene<T> NeedleScene(const SceneSpec& spec, Loop loop, SceneSize size,
                     std::uint64_t seed);
template <class T>
Scene<T> OffsetScene(const SceneSpec& spec, Loop loop, SceneSize size,
                     std::uint64_t seed);
template <class T>
Scene<T> ScaleScene(const SceneSpec& spec, Loop loop, SceneSize size,
                    std::uint64_t seed);
template <class T>
Scene<T> ExponentSpreadScene(const SceneSpec& spec, Loop loop, SceneSize size,
                             std::uint64_t seed);
template <class T>
Scene<T> CancellationScene(const SceneSpec& spec, Loop loop, SceneSize size,
                           std::uint64_t seed);
template <class T>
Scene<T> WholeNumbersScene(const SceneSpec& spec, Loop loop, SceneSize size,
                           std::uint64_t seed);
template <class T>
Scene<T> DegenerateScene(const SceneSpec& spec, Loop loop, SceneSize size,
                         std::uint64_t seed);
template <class T>
Scene<T> SpecialScene(const SceneSpec& spec, Loop loop, SceneSize size,
                      std::uint64_t seed);
template <class T>
Scene<T> MeshPairScene(const SceneSpec& spec, Loop loop, SceneSize size,
                       std::uint64_t seed);
template <class T>
Scene<T> MeshFanScene(const SceneSpec& spec, Loop loop, SceneSize size,
                      std::uint64_t seed);
template <class T>
Scene<T> MeshTriangulationScene(const SceneSpec& spec, Loop loop,
                                SceneSize size, std::uint64_t seed);
template <class T>
Scene<T> CorpusScene(const SceneSpec& spec, Loop loop, SceneSize size,
                     std::uint64_t seed);

Scene<std::int32_t> GridScene(const SceneSpec& spec, std::uint64_t seed);

// The same triangles and the pixels as points, for std::int32_t, std::int16_t
// and std::uint8_t.
template <class T>
Scene<T> GridPointsScene(const SceneSpec& spec, std::uint64_t seed);

// Each coordinate rounded once to T.
template <class T>
Point<T> Rounded(const Point<double>& p) {
  return {static_cast<T>(p.x), static_cast<T>(p.y)};
}
template <class T>
Triangle<T> Rounded(const Triangle<double>& t) {
  return {Rounded<T>(t.a), Rounded<T>(t.b), Rounded<T>(t.c)};
}

inline Point<double> InUnitSquare(Random& random) {
  const double x = random.Unit();
  return {x, random.Unit()};
}

// Whether the smallest altitude is at least `least`.
inline bool HasAltitude(const Triangle<double>& t, double least) {
  const auto& [a, b, c] = t;
  const double double_area =
      std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
  const auto squared = [](const Point<double>& p, const Point<double>& q) {
    return (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y);
  };
  const double longest =
      std::sqrt(std::max({squared(a, b), squared(b, c), squared(c, a)}));
  return double_area >= least * longest;
}

// Random vertices in the unit square, drawn until no altitude is smaller, so
// that nothing about the shape is hard. Either winding.
inline constexpr double kWellShaped = 0.2;
inline Triangle<double> WellShaped(Random& random) {
  while (true) {
    const Point<double> a = InUnitSquare(random);
    const Point<double> b = InUnitSquare(random);
    const Point<double> c = InUnitSquare(random);
    if (HasAltitude({a, b, c}, kWellShaped)) return {a, b, c};
  }
}

// A random triangle that covers `share`, 0 to 1, of the unit square.
Triangle<double> Covering(Random& random, double share);

// x rounded down to a multiple of 2^-bits.
inline double OnGrid(double x, int bits) {
  return std::ldexp(std::floor(std::ldexp(x, bits)), -bits);
}

// A family of well-shaped triangles and points in the unit square, of which
// `place`, a function from Point<double> to Point<T>, makes the scene's.
template <class T, class Place>
struct Placed {
  Place place;

  Triangle<T> DrawTriangle(Random& random) const {
    const Triangle<double> t = WellShaped(random);
    return {place(t.a), place(t.b), place(t.c)};
  }
  Point<T> DrawPoint(Random& random) const {
    return place(InUnitSquare(random));
  }
  Point<T> PointFor(Random& random, const Triangle<T>&) const {
    return DrawPoint(random);
  }
  Triangle<T> TriangleFor(Random& random, const Point<T>&) const {
    return DrawTriangle(random);
  }
};

// Adds groups of a family that draws a point for a triangle and a triangle for
// a point. Family has
//   Triangle<T> DrawTriangle(Random&), Point<T> DrawPoint(Random&),
//   Point<T> PointFor(Random&, const Triangle<T>&),
//   Triangle<T> TriangleFor(Random&, const Point<T>&)
// or the same of a scene of rays, with a ray for the point.
template <class SceneType, class Family>
void AddGroups(Family family, const SceneSpec& spec, SceneSize size,
               std::uint64_t seed, SceneType& scene) {
  const Loop shape = ShapeOf(scene.loop);
  Random random(
      SeedFor(std::string(Name(shape)).append("/").append(spec.Drawn()), seed));
  const std::size_t groups = spec.Fresh() ? size.groups : 1;
  for (std::size_t group = 0; group < groups; ++group) {
    scene.calls.push_back({scene.Triangles(), scene.Probes(), size.size});
    if (shape == Loop::kOneTriangle) {
      const auto triangle = family.DrawTriangle(random);
      scene.Add(triangle);
      for (std::size_t i = 0; i < size.size; ++i) {
        scene.Add(family.PointFor(random, triangle));
      }
    } else if (shape == Loop::kOnePoint) {
      const auto point = family.DrawPoint(random);
      scene.Add(point);
      for (std::size_t i = 0; i < size.size; ++i) {
        scene.Add(family.TriangleFor(random, point));
      }
    } else {
      for (std::size_t i = 0; i < size.size; ++i) {
        const auto triangle = family.DrawTriangle(random);
        scene.Add(triangle);
        scene.Add(family.PointFor(random, triangle));
      }
    }
  }
}

template <class T, class Family>
Scene<T> Assemble(const Family& family, const SceneSpec& spec, Loop loop,
                  SceneSize size, std::uint64_t seed) {
  Scene<T> scene{.name = spec.name, .loop = loop};
  AddGroups(family, spec, size, seed, scene);
  return scene;
}

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_SCENES_FAMILIES_H_
