// Every point-in-triangle kernel of pitbench, and what each declares of itself.
//
// A kernel is one method × scalar × ISA × loop behind one function pointer.
// The contract that all of them keep is in kernels/README.md.
#ifndef PITBENCH_KERNELS_KERNELS_H_
#define PITBENCH_KERNELS_KERNELS_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

namespace pitbench {

enum class Scalar { kF32, kF64, kI32, kI16, kU8 };

// What a kernel was compiled for, narrowest first.
enum class Isa {
  kScalar,
  kAutovecV2,
  kAutovecV3,
  kAutovecV4,
  kSsse3,
  kSse4,
  kAvx2,
  kAvx512,
  kNeon,
  kSve,
  kSve2,
  kLibrary,   // none of ours: a call into another library, see peers/
  kCounting,  // in kernels/counting alone: counts its operations, never timed
};

// The shape of the work: which side is batched.
enum class Loop {
  kOneTriangle,     // triangle 0 against n points
  kOnePoint,        // point 0 against n triangles
  kPairs,           // point i against triangle i
  kOneTriangleAos,  // kOneTriangle with x and y of each point side by side
  kGrid,  // n triangles, each against every pixel of a width × height
          // grid whose pixel (column x, row y) is the point (x, y)
};

enum class Output { kInside, kWeights };

// Which points of the triangle's boundary count as inside.
enum class Boundary {
  kClosed,    // all of them
  kOpen,      // none
  kHalfOpen,  // those of edges AB and AC, without B and C; not those of BC
  kTopLeft,   // those of top and of left edges, so that of the triangles around
              // an edge or a vertex exactly one contains it. With y upwards: a
              // left edge has the triangle on its right, a top edge is
              // horizontal and has the triangle below.
  kBottomLeft,  // the same with bottom edges in the place of top edges
  kPerturbed,   // rays alone: those that a ray hits which is turned a little,
                // all rays in one way; of the triangles of a closed surface
                // that meet in an edge or a vertex, one a crossing
};

// The part of the triangle that a method accepts.
enum class Accepts {
  kTriangle,          // all of it
  kThirdNearVertexA,  // only where w_a ≥ w_b and w_a ≥ w_c
};

// What a method declares of itself; the harness holds it to this.
struct Method {
  std::string_view key;      // e.g. "cross_product"
  std::string_view source;   // where the formula comes from
  std::string_view formula;  // what is computed for a point
  Boundary boundary = Boundary::kClosed;
  Accepts accepts = Accepts::kTriangle;
  bool fma = false;  // multiply-adds are contracted
  // Accepts points outside as well, while no cross product of an edge with the
  // way from it to the point is further below 0 than this.
  double tolerance = 0;
  // Answers may be wrong within this distance of the boundary, along x and
  // along y, in sides of the triangle's bounding box.
  double snap_distance = 0;
  // Accepts points outside as well, within this distance of the boundary along
  // x or along y, as what draws an outline does.
  double edge_width = 0;
  // Must not be asked about NaN and infinity.
  bool finite_only = false;
  // What is wrong with the method, where it is kept as a warning and may break
  // the contract; empty for all others.
  std::string_view warning = "";
};

// The arrays that a kernel reads. Each loop reads as many elements of each as
// enum Loop says and none past them; the arrays need no alignment.
template <class T>
struct Batch {
  const T* ax;  // triangles, vertex A
  const T* ay;
  const T* bx;
  const T* by;
  const T* cx;
  const T* cy;
  const T* px;  // points; unused (may be null) in loops grid and
  const T* py;  // one_triangle_aos
  std::size_t n;
  std::size_t width = 0;  // loop grid only, in pixels
  std::size_t height = 0;
  const T* pxy = nullptr;  // loop one_triangle_aos only: x, y, x, y, … of the
                           // points, 2n elements
};

// What a kernel writes. `bits`: one bit a result, least significant first,
// bits past the last result are 0.
//   one_triangle, one_triangle_aos, one_point, pairs: BitBytes(n) bytes.
//   grid: n · height rows of BitBytes(width) bytes, triangle by triangle.
// `w`: the barycentric weights of A, B and C, n values each, only where the
// kernel's output is kWeights; NaN where the triangle is degenerate.
template <class T>
struct Result {
  std::uint8_t* bits;
  T* w[3] = {nullptr, nullptr, nullptr};
};

constexpr std::size_t BitBytes(std::size_t n) { return (n + 7) / 8; }

template <class T>
using KernelFunction = void (*)(const Batch<T>&, const Result<T>&);

struct Kernel {
  Method method;
  Scalar scalar;
  Isa isa;
  Loop loop;
  Output output;
  // The one that matches `scalar` is set.
  KernelFunction<float> f32 = nullptr;
  KernelFunction<double> f64 = nullptr;
  KernelFunction<std::int32_t> i32 = nullptr;
  KernelFunction<std::int16_t> i16 = nullptr;
  KernelFunction<std::uint8_t> u8 = nullptr;
};

template <class T>
constexpr Scalar ScalarOf() {
  if constexpr (std::is_same_v<T, float>) {
    return Scalar::kF32;
  } else if constexpr (std::is_same_v<T, double>) {
    return Scalar::kF64;
  } else if constexpr (std::is_same_v<T, std::int32_t>) {
    return Scalar::kI32;
  } else if constexpr (std::is_same_v<T, std::int16_t>) {
    return Scalar::kI16;
  } else {
    static_assert(std::is_same_v<T, std::uint8_t>);
    return Scalar::kU8;
  }
}

constexpr bool IsFloat(Scalar scalar) {
  return scalar == Scalar::kF32 || scalar == Scalar::kF64;
}

// The function of a kernel whose scalar is T.
template <class T>
constexpr KernelFunction<T> FunctionOf(const Kernel& kernel) {
  if constexpr (std::is_same_v<T, float>) {
    return kernel.f32;
  } else if constexpr (std::is_same_v<T, double>) {
    return kernel.f64;
  } else if constexpr (std::is_same_v<T, std::int32_t>) {
    return kernel.i32;
  } else if constexpr (std::is_same_v<T, std::int16_t>) {
    return kernel.i16;
  } else {
    static_assert(std::is_same_v<T, std::uint8_t>);
    return kernel.u8;
  }
}

// Every kernel that was compiled, whether or not this CPU can run it; ordered
// by method (as in methods.inc), ISA, scalar, loop, output.
std::span<const Kernel> AllKernels();

// Whether this CPU and operating system can run code compiled for `isa`, and
// the build has some. Asks the CPU once, at the first call.
bool RunsHere(Isa isa);

std::string_view Name(Scalar scalar);
std::string_view Name(Isa isa);
// "one_triangle", or "one_triangle_weights" for a kernel that writes weights.
std::string_view Name(Loop loop, Output output = Output::kInside);
std::string_view Name(Boundary boundary);
std::string_view Name(Accepts accepts);

}  // namespace pitbench

#endif  // PITBENCH_KERNELS_KERNELS_H_
