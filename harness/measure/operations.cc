#include "harness/measure/operations.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

#include "harness/measure/answers.h"
#include "harness/measure/rays/ray_answers.h"
#include "harness/scenes/generate.h"
#include "harness/scenes/rays/ray_scene.h"
#include "harness/scenes/spec.h"

namespace pitbench {
namespace {

using counting::CurrentTape;
using counting::Kind;
using counting::kKinds;

// As many items as the longest stretch that any loop of f32 on AVX-512 works
// off at once, so that n and 2n items differ by whole ones. (The exact methods
// ask once in sixteen of them whether all are decided: counted of a call.)
constexpr std::size_t kItems = 128;
// The scenes below say so in their names.
static_assert(2 * kItems == 256);

// What one call on the first n items of the scene takes. K and S are a kernel
// and a scene of points or of rays.
template <class K, class S>
counting::Operations CountOf(const K& kernel, S scene, std::size_t n) {
  scene.calls.resize(1);
  if (n > scene.calls.front().n) {
    throw std::logic_error("a call of the scene has fewer items");
  }
  scene.calls.front().n = n;
  Answers<typename S::Coordinate> answers;
  CurrentTape().Clear();
  Run(kernel, scene, answers);
  const counting::Operations counts = CurrentTape().Count();
  CurrentTape().Clear();
  return counts;
}

template <class K, class S>
CountedKernel CountedOn(const K& kernel, const S& scene, std::size_t n) {
  const counting::Operations once = CountOf(kernel, scene, n);
  const counting::Operations twice = CountOf(kernel, scene, 2 * n);
  CountedKernel counted = {};
  for (std::size_t k = 0; k < kKinds; ++k) {
    const auto more =
        static_cast<double>(twice[k]) - static_cast<double>(once[k]);
    counted.per_item[k] = more / static_cast<double>(n);
    counted.per_call[k] = static_cast<double>(once[k]) - more;
  }
  return counted;
}

template <class T>
CountedKernel Counted(const Kernel& kernel) {
  const bool grid = kernel.loop == Loop::kGrid;
  const std::size_t n = grid ? 1 : kItems;
  const std::string_view name = grid ? "grid_80x50:sets=fixed"
                                : std::is_integral_v<T>
                                    ? "grid_points_80x50:sets=fixed"
                                    : "uniform:hit=50:n=256:sets=fixed";
  return CountedOn(kernel,
                   MakeScene<T>(ParseScene(name), kernel.loop,
                                {.groups = 1, .size = 2 * n}, kDefaultSeed),
                   n);
}

template <class T>
CountedKernel Counted(const RayKernel& kernel) {
  // What the exact methods do with a nearest hit depends on how many there are
  // on the way to it, and no bound may rest on that.
  const std::string_view name = kernel.loop == RayLoop::kOneRay
                                    ? "rays_uniform:hit=0:n=256:sets=fixed"
                                    : "rays_uniform:hit=50:n=256:sets=fixed";
  return CountedOn(
      kernel,
      MakeRayScene<T>(ParseScene(name), kernel.loop,
                      {.groups = 1, .size = 2 * kItems}, kDefaultSeed),
      kItems);
}

// Whole numbers are written as such.
nlohmann::json ByKind(const OperationCounts& counts) {
  nlohmann::json named = nlohmann::json::object();
  for (std::size_t k = 0; k < kKinds; ++k) {
    const std::string name(counting::Name(static_cast<Kind>(k)));
    if (counts[k] == std::floor(counts[k])) {
      named[name] = static_cast<std::int64_t>(counts[k]);
    } else {
      named[name] = counts[k];
    }
  }
  return named;
}

}  // namespace

CountedKernel CountOperations(const Kernel& kernel) {
  switch (kernel.scalar) {
    case Scalar::kF32:
      return Counted<float>(kernel);
    case Scalar::kF64:
      return Counted<double>(kernel);
    case Scalar::kI32:
      return Counted<std::int32_t>(kernel);
    case Scalar::kI16:
      return Counted<std::int16_t>(kernel);
    case Scalar::kU8:
      break;
  }
  return Counted<std::uint8_t>(kernel);
}

CountedKernel CountOperations(const RayKernel& kernel) {
  return kernel.scalar == Scalar::kF32 ? Counted<float>(kernel)
                                       : Counted<double>(kernel);
}

nlohmann::json OperationsOf(const NameFilter& filter) {
  nlohmann::json rows = nlohmann::json::array();
  const auto add = [&](const auto& kernels) {
    for (const auto& kernel : kernels) {
      const std::string loop(Name(kernel.loop, kernel.output));
      const std::string method(kernel.method.key);
      const std::string scalar(Name(kernel.scalar));
      std::string name = loop;
      name.append("/").append(method).append("/").append(scalar);
      if (!filter.Finds(name)) continue;
      const CountedKernel counted = CountOperations(kernel);
      rows.push_back({{"method", method},
                      {"scalar", scalar},
                      {"loop", loop},
                      {"per_call", ByKind(counted.per_call)},
                      {"per_item", ByKind(counted.per_item)}});
    }
  };
  add(CountingKernels());
  add(CountingRayKernels());
  return {{"schema", "operations-1"}, {"rows", rows}};
}

}  // namespace pitbench
