// A tilted plane of 1152 triangles, and rays from above.
//
// Vertices are base + x·p + y·q for whole x and y moved by up to three
// sixteenths, which no cell of the grid turns over for (see
// mesh_triangulation.cc). p and q have so few bits that all of this is exact:
// the surface is flat, also in T.
#include <cmath>
#include <cstdint>

#include "harness/scenes/rays/ray_families.h"
#include "harness/scenes/rays/ray_surface.h"

namespace pitbench {
namespace {

constexpr std::uint32_t kCells = 24;  // in either direction

double Moved(Random& random, std::uint32_t k) {
  return k + (static_cast<double>(random.Below(7)) - 3) / 16;
}

}  // namespace

Surface TiledPlane(Random& random, int grid_bits) {
  Surface s;
  // An eighth long; sixteenths of them are on the grid.
  const Vector3 normal = AnyDirection(random);
  Vector3 across = Cross(normal, AnyDirection(random));
  while (Dot(across, across) < 0.01) {
    across = Cross(normal, AnyDirection(random));
  }
  across = Unit(across);
  const Vector3 p = OnGrid(0.125 * across, grid_bits - 4);
  const Vector3 q = OnGrid(0.125 * Cross(normal, across), grid_bits - 4);
  const Vector3 base =
      OnGrid(InUnitCube(random), grid_bits - 4) - 0.5 * kCells * (p + q);
  for (std::uint32_t j = 0; j <= kCells; ++j) {
    for (std::uint32_t i = 0; i <= kCells; ++i) {
      const double x = Moved(random, i);
      s.vertices.push_back(base + x * p + Moved(random, j) * q);
    }
  }
  for (std::uint32_t j = 0; j < kCells; ++j) {
    for (std::uint32_t i = 0; i < kCells; ++i) {
      const std::uint32_t at = j * (kCells + 1) + i;
      const std::uint32_t above = at + kCells + 1;
      // Two cells or more from the rim.
      const auto inner = [](std::uint32_t k) {
        return k >= 2 && k < kCells - 2;
      };
      for (std::uint32_t k = 0; inner(i) && inner(j) && k < 2; ++k) {
        s.aims.push_back(static_cast<std::uint32_t>(s.triangles.size()) + k);
      }
      if (random.Below(2) == 0) {
        s.triangles.push_back({at, at + 1, above});
        s.triangles.push_back({at + 1, above + 1, above});
      } else {
        s.triangles.push_back({at, at + 1, above + 1});
        s.triangles.push_back({at, above + 1, above});
      }
    }
  }
  // p × q is along the normal, so from there the fronts are seen; 0.7 across
  // leaves rays at 45° or steeper.
  s.origin = [normal](Random& r, const Vector3& target) {
    const double height = r.In(0.5, 2);
    return target + height * (normal + AnyWay(r, 0, 0.7));
  };
  return s;
}

template <class T>
RayScene<T> RaysTiledPlaneScene(const SceneSpec& spec, RayLoop loop,
                                SceneSize size, std::uint64_t seed) {
  return AskSurface<T>(TiledPlane, spec, loop, size, seed);
}

PITBENCH_INSTANTIATE_RAYS(RaysTiledPlaneScene);

}  // namespace pitbench
