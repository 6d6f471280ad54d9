#include "harness/measure/variants.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>

namespace pitbench {
namespace {

constexpr int kScale = 20;  // 4 times this is within f32's range, for Gram

template <class T>
using Coordinates = std::array<Array<T> Scene<T>::*, 8>;

template <class T>
constexpr Coordinates<T> kCoordinates = {
    &Scene<T>::ax, &Scene<T>::ay, &Scene<T>::bx, &Scene<T>::by,
    &Scene<T>::cx, &Scene<T>::cy, &Scene<T>::px, &Scene<T>::py};
constexpr std::size_t kOfTriangle = 6;  // the first of them

// The first kExamined answers, with no more of the arrays than they read.
template <class T>
Scene<T> Beginning(const Scene<T>& scene) {
  Scene<T> begun{.name = scene.name,
                 .loop = scene.loop,
                 .width = scene.width,
                 .height = scene.height};
  const bool grid = scene.loop == Loop::kGrid;
  const std::size_t answers_an_item = grid ? scene.width * scene.height : 1;
  std::size_t triangles = 0;
  std::size_t points = 0;
  std::size_t left = std::max<std::size_t>(kExamined / answers_an_item, 1);
  for (Call call : scene.calls) {
    if (left == 0) break;
    call.n = std::min(call.n, left);
    left -= call.n;
    triangles = std::max(
        triangles,
        call.triangle + (scene.loop == Loop::kOneTriangle ? 1 : call.n));
    if (!grid) {
      points = std::max(
          points, call.point + (scene.loop == Loop::kOnePoint ? 1 : call.n));
    }
    begun.calls.push_back(call);
  }
  for (std::size_t k = 0; k < kCoordinates<T>.size(); ++k) {
    const Array<T>& from = scene.*kCoordinates<T>[k];
    const auto n =
        static_cast<std::ptrdiff_t>(k < kOfTriangle ? triangles : points);
    (begun.*kCoordinates<T>[k]).assign(from.begin(), from.begin() + n);
  }
  return begun;
}

template <class T, class Change>
Scene<T> EachCoordinate(Scene<T> scene, Change change) {
  for (const auto member : kCoordinates<T>) {
    for (T& x : scene.*member) x = change(x);
  }
  return scene;
}

// The scene times 2^exponent, if that only moves exponents.
template <class T>
std::optional<Scene<T>> Scaled(const Scene<T>& scene, int exponent) {
  for (const auto member : kCoordinates<T>) {
    for (const T x : scene.*member) {
      if (x == 0 || !std::isfinite(x)) continue;
      if (!std::isnormal(x) || !std::isnormal(std::ldexp(x, exponent))) {
        return std::nullopt;
      }
    }
  }
  return EachCoordinate(scene,
                        [exponent](T x) { return std::ldexp(x, exponent); });
}

template <class T>
Scene<T> WithoutFiniteness(Scene<T> scene) {
  using Limits = std::numeric_limits<T>;
  constexpr std::array<T, 3> kValues = {Limits::quiet_NaN(), Limits::infinity(),
                                        -Limits::infinity()};
  for (std::size_t i = 0; i < scene.ax.size(); i += 2) {
    (scene.*kCoordinates<T>[i / 2 % 6])[i] = kValues[i / 12 % 3];
  }
  for (std::size_t i = 1; i < scene.px.size(); i += 2) {
    (scene.*kCoordinates<T>[6 + i / 2 % 2])[i] = kValues[i / 4 % 3];
  }
  return scene;
}

}  // namespace

template <class T>
Variants<Scene<T>> MakeVariants(const Scene<T>& scene,
                                const SceneTruth& truth) {
  Variants<Scene<T>> variants;
  const Scene<T> begun = Beginning(scene);
  for (std::size_t c = 0; c < begun.calls.size(); ++c) {
    ForEachAnswer(scene, scene.calls[c], truth.calls[c].strict,
                  [&](std::size_t i) {
                    if (i < begun.Answers(begun.calls[c])) ++variants.of;
                  });
  }

  Scene<T> reversed = begun;
  std::swap(reversed.bx, reversed.cx);
  std::swap(reversed.by, reversed.cy);
  Scene<T> rotated = reversed;  // (A, C, B)
  std::swap(rotated.ax, rotated.cx);
  std::swap(rotated.ay, rotated.cy);
  Scene<T> swapped = begun;
  std::swap(swapped.ax, swapped.bx);
  std::swap(swapped.ay, swapped.by);
  variants.changed.emplace_back("reversed_winding", std::move(reversed));
  variants.changed.emplace_back("rotated_vertices", std::move(rotated));
  variants.changed.emplace_back("swapped_vertices", std::move(swapped));
  if (scene.loop != Loop::kGrid && std::is_signed_v<T>) {
    variants.changed.emplace_back("negated", EachCoordinate(begun, [](T x) {
                                    return static_cast<T>(-x);
                                  }));
  }
  if constexpr (std::floating_point<T>) {
    if (scene.loop != Loop::kGrid) {
      std::optional<Scene<T>> scaled = Scaled(begun, kScale);
      if (!scaled) scaled = Scaled(begun, -kScale);
      if (scaled) {
        variants.changed.emplace_back("scaled_by_power_of_two",
                                      std::move(*scaled));
      }
    }
    if (truth.not_finite == 0 && scene.loop != Loop::kGrid) {
      variants.not_finite = WithoutFiniteness(begun);
      for (const Call& call : begun.calls) {
        Bits& bits = variants.not_finite_bits.emplace_back(
            variants.not_finite->OutputBytes(call));
        for (std::size_t i = 0; i < call.n; ++i) {
          if (IsFinite(variants.not_finite->TriangleOf(call, i),
                       variants.not_finite->PointOf(call, i))) {
            continue;
          }
          SetBit(bits, i);
          ++variants.not_finite_of;
        }
      }
    }
  }
  return variants;
}

template Variants<Scene<float>> MakeVariants(const Scene<float>&,
                                             const SceneTruth&);
template Variants<Scene<double>> MakeVariants(const Scene<double>&,
                                              const SceneTruth&);
template Variants<Scene<std::int32_t>> MakeVariants(const Scene<std::int32_t>&,
                                                    const SceneTruth&);
template Variants<Scene<std::int16_t>> MakeVariants(const Scene<std::int16_t>&,
                                                    const SceneTruth&);
template Variants<Scene<std::uint8_t>> MakeVariants(const Scene<std::uint8_t>&,
                                                    const SceneTruth&);

}  // namespace pitbench
