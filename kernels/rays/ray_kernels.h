// Every ray-triangle kernel of pitbench, and what each declares of itself.
//
// A ray starts at O and goes along D; it meets the triangle ABC at
//   O + t·D = (1 − u − v)·A + u·B + v·C,   t_min ≤ t ≤ t_max.
// The contract that all of them keep is in kernels/rays/README.md.
#ifndef PITBENCH_KERNELS_RAYS_RAY_KERNELS_H_
#define PITBENCH_KERNELS_RAYS_RAY_KERNELS_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "kernels/kernels.h"

namespace pitbench {

// The shape of the work: which side is batched.
enum class RayLoop {
  kOneTriangleRays,  // triangle 0 against n rays
  kOneRay,           // ray 0 against n triangles: the nearest hit
  kRayPairs,         // ray i against triangle i
};

enum class RayOutput {
  kHits,     // a bit an answer
  kTuv,      // and t, u, v of each
  kNearest,  // loop one_ray alone: which triangle, and its t
};

// What a ray method declares of itself. Boundary and warning are those of the
// 2D methods; a method that is not closed says in its file what it is.
struct RayMethod {
  std::string_view key;      // e.g. "moller_trumbore"
  std::string_view source;   // where the formula comes from
  std::string_view formula;  // what is computed for a ray
  Boundary boundary = Boundary::kClosed;
  bool fma = false;  // multiply-adds are contracted
  // Hits only where the triangle's vertices go counter-clockwise as seen from
  // the ray's origin: where D·((B − A)×(C − A)) < 0.
  bool culls_backface = false;
  // What is wrong with the method, where it is kept as a warning and may break
  // the contract; empty for all others.
  std::string_view warning = "";
};

// A point or a direction as three arrays.
template <class T>
struct Xyz {
  const T* x;
  const T* y;
  const T* z;
};

// The arrays that a kernel reads. Each loop reads as many elements of each as
// enum RayLoop says and none past them; the arrays need no alignment.
template <class T>
struct RayBatch {
  Xyz<T> a;  // triangles
  Xyz<T> b;
  Xyz<T> c;
  Xyz<T> origin;  // rays
  Xyz<T> direction;
  std::size_t n;
  T t_min;
  T t_max;
};

inline constexpr std::size_t kNoTriangle = ~std::size_t{0};

// What a kernel writes.
//   kHits:     `bits`, BitBytes(n) bytes: one bit an answer, least significant
//              first; bits past the last answer are 0.
//   kTuv:      the same, and t, u, v: n values each, NaN where there is no hit.
//   kNearest:  `nearest`, the index of the triangle with the least t among
//              those hit, the lowest index if several have it, or kNoTriangle;
//              and t[0], NaN then. Nothing else.
template <class T>
struct RayResult {
  std::uint8_t* bits = nullptr;
  T* t = nullptr;
  T* u = nullptr;
  T* v = nullptr;
  std::size_t* nearest = nullptr;
};

template <class T>
using RayFunction = void (*)(const RayBatch<T>&, const RayResult<T>&);

struct RayKernel {
  RayMethod method;
  Scalar scalar;
  Isa isa;
  RayLoop loop;
  RayOutput output;
  // The one that matches `scalar` is set.
  RayFunction<float> f32 = nullptr;
  RayFunction<double> f64 = nullptr;
};

// The function of a kernel whose scalar is T.
template <class T>
constexpr RayFunction<T> FunctionOf(const RayKernel& kernel) {
  if constexpr (std::is_same_v<T, float>) {
    return kernel.f32;
  } else {
    static_assert(std::is_same_v<T, double>);
    return kernel.f64;
  }
}

// Every kernel that was compiled, whether or not this CPU can run it; ordered
// by method (as in methods.inc), ISA, scalar, loop, output.
std::span<const RayKernel> AllRayKernels();

// "one_triangle_rays", "one_ray" or "ray_pairs"; of a kernel that writes t, u
// and v with "_tuv" behind it.
std::string_view Name(RayLoop loop, RayOutput output = RayOutput::kHits);

}  // namespace pitbench

#endif  // PITBENCH_KERNELS_RAYS_RAY_KERNELS_H_
