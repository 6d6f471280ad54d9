// Two triangles with a shared edge, and a fan of eight around a vertex. Every
// triangle of such a mesh is asked about every point.
//
// Half of the meshes are exact (exact_edge.h): before they are moved, their
// points are on the edge exactly; those of other meshes only as far as they
// round.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "harness/scenes/exact_edge.h"
#include "harness/scenes/families.h"
#include "harness/scenes/mesh.h"
#include "harness/scenes/step.h"

namespace pitbench {
namespace {

std::int64_t EitherSign(Random& random, std::int64_t ulps) {
  return random.Below(2) == 0 ? ulps : -ulps;
}

template <class T>
Point<T> VertexAt(bool exact, const Point<double>& p) {
  return Rounded<T>(exact ? OnGrid(p, kVertexBits) : p);
}
double ShareOf(bool exact, Random& random, double low, double high) {
  return exact ? ExactShare(random, low, high) : random.In(low, high);
}

// Which side of ab the point c is on, as far as double tells.
double Side(const Point<double>& a, const Point<double>& b,
            const Point<double>& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Points on the shared edge, and `ulps` numbers off it. They are a sixteenth of
// an altitude, 0.012, or more from the other edges, and 2^16 numbers of f32
// below 1 are 0.004 at most.
template <class T>
struct Pair {
  static constexpr std::size_t kTriangles = 2;
  std::int64_t ulps;
  bool exact;
  Point<T> from;
  Point<T> to;

  std::vector<Triangle<T>> Draw(Random& random) {
    while (true) {
      const Point<double> a = InUnitSquare(random);
      const Point<double> b = InUnitSquare(random);
      const Point<double> c = InUnitSquare(random);
      const Point<double> d = InUnitSquare(random);
      if (Side(a, b, c) * Side(a, b, d) >= 0) continue;
      if (!HasAltitude({a, b, c}, kWellShaped)) continue;
      if (!HasAltitude({a, b, d}, kWellShaped)) continue;
      from = VertexAt<T>(exact, a);
      to = VertexAt<T>(exact, b);
      return {{from, to, VertexAt<T>(exact, c)},
              {to, from, VertexAt<T>(exact, d)}};
    }
  }
  Point<T> DrawPoint(Random& random) const {
    const double s = ShareOf(exact, random, 0.1, 0.9);
    return BesideEdge(from, to, s, EitherSign(random, ulps));
  }
};

// A quarter of the points are `ulps` numbers from the vertex in the middle,
// the others as many beside the edges that meet there.
template <class T>
struct Fan {
  static constexpr std::size_t kTriangles = 8;
  std::int64_t ulps;
  bool exact;
  Point<T> middle;
  std::array<Point<T>, kTriangles> rim;

  std::vector<Triangle<T>> Draw(Random& random) {
    // Eight directions 45° apart, turned by up to 45°: by (c, s) with s/c from
    // 0 to 1. A vertex of the rim is 0.25 to 0.45 from the middle, and then
    // moved by up to 0.05 in either coordinate, which turns it by 17° at most.
    constexpr int kX[] = {1, 1, 0, -1, -1, -1, 0, 1};
    constexpr int kY[] = {0, 1, 1, 1, 0, -1, -1, -1};
    const double slope = random.Unit();
    const double c = 1 / std::sqrt(1 + slope * slope);
    const double s = slope * c;
    const double x = random.In(0.4, 0.6);
    const double y = random.In(0.4, 0.6);
    middle = VertexAt<T>(exact, {x, y});
    for (std::size_t k = 0; k < kTriangles; ++k) {
      const double unit = k % 2 == 0 ? 1 : std::sqrt(0.5);
      const double radius = random.In(0.25, 0.45) * unit;
      const double off_x = random.In(-0.05, 0.05);
      const double off_y = random.In(-0.05, 0.05);
      rim[k] =
          VertexAt<T>(exact, {x + radius * (c * kX[k] - s * kY[k]) + off_x,
                              y + radius * (s * kX[k] + c * kY[k]) + off_y});
    }
    std::vector<Triangle<T>> triangles;
    for (std::size_t k = 0; k < kTriangles; ++k) {
      triangles.push_back({middle, rim[k], rim[(k + 1) % kTriangles]});
    }
    return triangles;
  }
  Point<T> DrawPoint(Random& random) const {
    if (random.Below(4) == 0) {
      const T x = Step(middle.x, EitherSign(random, ulps));
      return {x, Step(middle.y, EitherSign(random, ulps))};
    }
    const std::size_t k = random.Below(kTriangles);
    const double s = ShareOf(exact, random, 0.05, 0.6);
    return BesideEdge(middle, rim[k], s, EitherSign(random, ulps));
  }
};

// As many meshes as give about groups · size answers, with `size` queries each.
template <class T, class Family>
Scene<T> SmallMeshes(const SceneSpec& spec, Loop loop, SceneSize size,
                     std::uint64_t seed) {
  Scene<T> scene{.name = spec.name, .loop = loop};
  Random random(
      SeedFor(std::string(Name(loop)).append("/").append(spec.name), seed));
  Family family{spec.Number("ulps", 0, 1 << 16), false, {}, {}};
  const std::size_t meshes =
      std::max<std::size_t>(size.groups / Family::kTriangles, 1);
  for (std::size_t m = 0; m < meshes; ++m) {
    family.exact = random.Below(2) == 0;
    Mesh<T> mesh;
    for (const Triangle<T>& t : family.Draw(random)) {
      mesh.triangles.push_back(InAnyOrder(random, t));
    }
    Query<T> query;
    for (std::uint32_t k = 0; k < Family::kTriangles; ++k) {
      query.asked.push_back(k);
    }
    while (mesh.queries.size() < size.size) {
      query.p = family.DrawPoint(random);
      mesh.queries.push_back(query);
    }
    AddMesh(mesh, size.size, static_cast<std::uint32_t>(m * size.size), scene);
  }
  return scene;
}

}  // namespace

template <class T>
Scene<T> MeshPairScene(const SceneSpec& spec, Loop loop, SceneSize size,
                       std::uint64_t seed) {
  return SmallMeshes<T, Pair<T>>(spec, loop, size, seed);
}

template <class T>
Scene<T> MeshFanScene(const SceneSpec& spec, Loop loop, SceneSize size,
                      std::uint64_t seed) {
  return SmallMeshes<T, Fan<T>>(spec, loop, size, seed);
}

#define PITBENCH_INSTANTIATE(T)                                      \
  template Scene<T> MeshPairScene(const SceneSpec&, Loop, SceneSize, \
                                  std::uint64_t);                    \
  template Scene<T> MeshFanScene(const SceneSpec&, Loop, SceneSize,  \
                                 std::uint64_t)
PITBENCH_INSTANTIATE(float);
PITBENCH_INSTANTIATE(double);
#undef PITBENCH_INSTANTIATE

}  // namespace pitbench
