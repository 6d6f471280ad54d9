// A random triangulation of 10 000 triangles: a grid of cells whose corners are
// moved at random, each cut along one diagonal or the other at random.
//
// A corner is moved by at most a fifth of a cell in either coordinate. The
// corner triangle of a cell that this flattens most keeps a fifth of the
// cell's area (its edges from (0, 0) are then (0.6, ±0.4) and (±0.4, 0.6)), so
// all are wound alike and their neighbours meet edge to edge.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "harness/scenes/families.h"
#include "harness/scenes/mesh.h"
#include "harness/scenes/step.h"

namespace pitbench {
namespace {

constexpr std::uint32_t kColumns = 100;  // cells
constexpr std::uint32_t kRows = 50;
constexpr double kCell = 0x1p-6;
constexpr double kMoved = 0.2;

template <class T>
class Triangulation {
 public:
  explicit Triangulation(Random& random) {
    std::vector<Point<T>>& v = vertices_;
    for (std::size_t j = 0; j <= kRows; ++j) {
      for (std::size_t i = 0; i <= kColumns; ++i) {
        const double x = static_cast<double>(i) + random.In(-kMoved, kMoved);
        const double y = static_cast<double>(j) + random.In(-kMoved, kMoved);
        v.push_back(Rounded<T>(Point<double>{x * kCell, y * kCell}));
      }
    }
    for (std::uint32_t j = 0; j < kRows; ++j) {
      for (std::uint32_t i = 0; i < kColumns; ++i) {
        const std::uint32_t p = j * (kColumns + 1) + i;
        const std::uint32_t q = p + kColumns + 1;  // above p
        if (random.Below(2) == 0) {
          corners_.push_back({p, p + 1, q});
          corners_.push_back({p + 1, q + 1, q});
        } else {
          corners_.push_back({p, p + 1, q + 1});
          corners_.push_back({p, q + 1, q});
        }
      }
    }
    for (const auto& [a, b, c] : corners_) {
      mesh_.triangles.push_back(
          InAnyOrder(random, Triangle<T>{v[a], v[b], v[c]}));
    }
  }

  // A random query; returns how many triangles it asks.
  std::size_t AddQuery(Random& random, std::int64_t ulps) {
    // A triangle two cells or more from the border, and one of its edges: even
    // 2^16 numbers of f32, half a cell, lead to no point outside the mesh.
    const std::size_t column = 2 + random.Below(kColumns - 4);
    const std::size_t row = 2 + random.Below(kRows - 4);
    const std::size_t cell = row * kColumns + column;
    const auto& corners = corners_[2 * cell + random.Below(2)];
    const std::size_t k = random.Below(3);
    const std::uint32_t from = corners[k];
    const std::uint32_t to = corners[(k + 1) % 3];
    const std::uint64_t which = random.Below(4);
    if (which == 0) return Ask(vertices_[from], {from});
    if (which == 1) {
      const double x = random.In(1, kColumns - 1);
      const double y = random.In(1, kRows - 1);
      return Ask(Rounded<T>(Point<double>{x * kCell, y * kCell}), {});
    }
    const double s = random.Unit();
    const std::int64_t steps = random.Below(2) == 0 ? ulps : -ulps;
    return Ask(BesideEdge(vertices_[from], vertices_[to], s, steps),
               {from, to});
  }

  const Mesh<T>& mesh() const { return mesh_; }

 private:
  // Asks the triangles that hold p, and those with a corner among `ends`.
  std::size_t Ask(const Point<T>& p, const std::vector<std::uint32_t>& ends) {
    Query<T> query{p, {}};
    // The triangles of a cell reach up to a fifth of a cell beyond it, so what
    // holds p is in p's cell or next to it. An end of an edge beside p is the
    // corner of a cell at most 1.2 cells and the half that p was moved away, so
    // the four cells around it are within two of p's.
    const auto first = [](double x, std::size_t last) {
      const double cell = std::floor(x / kCell) - kReach;
      return static_cast<std::size_t>(
          std::clamp(cell, 0.0, static_cast<double>(last)));
    };
    const std::size_t column = first(static_cast<double>(p.x), kColumns - 1);
    const std::size_t row = first(static_cast<double>(p.y), kRows - 1);
    const std::size_t end_column =
        std::min<std::size_t>(column + 2 * kReach + 1, kColumns);
    const std::size_t end_row =
        std::min<std::size_t>(row + 2 * kReach + 1, kRows);
    for (std::size_t j = row; j < end_row; ++j) {
      for (std::size_t i = column; i < end_column; ++i) {
        for (std::size_t half = 0; half < 2; ++half) {
          const std::size_t k = 2 * (j * kColumns + i) + half;
          const auto touches = [&](std::uint32_t end) {
            return std::ranges::count(corners_[k], end) != 0;
          };
          if (std::ranges::any_of(ends, touches) ||
              Holds(mesh_.triangles[k], p)) {
            query.asked.push_back(static_cast<std::uint32_t>(k));
          }
        }
      }
    }
    mesh_.queries.push_back(std::move(query));
    return mesh_.queries.back().asked.size();
  }

  static constexpr std::size_t kReach = 2;
  std::vector<Point<T>> vertices_;
  std::vector<std::array<std::uint32_t, 3>> corners_;  // of each triangle
  Mesh<T> mesh_;
};

}  // namespace

template <class T>
Scene<T> MeshTriangulationScene(const SceneSpec& spec, Loop loop,
                                SceneSize size, std::uint64_t seed) {
  const std::int64_t ulps = spec.Number("ulps", 0, 1 << 16);
  Random random(
      SeedFor(std::string(Name(loop)).append("/").append(spec.name), seed));
  Triangulation<T> triangulation(random);
  for (std::size_t answers = 0; answers < size.groups * size.size;) {
    answers += triangulation.AddQuery(random, ulps);
  }
  Scene<T> scene{.name = spec.name, .loop = loop};
  AddMesh(triangulation.mesh(), size.size, 0, scene);
  return scene;
}

template Scene<float> MeshTriangulationScene(const SceneSpec&, Loop, SceneSize,
                                             std::uint64_t);
template Scene<double> MeshTriangulationScene(const SceneSpec&, Loop, SceneSize,
                                              std::uint64_t);

}  // namespace pitbench
