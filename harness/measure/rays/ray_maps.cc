#include "harness/measure/rays/ray_maps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "harness/measure/cells.h"
#include "harness/measure/failures.h"
#include "harness/measure/map_entries.h"
#include "harness/measure/rays/ray_answers.h"
#include "harness/scenes/rays/ray_corpus.h"
#include "harness/scenes/rays/ray_families.h"
#include "harness/scenes/rays/ray_surface.h"

namespace pitbench {
namespace {

using nlohmann::json;

constexpr std::size_t kRays = kRayMapSide * kRayMapSide;
constexpr const char* kName = "ray_map";

template <class T>
constexpr T kStep = std::numeric_limits<T>::epsilon() / 2;  // from ½ to 1

// A window, and how it lies in space.
template <class T>
struct Window {
  RayScene<T> scene;
  std::array<std::size_t, 2> axes;  // along i and along j

  Window() : scene{.name = kName, .loop = RayLoop::kOneTriangleRays} {
    scene.t_max = std::numeric_limits<T>::infinity();
    Random random(SeedFor(kName, 0));
    const Surface surface = Icosphere(random, kGridBits<T>);
    // The last vertex is none of the icosahedron, so six triangles meet there.
    const auto vertex = static_cast<std::uint32_t>(surface.vertices.size() - 1);
    const Point3<T> target = Rounded<T>(surface.vertices[vertex]);
    Ray<T> ray;
    std::size_t longest = 0;
    do {
      const Vector3 from = surface.origin(random, Widened(target));
      ray = RayTo(OnGrid(from, kGridBits<T>), target);
      longest = LongestAxis(ray.direction);
    } while (!Fits(ray.direction, longest));
    axes = {(longest + 1) % 3, (longest + 2) % 3};
    for (const auto& corners : surface.triangles) {
      if (std::find(corners.begin(), corners.end(), vertex) == corners.end()) {
        continue;
      }
      scene.Add(Rounded<T>(Triangle3<double>{surface.vertices[corners[0]],
                                             surface.vertices[corners[1]],
                                             surface.vertices[corners[2]]}));
    }
    for (std::size_t j = 0; j < kRayMapSide; ++j) {
      for (std::size_t i = 0; i < kRayMapSide; ++i) {
        Ray<T> moved = ray;
        Axis(moved.direction, axes[0]) += Steps(i);
        Axis(moved.direction, axes[1]) += Steps(j);
        scene.Add(moved);
      }
    }
    for (std::size_t k = 0; k < scene.Triangles(); ++k) {
      scene.calls.push_back({k, 0, kRays});
    }
  }

