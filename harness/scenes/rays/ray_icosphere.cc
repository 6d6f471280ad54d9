// A closed sphere of 1280 triangles, and rays from inside.
//
// Neighbours that meet at an edge of length l are bent by about l; where l is
// 0.13 to 0.17, rounding the vertices to the grid of f32, 2^-16, leaves a
// convex body. So a ray from inside crosses it once.
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include "harness/scenes/rays/ray_families.h"
#include "harness/scenes/rays/ray_surface.h"

namespace pitbench {
namespace {

using Corners = std::array<std::uint32_t, 3>;

constexpr int kCuts = 3;

// Fronts outward: counter-clockwise as seen from outside.
constexpr Corners kIcosahedron[] = {
    {0, 5, 1},  {0, 1, 7},  {0, 11, 5},  {0, 7, 10}, {0, 10, 11},
    {1, 5, 9},  {1, 8, 7},  {1, 9, 8},   {2, 3, 4},  {2, 6, 3},
    {2, 4, 11}, {2, 10, 6}, {2, 11, 10}, {3, 9, 4},  {3, 6, 8},
    {3, 8, 9},  {4, 9, 5},  {4, 5, 11},  {6, 7, 8},  {6, 10, 7}};

// Three directions across each other.
struct Frame {
  Vector3 x, y, z;

  explicit Frame(Random& random) : x(AnyDirection(random)) {
    Vector3 across = Cross(x, AnyDirection(random));
    while (Dot(across, across) < 0.01) {
      across = Cross(x, AnyDirection(random));
    }
    y = Unit(across);
    z = Cross(x, y);
  }
  Vector3 Turned(const Vector3& p) const { return p.x * x + p.y * y + p.z * z; }
};

}  // namespace

Surface Icosphere(Random& random, int grid_bits) {
  const Frame frame(random);
  Surface s;
  // (±1, ±golden, 0) and what renaming the axes makes of it.
  const double golden = (1 + std::sqrt(5.0)) / 2;
  for (const int turn : {0, 1, 2}) {
    for (const double b : {golden, -golden}) {
      for (const double a : {-1.0, 1.0}) {
        const Vector3 p = turn == 0   ? Vector3{a, b, 0}
                          : turn == 1 ? Vector3{0, a, b}
                                      : Vector3{b, 0, a};
        s.vertices.push_back(Unit(frame.Turned(p)));
      }
    }
  }

  std::vector<Corners> triangles(std::begin(kIcosahedron),
                                 std::end(kIcosahedron));
  for (int cut = 0; cut < kCuts; ++cut) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t i, std::uint32_t j) {
      const auto [place, fresh] = middles.try_emplace(
          std::minmax(i, j), static_cast<std::uint32_t>(s.vertices.size()));
      if (fresh) s.vertices.push_back(Unit(s.vertices[i] + s.vertices[j]));
      return place->second;
    };
    std::vector<Corners> finer;
    for (const auto& [a, b, c] : triangles) {
      const std::uint32_t ab = middle(a, b);
      const std::uint32_t bc = middle(b, c);
      const std::uint32_t ca = middle(c, a);
      finer.insert(finer.end(),
                   {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    triangles = std::move(finer);
  }
  for (Vector3& p : s.vertices) p = OnGrid(p, grid_bits);
  for (const auto& [a, b, c] : triangles) {
    s.aims.push_back(static_cast<std::uint32_t>(s.triangles.size()));
    s.triangles.push_back({a, c, b});
  }
  s.origin = [](Random& r, const Vector3&) { return AnyWay(r, 0, 0.5); };
  return s;
}

template <class T>
RayScene<T> RaysIcosphereScene(const SceneSpec& spec, RayLoop loop,
                               SceneSize size, std::uint64_t seed) {
  return AskSurface<T>(Icosphere, spec, loop, size, seed);
}

PITBENCH_INSTANTIATE_RAYS(RaysIcosphereScene);

}  // namespace pitbench
