// Kernels as the tests see them: which run here, what they are called, and
// what they say of every triangle of a list and every point of another.
#ifndef PITBENCH_TESTS_KERNEL_ANSWERS_H_
#define PITBENCH_TESTS_KERNEL_ANSWERS_H_

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "harness/scenes/scene.h"
#include "kernels/kernels.h"

namespace pitbench {

// Those of `all` kernels that run here and for which `wanted(kernel)` holds,
// but for the methods that are kept as a warning: those break the contract.
template <class K, class Predicate>
std::vector<const K*> ThoseThatRun(std::span<const K> all, Predicate wanted) {
  std::vector<const K*> found;
  for (const K& kernel : all) {
    if (!RunsHere(kernel.isa) || !kernel.method.warning.empty()) continue;
    if (wanted(kernel)) found.push_back(&kernel);
  }
  return found;
}

template <class Predicate>
std::vector<const Kernel*> KernelsWhere(Predicate wanted) {
  return ThoseThatRun(AllKernels(), wanted);
}

inline std::vector<const Kernel*> FloatKernels() {
  return KernelsWhere([](const Kernel& k) { return IsFloat(k.scalar); });
}

// Those that answer but do not write weights: the weights kernels' bits are
// held to theirs by kernel_contract_test.
inline std::vector<const Kernel*> FloatInsideKernels() {
  return KernelsWhere([](const Kernel& k) {
    return IsFloat(k.scalar) && k.output == Output::kInside;
  });
}

// "edge_function_f32_avx512_pairs"; of a Kernel or a RayKernel.
template <class K>
std::string NameOf(const K& kernel) {
  std::string name(kernel.method.key);
  name.append("_").append(Name(kernel.scalar));
  name.append("_").append(Name(kernel.isa));
  name.append("_").append(Name(kernel.loop, kernel.output));
  return name;
}

struct KernelName {
  template <class K>
  std::string operator()(const testing::TestParamInfo<const K*>& info) const {
    return NameOf(*info.param);
  }
};

// Calls test(T{}) with the kernel's scalar, which is f32 or f64.
template <class K, class Test>
void WithFloatOf(const K& kernel, const Test& test) {
  if (kernel.scalar == Scalar::kF32) {
    test(float{});
  } else {
    test(double{});
  }
}

// Whether the method takes a reciprocal of the area, which rounds even where
// every coordinate is a small integer.
inline bool DividesByArea(const Kernel& kernel) {
  return kernel.method.key.starts_with("barycentric_inverse") ||
         kernel.method.key.starts_with("uv_projection");
}

// Whether the method divides by how far edges reach along x.
inline bool DividesByRuns(const Kernel& kernel) {
  return kernel.method.key.starts_with("edge_slope");
}

// Whether the method promises to be right for every finite input.
inline bool IsExact(const Kernel& kernel) {
  return kernel.method.key.starts_with("exact");
}

template <class T>
constexpr std::array<T, 3> kNotFinite = {std::numeric_limits<T>::quiet_NaN(),
                                         std::numeric_limits<T>::infinity(),
                                         -std::numeric_limits<T>::infinity()};

// Answers for every triangle (row) and every point (column).
template <class T>
struct AnswerTable {
  std::size_t points;
  std::vector<bool> inside;
  std::array<std::vector<T>, 3> weights;  // empty if the kernel writes none

  std::size_t At(std::size_t triangle, std::size_t point) const {
    return triangle * points + point;
  }
  bool Inside(std::size_t triangle, std::size_t point) const {
    return inside[At(triangle, point)];
  }
};

// What the kernel, of any loop but grid, says of each triangle and each point.
template <class T>
AnswerTable<T> AskAll(const Kernel& kernel,
                      const std::vector<Triangle<T>>& triangles,
                      const std::vector<Point<T>>& points) {
  Scene<T> scene{.name = "", .loop = LoopOfScenes(kernel.loop)};
  if (kernel.loop == Loop::kPairs) {
    for (const Triangle<T>& t : triangles) {
      for (const Point<T>& p : points) {
        scene.Add(t);
        scene.Add(p);
      }
    }
    scene.calls.push_back({0, 0, scene.px.size()});
  } else {
    for (const Triangle<T>& t : triangles) scene.Add(t);
    for (const Point<T>& p : points) scene.Add(p);
    const bool one_triangle = scene.loop == Loop::kOneTriangle;
    const std::size_t calls = one_triangle ? triangles.size() : points.size();
    const std::size_t n = one_triangle ? points.size() : triangles.size();
    for (std::size_t k = 0; k < calls; ++k) {
      scene.calls.push_back({one_triangle ? k : 0, one_triangle ? 0 : k, n});
    }
  }
  AnswerTable<T> table{.points = points.size(), .inside = {}, .weights = {}};
  const std::size_t answers = triangles.size() * points.size();
  table.inside.resize(answers);
  const bool writes_weights = kernel.output == Output::kWeights;
  if (writes_weights) {
    for (std::vector<T>& w : table.weights) w.resize(answers);
  }
  const Array<T> xy = scene.PointsSideBySide();
  for (const Call& call : scene.calls) {
    std::vector<std::uint8_t> bits(BitBytes(call.n));
    std::array<std::vector<T>, 3> weights;
    Result<T> result{.bits = bits.data()};
    for (std::size_t k = 0; k < 3 && writes_weights; ++k) {
      weights[k].resize(call.n);
      result.w[k] = weights[k].data();
    }
    FunctionOf<T>(kernel)(scene.BatchOf(call, xy.data()), result);
    for (std::size_t i = 0; i < call.n; ++i) {
      // One_point: items are triangles, and so rows of the table.
      const std::size_t at = kernel.loop == Loop::kOnePoint
                                 ? table.At(i, call.point)
                                 : call.triangle * points.size() + i;
      table.inside[at] = (bits[i / 8] >> (i % 8) & 1) != 0;
      for (std::size_t k = 0; k < 3 && writes_weights; ++k) {
        table.weights[k][at] = weights[k][i];
      }
    }
  }
  return table;
}

template <class T>
bool Says(const Kernel& kernel, const Triangle<T>& t, const Point<T>& p) {
  return AskAll<T>(kernel, {t}, {p}).Inside(0, 0);
}

// For messages: coordinates as hexadecimal floats.
template <class T>
std::ostream& operator<<(std::ostream& out, const Point<T>& p) {
  return out << std::hexfloat << "(" << p.x << ", " << p.y << ")"
             << std::defaultfloat;
}
template <class T>
std::ostream& operator<<(std::ostream& out, const Triangle<T>& t) {
  return out << t.a << " " << t.b << " " << t.c;
}

// All points with whole coordinates from 0 to `last`.
template <class T>
std::vector<Point<T>> WholePoints(int last) {
  std::vector<Point<T>> points;
  for (int x = 0; x <= last; ++x) {
    for (int y = 0; y <= last; ++y) {
      points.push_back({static_cast<T>(x), static_cast<T>(y)});
    }
  }
  return points;
}

// All triangles with those vertices, degenerate ones and every order included.
template <class T>
std::vector<Triangle<T>> WholeTriangles(int last) {
  const std::vector<Point<T>> vertices = WholePoints<T>(last);
  std::vector<Triangle<T>> triangles;
  for (const Point<T>& a : vertices) {
    for (const Point<T>& b : vertices) {
      for (const Point<T>& c : vertices) triangles.push_back({a, b, c});
    }
  }
  return triangles;
}

}  // namespace pitbench

#endif  // PITBENCH_TESTS_KERNEL_ANSWERS_H_
