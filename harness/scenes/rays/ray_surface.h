// Surfaces that no ray may slip through, and rays asked of the triangles around
// the place where they cross.
#ifndef PITBENCH_HARNESS_SCENES_RAYS_RAY_SURFACE_H_
#define PITBENCH_HARNESS_SCENES_RAYS_RAY_SURFACE_H_

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "harness/scenes/mesh.h"
#include "harness/scenes/rays/ray_scene.h"

namespace pitbench {

template <class T>
using RayMesh = MeshOf<Triangle3<T>, Ray<T>>;

// Vertices are on the grid (kGridBits); triangles show their fronts to where
// rays come from.
struct Surface {
  std::vector<Point3<double>> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  // Those at which rays are aimed: none near a rim.
  std::vector<std::uint32_t> aims;
  // An origin from which a ray to `target`, or to any place nearly there,
  // crosses the surface once.
  std::function<Point3<double>(Random&, const Point3<double>& target)> origin;
};

// The icosahedron with each triangle cut into four three times: 1280 triangles
// around the origin of the coordinates, turned at random, and rays from within
// half of the radius.
Surface Icosphere(Random& random, int grid_bits);

// 24 × 24 tilted cells, irregular and exactly in one plane, cut into two
// triangles each; rays from above.
Surface TiledPlane(Random& random, int grid_bits);

// A quarter of the rays is aimed at the inside of a triangle, a half at an edge
// and a quarter at a vertex, the last two moved by parameter `ulps`. Half of
// the rays begin on the grid and are aimed at sixteenths of edges, so that
// before they are moved they are exact. Each is asked of all triangles that
// have a vertex with what it is aimed at in common.
template <class T>
RayScene<T> AskSurface(Surface (*make)(Random&, int), const SceneSpec& spec,
                       RayLoop loop, SceneSize size, std::uint64_t seed);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_SCENES_RAYS_RAY_SURFACE_H_
