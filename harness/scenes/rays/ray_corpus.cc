// The corpus of published bug reports about rays as a scene.
#include "harness/scenes/rays/ray_corpus.h"

#include <string_view>

#include "harness/scenes/rays/ray_families.h"

namespace pitbench {
namespace {

// Written by CMake from the file in tests/cases/.
constexpr std::string_view kRays =
#include "rays.inc"
    ;

}  // namespace

std::vector<RayCase> RayCorpus() {
  constexpr std::array<std::string_view, 20> kHeader = {
      "id", "scalar", "source", "ax", "ay", "az", "bx", "by", "bz",    "cx",
      "cy", "cz",     "ox",     "oy", "oz", "dx", "dy", "dz", "truth", "note"};
  const auto table = ReadCsvText<std::string>("rays.csv", kRays, kHeader);
  std::vector<RayCase> cases;
  for (std::size_t i = 0; i < table.rows; ++i) {
    RayCase one{.id = table.columns[0][i],
                .scalar = table.columns[1][i],
                .source = table.columns[2][i],
                .at = {},
                .truth = table.columns[18][i]};
    for (std::size_t k = 0; k < one.at.size(); ++k) {
      one.at[k] = table.columns[3 + k][i];
    }
    cases.push_back(one);
  }
  return cases;
}

// Nothing about it is random and its size is its own. For pairs it is one call,
// for the other loops a call a case.
template <class T>
RayScene<T> RaysCorpusScene(const SceneSpec& spec, RayLoop loop,
                            SceneSize /*size*/, std::uint64_t /*seed*/) {
  RayScene<T> scene{.name = spec.name, .loop = loop};
  for (const RayCase& one : RayCorpus()) {
    if (one.scalar != Name(ScalarOf<T>())) continue;
    const std::size_t i = scene.Triangles();
    scene.Add(one.TriangleAs<T>());
    scene.Add(one.RayAs<T>());
    if (loop != RayLoop::kRayPairs) scene.calls.push_back({i, i, 1});
  }
  if (loop == RayLoop::kRayPairs) scene.calls = {{0, 0, scene.Triangles()}};
  return scene;
}

PITBENCH_INSTANTIATE_RAYS(RaysCorpusScene);

}  // namespace pitbench
