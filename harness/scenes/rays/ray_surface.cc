#include "harness/scenes/rays/ray_surface.h"

#include <algorithm>
#include <string>
#include <utility>

#include "harness/scenes/rays/ray_families.h"

namespace pitbench {
namespace {

template <class T>
class Asked {
 public:
  Asked(Surface surface, std::int64_t ulps)
      : surface_(std::move(surface)),
        ulps_(ulps),
        around_(surface_.vertices.size()) {
    for (std::uint32_t k = 0; k < surface_.triangles.size(); ++k) {
      for (const std::uint32_t v : surface_.triangles[k]) {
        around_[v].push_back(k);
      }
    }
  }

  void AddTriangles(Random& random) {
    for (const auto& [a, b, c] : surface_.triangles) {
      mesh_.triangles.push_back(FromAnyVertex(
          random, Rounded<T>(Triangle3<double>{At(a), At(b), At(c)})));
    }
  }

  // A random query; returns how many triangles it asks.
  std::size_t AddQuery(Random& random) {
    const std::uint32_t aim = surface_.aims[random.Below(surface_.aims.size())];
    const std::size_t first = random.Below(3);
    const auto corner = [&](std::size_t k) {
      return surface_.triangles[aim][(first + k) % 3];
    };
    const bool exact = random.Below(2) == 0;
    const std::uint64_t kind = random.Below(4);
    std::vector<std::uint32_t> ends = {corner(0)};
    Point3<T> target;
    if (kind == 0) {
      target = BesideVertex(random, Rounded<T>(At(corner(0))), ulps_);
    } else if (kind == 1) {
      const double u = random.Unit();
      const double v = random.In(0, 1 - u);
      target =
          Rounded<T>(Mix({At(corner(0)), At(corner(1)), At(corner(2))}, u, v));
      ends.push_back(corner(1));
      ends.push_back(corner(2));
    } else {
      const double unit = random.Unit();
      target = BesideEdge<T>(At(corner(0)), At(corner(1)), At(corner(2)),
                             exact ? OnGrid(unit, 4) : unit,
                             EitherSign(random, ulps_));
      ends.push_back(corner(1));
    }
    const Vector3 from = surface_.origin(random, Widened(target));
    typename RayMesh<T>::Query query{
        RayTo(exact ? OnGrid(from, kGridBits<T>) : from, target), {}};
    for (const std::uint32_t end : ends) {
      query.asked.insert(query.asked.end(), around_[end].begin(),
                         around_[end].end());
    }
    std::sort(query.asked.begin(), query.asked.end());
    query.asked.erase(std::unique(query.asked.begin(), query.asked.end()),
                      query.asked.end());
    mesh_.queries.push_back(std::move(query));
    return mesh_.queries.back().asked.size();
  }

  const RayMesh<T>& mesh() const { return mesh_; }

 private:
  const Vector3& At(std::uint32_t vertex) const {
    return surface_.vertices[vertex];
  }

  Surface surface_;
  std::int64_t ulps_;
  std::vector<std::vector<std::uint32_t>> around_;  // each vertex
  RayMesh<T> mesh_;
};

}  // namespace

template <class T>
RayScene<T> AskSurface(Surface (*make)(Random&, int), const SceneSpec& spec,
                       RayLoop loop, SceneSize size, std::uint64_t seed) {
  // 2^16 numbers of f32 are 0.004 there, and edges are 0.08 or longer: a ray
  // that is moved stays within the triangles around what it was aimed at.
  const std::int64_t ulps = spec.Number("ulps", 0, 1 << 16);
  RayScene<T> scene{.name = spec.name, .loop = loop};
  Random random(SeedFor(
      std::string(Name(ShapeOf(loop))).append("/").append(spec.name), seed));
  Asked<T> asked(make(random, kGridBits<T>), ulps);
  asked.AddTriangles(random);
  for (std::size_t answers = 0; answers < size.groups * size.size;) {
    answers += asked.AddQuery(random);
  }
  AddMesh(asked.mesh(), size.size, 0, scene);
  return scene;
}

template RayScene<float> AskSurface(Surface (*)(Random&, int), const SceneSpec&,
                                    RayLoop, SceneSize, std::uint64_t);
template RayScene<double> AskSurface(Surface (*)(Random&, int),
                                     const SceneSpec&, RayLoop, SceneSize,
                                     std::uint64_t);

}  // namespace pitbench
