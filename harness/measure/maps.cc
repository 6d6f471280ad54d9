#include "harness/measure/maps.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "harness/measure/answers.h"
#include "harness/measure/cells.h"
#include "harness/measure/map_entries.h"

namespace pitbench {
namespace {

using nlohmann::json;

std::string Hex(double x) {
  std::array<char, 40> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%a", x);
  return buffer.data();
}

json Hex(const Point<float>& p) {
  return {Hex(static_cast<double>(p.x)), Hex(static_cast<double>(p.y))};
}

constexpr std::size_t kSide = 256;  // of an ulp map, in points

// Call 0 asks the triangle below the diagonal, call 1 the one above.
template <class T>
Scene<T> UlpScene() {
  Scene<T> scene{.name = "ulp_map", .loop = Loop::kOneTriangle};
  scene.Add(Triangle<T>{{-12, -12}, {24, 24}, {24, -12}});
  scene.Add(Triangle<T>{{-12, -12}, {24, 24}, {-12, 24}});
  const T ulp = std::numeric_limits<T>::epsilon() / 2;  // from 0.5 to 1
  for (std::size_t j = 0; j < kSide; ++j) {
    for (std::size_t i = 0; i < kSide; ++i) {
      scene.Add(Point<T>{static_cast<T>(0.5) + static_cast<T>(i) * ulp,
                         static_cast<T>(0.5) + static_cast<T>(j) * ulp});
    }
  }
  scene.calls = {{0, 0, kSide * kSide}, {1, 0, kSide * kSide}};
  return scene;
}

template <class T>
json UlpMap(const Kernel& kernel) {
  static const Scene<T> scene = UlpScene<T>();
  const std::vector<Bits> said = Run(kernel, scene).bits;
  std::size_t false_inside = 0, false_outside = 0, boundary_accepted = 0;
  std::size_t holes = 0, double_hits = 0;
  for (std::size_t point = 0; point < kSide * kSide; ++point) {
    const std::size_t i = point % kSide;
    const std::size_t j = point / kSide;
    const std::array<bool, 2> claims = {BitAt(said[0], point),
                                        BitAt(said[1], point)};
    const std::array<bool, 2> holds = {i > j, i < j};
    for (std::size_t k = 0; k < 2; ++k) {
      if (i == j) {
        boundary_accepted += claims[k] ? 1 : 0;
      } else {
        false_inside += claims[k] && !holds[k] ? 1 : 0;
        false_outside += !claims[k] && holds[k] ? 1 : 0;
      }
    }
    holes += !claims[0] && !claims[1] ? 1 : 0;
    double_hits += claims[0] && claims[1] ? 1 : 0;
  }
  json map = Named(kernel);
  map.update({{"width", kSide},
              {"height", kSide},
              {"lower", Base64(said[0])},
              {"upper", Base64(said[1])},
              {"counts",
               {{"false_inside", false_inside},
                {"false_outside", false_outside},
                {"boundary_accepted", boundary_accepted},
                {"holes", holes},
                {"double_hits", double_hits}}}});
  return map;
}

constexpr std::size_t kSamples = 48;  // along a side of a gradient

// f32 has steps of 2^-5 from 2^18 to 2^19: all vertices and samples are exact
// in both places, and so are their differences.
constexpr double kStep = 0x1p-5;
constexpr double kFarAway = 0x1p18;

Scene<float> GradientScene(const std::string& name, double corner) {
  Scene<float> scene{.name = "gradient:" + name, .loop = Loop::kOneTriangle};
  const auto at = [corner](double i, double j) {
    return Point<float>{static_cast<float>(corner + i * kStep),
                        static_cast<float>(corner + j * kStep)};
  };
  scene.Add(Triangle<float>{at(3, 5), at(45, 9), at(17, 44)});
  for (std::size_t j = 0; j < kSamples; ++j) {
    for (std::size_t i = 0; i < kSamples; ++i) {
      scene.Add(at(static_cast<double>(i), static_cast<double>(j)));
    }
  }
  scene.calls = {{0, 0, kSamples * kSamples}};
  return scene;
}

json Gradient(const Kernel& kernel, const Scene<float>& scene,
              const std::string& name) {
  const Answers<float> answers = Run(kernel, scene);
  Bits weights;
  for (std::size_t i = 0; i < kSamples * kSamples; ++i) {
    for (const auto& w : answers.weights) {
      std::uint32_t bits = 0;
      std::memcpy(&bits, &w[0][i], sizeof(bits));
      for (int shift = 0; shift < 32; shift += 8) {
        weights.push_back(static_cast<std::uint8_t>(bits >> shift));
      }
    }
  }
  const Triangle<float> t = scene.TriangleAt(0);
  json gradient = Named(kernel);
  gradient.update({{"scene", name},
                   {"width", kSamples},
                   {"height", kSamples},
                   {"a", Hex(t.a)},
                   {"b", Hex(t.b)},
                   {"c", Hex(t.c)},
                   {"x0", Hex(static_cast<double>(scene.px[0]))},
                   {"y0", Hex(static_cast<double>(scene.py[0]))},
                   {"step", Hex(kStep)},
                   {"weights", Base64(weights)},
                   {"inside", Base64(answers.bits[0])}});
  return gradient;
}

}  // namespace

json MakeMaps(const NameFilter& filter) {
  const auto wanted = [&filter](const Kernel& kernel, const std::string& name) {
    return filter.Finds(CellName(kernel, name));
  };
  json ulp_maps = json::array();
  for (const Kernel* kernel :
       WidestKernels(AllKernels(), Loop::kOneTriangle, Output::kInside)) {
    if (!IsFloat(kernel->scalar) || !wanted(*kernel, "ulp_map")) continue;
    ulp_maps.push_back(kernel->scalar == Scalar::kF32
                           ? UlpMap<float>(*kernel)
                           : UlpMap<double>(*kernel));
  }
  json gradients = json::array();
  for (const auto& [name, corner] :
       {std::pair<std::string, double>{"near_origin", 0},
        {"far_away", kFarAway}}) {
    const Scene<float> scene = GradientScene(name, corner);
    for (const Kernel* kernel :
         WidestKernels(AllKernels(), Loop::kOneTriangle, Output::kWeights)) {
      if (kernel->scalar != Scalar::kF32 || !wanted(*kernel, scene.name)) {
        continue;
      }
      gradients.push_back(Gradient(*kernel, scene, name));
    }
  }
  return {{"ulp_maps", std::move(ulp_maps)},
          {"gradients", std::move(gradients)}};
}

}  // namespace pitbench
