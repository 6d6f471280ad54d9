#include "harness/scenes/mesh.h"

#include <algorithm>

namespace pitbench {
namespace {

template <class T>
void AddByTriangle(const Mesh<T>& mesh, std::uint32_t first_query,
                   Scene<T>& scene) {
  std::vector<std::vector<std::uint32_t>> queries_of(mesh.triangles.size());
  for (std::size_t q = 0; q < mesh.queries.size(); ++q) {
    for (const std::uint32_t k : mesh.queries[q].asked) {
      queries_of[k].push_back(static_cast<std::uint32_t>(q));
    }
  }
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    if (queries_of[k].empty()) continue;
    scene.calls.push_back(
        {scene.ax.size(), scene.px.size(), queries_of[k].size()});
    scene.Add(mesh.triangles[k]);
    for (const std::uint32_t q : queries_of[k]) {
      scene.Add(mesh.queries[q].p);
      scene.query.push_back(first_query + q);
    }
  }
}

template <class T>
void AddByPoint(const Mesh<T>& mesh, std::uint32_t first_query,
                Scene<T>& scene) {
  std::uint32_t number = first_query;
  for (const Query<T>& query : mesh.queries) {
    scene.calls.push_back(
        {scene.ax.size(), scene.px.size(), query.asked.size()});
    scene.Add(query.p);
    for (const std::uint32_t k : query.asked) {
      scene.Add(mesh.triangles[k]);
      scene.query.push_back(number);
    }
    ++number;
  }
}

template <class T>
void AddPairs(const Mesh<T>& mesh, std::size_t call_size,
              std::uint32_t first_query, Scene<T>& scene) {
  const std::size_t begin = scene.px.size();
  std::uint32_t number = first_query;
  for (const Query<T>& query : mesh.queries) {
    for (const std::uint32_t k : query.asked) {
      scene.Add(mesh.triangles[k]);
      scene.Add(query.p);
      scene.query.push_back(number);
    }
    ++number;
  }
  for (std::size_t i = begin; i < scene.px.size(); i += call_size) {
    scene.calls.push_back({i, i, std::min(call_size, scene.px.size() - i)});
  }
}

}  // namespace

template <class T>
void AddMesh(const Mesh<T>& mesh, std::size_t call_size,
             std::uint32_t first_query, Scene<T>& scene) {
  if (scene.loop == Loop::kOneTriangle) {
    AddByTriangle(mesh, first_query, scene);
  } else if (scene.loop == Loop::kOnePoint) {
    AddByPoint(mesh, first_query, scene);
  } else {
    AddPairs(mesh, call_size, first_query, scene);
  }
}

template void AddMesh(const Mesh<float>&, std::size_t, std::uint32_t,
                      Scene<float>&);
template void AddMesh(const Mesh<double>&, std::size_t, std::uint32_t,
                      Scene<double>&);

}  // namespace pitbench
