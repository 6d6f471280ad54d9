#include "harness/scenes/mesh.h"

#include <algorithm>

#include "harness/scenes/rays/ray_surface.h"

namespace pitbench {
namespace {

template <class MeshType, class SceneType>
void AddByTriangle(const MeshType& mesh, std::uint32_t first_query,
                   SceneType& scene) {
  std::vector<std::vector<std::uint32_t>> queries_of(mesh.triangles.size());
  for (std::size_t q = 0; q < mesh.queries.size(); ++q) {
    for (const std::uint32_t k : mesh.queries[q].asked) {
      queries_of[k].push_back(static_cast<std::uint32_t>(q));
    }
  }
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    if (queries_of[k].empty()) continue;
    scene.calls.push_back(
        {scene.Triangles(), scene.Probes(), queries_of[k].size()});
    scene.Add(mesh.triangles[k]);
    for (const std::uint32_t q : queries_of[k]) {
      scene.Add(mesh.queries[q].p);
      scene.query.push_back(first_query + q);
    }
  }
}

template <class MeshType, class SceneType>
void AddByPoint(const MeshType& mesh, std::uint32_t first_query,
                SceneType& scene) {
  std::uint32_t number = first_query;
  for (const auto& query : mesh.queries) {
    scene.calls.push_back(
        {scene.Triangles(), scene.Probes(), query.asked.size()});
    scene.Add(query.p);
    for (const std::uint32_t k : query.asked) {
      scene.Add(mesh.triangles[k]);
      scene.query.push_back(number);
    }
    ++number;
  }
}

template <class MeshType, class SceneType>
void AddPairs(const MeshType& mesh, std::size_t call_size,
              std::uint32_t first_query, SceneType& scene) {
  const std::size_t begin = scene.Probes();
  std::uint32_t number = first_query;
  for (const auto& query : mesh.queries) {
    for (const std::uint32_t k : query.asked) {
      scene.Add(mesh.triangles[k]);
      scene.Add(query.p);
      scene.query.push_back(number);
    }
    ++number;
  }
  for (std::size_t i = begin; i < scene.Probes(); i += call_size) {
    scene.calls.push_back({i, i, std::min(call_size, scene.Probes() - i)});
  }
}

}  // namespace

template <class MeshType, class SceneType>
void AddMesh(const MeshType& mesh, std::size_t call_size,
             std::uint32_t first_query, SceneType& scene) {
  const Loop shape = ShapeOf(scene.loop);
  if (shape == Loop::kOneTriangle) {
    AddByTriangle(mesh, first_query, scene);
  } else if (shape == Loop::kOnePoint) {
    AddByPoint(mesh, first_query, scene);
  } else {
    AddPairs(mesh, call_size, first_query, scene);
  }
}

template void AddMesh(const Mesh<float>&, std::size_t, std::uint32_t,
                      Scene<float>&);
template void AddMesh(const Mesh<double>&, std::size_t, std::uint32_t,
                      Scene<double>&);
template void AddMesh(const RayMesh<float>&, std::size_t, std::uint32_t,
                      RayScene<float>&);
template void AddMesh(const RayMesh<double>&, std::size_t, std::uint32_t,
                      RayScene<double>&);

}  // namespace pitbench