 private:
  static T Steps(std::size_t pixel) {
    constexpr std::size_t kMiddle = kRayMapSide / 2;
    return (static_cast<T>(pixel) - static_cast<T>(kMiddle)) * kStep<T>;
  }
  static std::size_t LongestAxis(Point3<T> direction) {
    std::size_t longest = 0;
    for (const std::size_t axis : {1, 2}) {
      if (std::abs(Axis(direction, axis)) >
          std::abs(Axis(direction, longest))) {
        longest = axis;
      }
    }
    return longest;
  }
  // Whether steps along the other two axes stay where they are exact, and the
  // longest axis the longest.
  static bool Fits(Point3<T> direction, std::size_t longest) {
    const T length = std::abs(Axis(direction, longest));
    const T room = static_cast<T>(kRayMapSide) * kStep<T>;
    const T second = std::max(std::abs(Axis(direction, (longest + 1) % 3)),
                              std::abs(Axis(direction, (longest + 2) % 3)));
    return length >= static_cast<T>(0.5) && length < 1 &&
           second + room < length;
  }
};

template <class T>
const Window<T>& TheWindow() {
  static const Window<T> window;
  return window;
}

template <class T>
const SceneTruth& TheTruth() {
  static const SceneTruth truth = JudgeRays(TheWindow<T>().scene, false);
  return truth;
}

template <class T>
json HexOf(const Point3<T>& p) {
  return Hex(p.x, p.y, p.z);
}

template <class T>
json WindowEntry() {
  const Window<T>& window = TheWindow<T>();
  const RayScene<T>& scene = window.scene;
  Bits on_edge(BitBytes(kRays));
  for (const CallTruth& call : TheTruth<T>().calls) {
    for (std::size_t byte = 0; byte < on_edge.size(); ++byte) {
      on_edge[byte] |= call.boundary[byte];
    }
  }
  json triangles = json::array();
  for (std::size_t k = 0; k < scene.Triangles(); ++k) {
    const Triangle3<T> t = scene.TriangleAt(k);
    triangles.push_back({HexOf(t.a), HexOf(t.b), HexOf(t.c)});
  }
  constexpr std::array<const char*, 3> kAxisNames = {"x", "y", "z"};
  return {{"scalar", Name(ScalarOf<T>())},
          {"width", kRayMapSide},
          {"height", kRayMapSide},
          {"origin", HexOf(scene.RayAt(0).origin)},
          {"direction", HexOf(scene.RayAt(0).direction)},
          {"axes", {kAxisNames[window.axes[0]], kAxisNames[window.axes[1]]}},
          {"step", Hex(kStep<T>)[0]},
          {"triangles", std::move(triangles)},
          {"on_edge", Base64(on_edge)}};
}

template <class T>
json RayMap(const RayKernel& kernel) {
  const RayScene<T>& scene = TheWindow<T>().scene;
  const Answers<T> answers = Ask(kernel, scene, TheTruth<T>());
  Bits claimed(BitBytes(kRays));
  Bits twice(BitBytes(kRays));
  for (const Bits& said : answers.bits) {
    for (std::size_t byte = 0; byte < said.size(); ++byte) {
      twice[byte] |= static_cast<std::uint8_t>(claimed[byte] & said[byte]);
      claimed[byte] |= said[byte];
    }
  }
  std::size_t holes = 0;
  std::size_t double_hits = 0;
  for (std::size_t ray = 0; ray < kRays; ++ray) {
    holes += BitAt(claimed, ray) ? 0 : 1;
    double_hits += BitAt(twice, ray) ? 1 : 0;
  }
  const auto said_inside =
      std::count_if(answers.wrong.begin(), answers.wrong.end(),
                    [](const Wrong& wrong) { return wrong.said_inside; });
  const auto false_inside = static_cast<std::size_t>(said_inside);
  json map = Named(kernel);
  map.update({{"claimed", Base64(claimed)},
              {"claimed_twice", Base64(twice)},
              {"counts",
               {{"false_inside", false_inside},
                {"false_outside", answers.wrong.size() - false_inside},
                {"boundary_accepted", answers.boundary_accepted},
                {"holes", holes},
                {"double_hits", double_hits}}}});
  return map;
}

// What each of the kernels says of the published cases, all pairs of one call.
template <class T>
void AddCases(const std::vector<const RayKernel*>& kernels, json& cases) {
  const RayScene<T> scene =
      MakeRayScene<T>(ParseScene("rays_corpus"), RayLoop::kRayPairs, {}, 0);
  std::vector<std::pair<std::string_view, Bits>> said;
  for (const RayKernel* kernel : kernels) {
    Answers<T> answers;
    Run(*kernel, scene, answers);
    said.emplace_back(kernel->method.key, answers.bits.at(0));
  }
  std::size_t i = 0;
  for (const RayCase& one : RayCorpus()) {
    if (one.scalar != Name(ScalarOf<T>())) continue;
    json answers = json::array();
    for (const auto& [method, bits] : said) {
      answers.push_back({{"method", method}, {"hit", BitAt(bits, i)}});
    }
    ++i;
    cases.push_back(
        {{"id", one.id},
         {"source", one.source},
         {"scalar", one.scalar},
         {"truth", Name(Classify(one.TriangleAs<T>(), one.RayAs<T>()))},
         {"answers", std::move(answers)}});
  }
}

template <class T>
std::vector<const RayKernel*> Wanted(const NameFilter& filter, RayLoop loop,
                                     const char* scene) {
  std::vector<const RayKernel*> wanted =
      WidestKernels(AllRayKernels(), loop, RayOutput::kHits);
  std::erase_if(wanted, [&](const RayKernel* kernel) {
    return kernel->scalar != ScalarOf<T>() ||
           !filter.Finds(CellName(*kernel, scene));
  });
  return wanted;
}

}  // namespace

template <class T>
RayScene<T> RayMapScene() {
  return TheWindow<T>().scene;
}
template RayScene<float> RayMapScene();
template RayScene<double> RayMapScene();

json MakeRayMaps(const NameFilter& filter) {
  json windows = json::array();
  json maps = json::array();
  json cases = json::array();
  const auto add = [&]<class T>(T) {
    const auto kernels = Wanted<T>(filter, RayLoop::kOneTriangleRays, kName);
    if (!kernels.empty()) windows.push_back(WindowEntry<T>());
    for (const RayKernel* kernel : kernels) {
      maps.push_back(RayMap<T>(*kernel));
    }
    const auto asked = Wanted<T>(filter, RayLoop::kRayPairs, "rays_corpus");
    if (!asked.empty()) AddCases<T>(asked, cases);
  };
  add(float{});
  add(double{});
  return {{"ray_windows", std::move(windows)},
          {"ray_maps", std::move(maps)},
          {"ray_cases", std::move(cases)}};
}

}  // namespace pitbench
