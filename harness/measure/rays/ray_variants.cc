#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "harness/measure/rays/ray_details.h"

namespace pitbench {
namespace {

constexpr int kScale = 20;

template <class T>
constexpr std::array<Points3<T> RayScene<T>::*, 3> kVertices = {
    &RayScene<T>::a, &RayScene<T>::b, &RayScene<T>::c};
template <class T>
constexpr std::array<Points3<T> RayScene<T>::*, 2> kOfRay = {
    &RayScene<T>::origin, &RayScene<T>::direction};
template <class T>
constexpr std::array<Array<T> Points3<T>::*, 3> kAxes = {
    &Points3<T>::x, &Points3<T>::y, &Points3<T>::z};

// The first kExamined answers, with no more of the arrays than they read.
template <class T>
RayScene<T> Beginning(const RayScene<T>& scene) {
  RayScene<T> begun{};
  begun.name = scene.name;
  begun.loop = scene.loop;
  begun.t_min = scene.t_min;
  begun.t_max = scene.t_max;
  std::size_t triangles = 0;
  std::size_t rays = 0;
  std::size_t left = kExamined;
  for (RayCall call : scene.calls) {
    if (left == 0) break;
    call.n = std::min(call.n, left);
    left -= call.n;
    const bool one_triangle = scene.loop == RayLoop::kOneTriangleRays;
    const bool one_ray = scene.loop == RayLoop::kOneRay;
    triangles =
        std::max(triangles, call.triangle + (one_triangle ? 1 : call.n));
    rays = std::max(rays, call.ray + (one_ray ? 1 : call.n));
    begun.calls.push_back(call);
  }
  const auto copy = [&](auto members, std::size_t n) {
    for (const auto member : members) {
      for (const auto axis : kAxes<T>) {
        const Array<T>& from = scene.*member.*axis;
        (begun.*member.*axis)
            .assign(from.begin(),
                    from.begin() + static_cast<std::ptrdiff_t>(n));
      }
    }
  };
  copy(kVertices<T>, triangles);
  copy(kOfRay<T>, rays);
  return begun;
}

// Calls visit(x) for every coordinate of triangles, origins and directions.
template <class SceneType, class Visit>
void EachCoordinate(SceneType& scene, Visit visit) {
  for (auto* points :
       {&scene.a, &scene.b, &scene.c, &scene.origin, &scene.direction}) {
    for (auto* axis : {&points->x, &points->y, &points->z}) {
      for (auto& x : *axis) visit(x);
    }
  }
}

// The scene times 2^exponent, t and all, if that only moves exponents: u and v
// stay, and so does t, the direction being as much longer.
template <class T>
std::optional<RayScene<T>> Scaled(const RayScene<T>& scene, int exponent) {
  bool fits = true;
  EachCoordinate(scene, [&](T x) {
    if (x == 0 || !std::isfinite(x)) return;
    fits = fits && std::isnormal(x) && std::isnormal(std::ldexp(x, exponent));
  });
  if (!fits) return std::nullopt;
  RayScene<T> scaled = scene;
  EachCoordinate(scaled, [&](T& x) { x = std::ldexp(x, exponent); });
  return scaled;
}

// NaN, +∞ and −∞ in turn put into one coordinate after the other, of every
// second triangle and of every second ray.
template <class T>
RayScene<T> WithoutFiniteness(RayScene<T> scene) {
  using Limits = std::numeric_limits<T>;
  constexpr std::array<T, 3> kValues = {Limits::quiet_NaN(), Limits::infinity(),
                                        -Limits::infinity()};
  const auto spoil = [&](auto members, std::size_t first) {
    const std::size_t count = 3 * members.size();
    const std::size_t n = (scene.*members[0]).size();
    for (std::size_t i = first; i < n; i += 2) {
      const std::size_t k = i / 2 % count;
      (scene.*members[k / 3].*kAxes<T>[k % 3])[i] =
          kValues[i / (2 * count) % 3];
    }
  };
  spoil(kVertices<T>, 0);
  spoil(kOfRay<T>, 1);
  return scene;
}

}  // namespace

template <class T>
Variants<RayScene<T>> MakeVariants(const RayScene<T>& scene,
                                   const SceneTruth& truth) {
  Variants<RayScene<T>> variants;
  const RayScene<T> begun = Beginning(scene);
  for (std::size_t c = 0; c < begun.calls.size(); ++c) {
    ForEachAnswer(scene, scene.calls[c], truth.calls[c].strict,
                  [&](std::size_t i) {
                    if (i < begun.calls[c].n) ++variants.of;
                  });
  }
  RayScene<T> reversed = begun;
  std::swap(reversed.b, reversed.c);
  RayScene<T> rotated = reversed;  // (A, C, B)
  std::swap(rotated.a, rotated.c);
  RayScene<T> swapped = begun;
  std::swap(swapped.a, swapped.b);
  variants.changed.emplace_back("reversed_winding", std::move(reversed));
  variants.changed.emplace_back("rotated_vertices", std::move(rotated));
  variants.changed.emplace_back("swapped_vertices", std::move(swapped));
  RayScene<T> negated = begun;
  EachCoordinate(negated, [](T& x) { x = -x; });
  variants.changed.emplace_back("negated", std::move(negated));
  std::optional<RayScene<T>> scaled = Scaled(begun, kScale);
  if (!scaled) scaled = Scaled(begun, -kScale);
  if (scaled) {
    variants.changed.emplace_back("scaled_by_power_of_two", std::move(*scaled));
  }
  if (truth.not_finite == 0) {
    variants.not_finite = WithoutFiniteness(begun);
    for (const RayCall& call : begun.calls) {
      Bits& bits = variants.not_finite_bits.emplace_back(BitBytes(call.n));
      for (std::size_t i = 0; i < call.n; ++i) {
        if (IsFinite(variants.not_finite->TriangleOf(call, i),
                     variants.not_finite->RayOf(call, i))) {
          continue;
        }
        SetBit(bits, i);
        ++variants.not_finite_of;
      }
    }
  }
  return variants;
}

template Variants<RayScene<float>> MakeVariants(const RayScene<float>&,
                                                const SceneTruth&);
template Variants<RayScene<double>> MakeVariants(const RayScene<double>&,
                                                 const SceneTruth&);

}  // namespace pitbench
