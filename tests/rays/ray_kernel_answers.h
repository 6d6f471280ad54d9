// Ray kernels as the tests see them: which run here, and what they say of every
// ray of a list and every triangle of another.
#ifndef PITBENCH_TESTS_RAYS_RAY_KERNEL_ANSWERS_H_
#define PITBENCH_TESTS_RAYS_RAY_KERNEL_ANSWERS_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <vector>

#include "harness/scenes/rays/ray_scene.h"
#include "harness/truth/ray_truth.h"
#include "kernels/rays/ray_kernels.h"
#include "tests/kernel_answers.h"

namespace pitbench {

template <class Predicate>
std::vector<const RayKernel*> RayKernelsWhere(Predicate wanted) {
  return ThoseThatRun(AllRayKernels(), wanted);
}
inline std::vector<const RayKernel*> EveryRayKernel() {
  return RayKernelsWhere([](const RayKernel&) { return true; });
}

template <class T>
struct RayAnswer {
  bool hit = false;
  std::array<T, 3> tuv = {};  // where the kernel writes them
};

// For each call of the scene what the kernel answers. A kernel that writes the
// nearest triangle alone answers for that one, with its t.
template <class T>
std::vector<std::vector<RayAnswer<T>>> AskRays(const RayKernel& kernel,
                                               const RayScene<T>& scene) {
  std::vector<std::vector<RayAnswer<T>>> answers;
  for (const RayCall& call : scene.calls) {
    std::vector<RayAnswer<T>>& of_call = answers.emplace_back(call.n);
    std::vector<std::uint8_t> bits(BitBytes(call.n));
    std::array<std::vector<T>, 3> tuv;
    for (std::vector<T>& values : tuv) values.resize(call.n + 1);
    std::size_t nearest = 0;
    FunctionOf<T>(kernel)(scene.BatchOf(call), {.bits = bits.data(),
                                                .t = tuv[0].data(),
                                                .u = tuv[1].data(),
                                                .v = tuv[2].data(),
                                                .nearest = &nearest});
    if (kernel.output == RayOutput::kNearest) {
      if (nearest != kNoTriangle) of_call.at(nearest) = {true, {tuv[0][0]}};
      continue;
    }
    for (std::size_t i = 0; i < call.n; ++i) {
      of_call[i] = {(bits[i / 8] >> (i % 8) & 1) != 0,
                    {tuv[0][i], tuv[1][i], tuv[2][i]}};
    }
  }
  return answers;
}

// The scene in which a kernel of that loop is asked of every triangle and every
// ray of those given, the rays' ranges being one.
template <class T>
RayScene<T> SceneOfAll(RayLoop loop, const std::vector<Triangle3<T>>& triangles,
                       const std::vector<Ray<T>>& rays) {
  RayScene<T> scene{.name = "", .loop = loop};
  scene.t_min = rays.at(0).t_min;
  scene.t_max = rays.at(0).t_max;
  if (loop == RayLoop::kRayPairs) {
    for (const Triangle3<T>& t : triangles) {
      for (const Ray<T>& r : rays) {
        scene.Add(t);
        scene.AddRay(r.origin, r.direction);
      }
    }
    scene.calls.push_back({0, 0, triangles.size() * rays.size()});
    return scene;
  }
  for (const Triangle3<T>& t : triangles) scene.Add(t);
  for (const Ray<T>& r : rays) scene.AddRay(r.origin, r.direction);
  if (loop == RayLoop::kOneRay) {
    for (std::size_t r = 0; r < rays.size(); ++r) {
      scene.calls.push_back({0, r, triangles.size()});
    }
  } else {
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      scene.calls.push_back({t, 0, rays.size()});
    }
  }
  return scene;
}

// Calls test(triangle, ray, answer) for all that the kernel says of a scene.
template <class T, class Test>
void ForEachAnswer(const RayKernel& kernel, const RayScene<T>& scene,
                   const Test& test) {
  const auto answers = AskRays(kernel, scene);
  for (std::size_t c = 0; c < scene.calls.size(); ++c) {
    const RayCall& call = scene.calls[c];
    for (std::size_t i = 0; i < call.n; ++i) {
      test(scene.TriangleOf(call, i), scene.RayOf(call, i), answers[c][i]);
    }
  }
}

// Whether a kernel hits, of any loop.
template <class T>
bool Hits(const RayKernel& kernel, const Triangle3<T>& triangle,
          const Ray<T>& ray) {
  return AskRays(kernel, SceneOfAll<T>(kernel.loop, {triangle}, {ray}))[0][0]
      .hit;
}

// For messages: coordinates as hexadecimal floats.
template <class T>
std::ostream& operator<<(std::ostream& out, const Point3<T>& p) {
  return out << std::hexfloat << "(" << p.x << ", " << p.y << ", " << p.z << ")"
             << std::defaultfloat;
}
template <class T>
std::ostream& operator<<(std::ostream& out, const Triangle3<T>& t) {
  return out << t.a << " " << t.b << " " << t.c;
}
template <class T>
std::ostream& operator<<(std::ostream& out, const Ray<T>& r) {
  return out << "from " << r.origin << " along " << r.direction << ", t from "
             << r.t_min << " to " << r.t_max;
}

}  // namespace pitbench

#endif  // PITBENCH_TESTS_RAYS_RAY_KERNEL_ANSWERS_H_
