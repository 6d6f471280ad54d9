// Pieces of the plane cut into triangles, and points asked about in them: who
// owns a point, none, one or several?
#ifndef PITBENCH_HARNESS_SCENES_MESH_H_
#define PITBENCH_HARNESS_SCENES_MESH_H_

#include <cstddef>
#include <cstdint>
#include <vector>

#include "harness/scenes/random.h"
#include "harness/scenes/scene.h"

namespace pitbench {

template <class TriangleType, class Probe>
struct MeshOf {
  // A point in the interior of the mesh, and every triangle that could hold it;
  // or a ray, and every triangle that it could meet.
  struct Query {
    Probe p;
    std::vector<std::uint32_t> asked;
  };
  std::vector<TriangleType> triangles;
  std::vector<Query> queries;
};

template <class T>
using Mesh = MeshOf<Triangle<T>, Point<T>>;
template <class T>
using Query = typename Mesh<T>::Query;

// Appends the mesh to the scene in the form of its loop: one_triangle has a
// call for every triangle that is asked, one_point for every query, and pairs
// one for every `call_size` answers. Its queries get the numbers from
// `first_query` on.
// SceneType is Scene<T> or RayScene<T>, of float or double.
template <class MeshType, class SceneType>
void AddMesh(const MeshType& mesh, std::size_t call_size,
             std::uint32_t first_query, SceneType& scene);

// Whether p is in the triangle or on its boundary, exactly.
template <class T>
bool Holds(const Triangle<T>& triangle, const Point<T>& p) {
  const Position position = Classify(triangle, p);
  return position == Position::kInside || position == Position::kBoundary;
}

// The triangle with its vertices in any of the six orders: a mesh of one's own
// would be wound one way, but no method may depend on that.
template <class T>
Triangle<T> InAnyOrder(Random& random, const Triangle<T>& t) {
  const Point<T> v[] = {t.a, t.b, t.c};
  const std::size_t first = random.Below(3);
  const std::size_t second = (first + 1 + random.Below(2)) % 3;
  return {v[first], v[second], v[3 - first - second]};
}

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_SCENES_MESH_H_
