#include "kernels/kernels.h"

#include <hwy/targets.h>

#if HWY_ARCH_ARM_A64
#include <sys/auxv.h>
#endif

namespace pitbench {

// What the method files export, ISA by ISA.
#define PITBENCH_METHOD(key) std::span<const Kernel> key();
#define PITBENCH_METHOD_AUTOVEC(key) PITBENCH_METHOD(key)
#define PITBENCH_METHOD_FAST_MATH(key)
namespace scalar {
#include "kernels/methods.inc"
}
#if HWY_ARCH_X86
namespace ssse3 {
#include "kernels/methods.inc"
}
namespace sse4 {
#include "kernels/methods.inc"
}
namespace avx2 {
#include "kernels/methods.inc"
}
namespace avx512 {
#include "kernels/methods.inc"
}
#elif HWY_ARCH_ARM_A64
namespace neon {
#include "kernels/methods.inc"
}
namespace sve {
#include "kernels/methods.inc"
}
namespace sve2 {
#include "kernels/methods.inc"
}
#endif
#undef PITBENCH_METHOD
#if HWY_ARCH_X86
#define PITBENCH_METHOD(key)
namespace autovec_v2 {
#undef PITBENCH_METHOD_AUTOVEC
#define PITBENCH_METHOD_AUTOVEC(key) std::span<const Kernel> key();
#include "kernels/methods.inc"
}  // namespace autovec_v2
namespace autovec_v3 {
#undef PITBENCH_METHOD_FAST_MATH
#define PITBENCH_METHOD_FAST_MATH(key) std::span<const Kernel> key();
#include "kernels/methods.inc"
#undef PITBENCH_METHOD_FAST_MATH
#define PITBENCH_METHOD_FAST_MATH(key)
}  // namespace autovec_v3
namespace autovec_v4 {
#include "kernels/methods.inc"
}
#undef PITBENCH_METHOD
#endif
#undef PITBENCH_METHOD_AUTOVEC
#undef PITBENCH_METHOD_FAST_MATH

namespace {

std::vector<Kernel> JoinKernels() {
  std::vector<Kernel> all;
  const auto add = [&all](std::span<const Kernel> rows) {
    all.insert(all.end(), rows.begin(), rows.end());
  };
#if HWY_ARCH_X86
#define PITBENCH_METHOD(key) \
  add(scalar::key());        \
  PITBENCH_X86_SIMD(key)
#define PITBENCH_METHOD_AUTOVEC(key) \
  add(scalar::key());                \
  add(autovec_v2::key());            \
  add(autovec_v3::key());            \
  add(autovec_v4::key());            \
  PITBENCH_X86_SIMD(key)
#define PITBENCH_METHOD_FAST_MATH(key) add(autovec_v3::key());
#define PITBENCH_X86_SIMD(key) \
  add(ssse3::key());           \
  add(sse4::key());            \
  add(avx2::key());            \
  add(avx512::key());
#elif HWY_ARCH_ARM_A64
#define PITBENCH_METHOD(key) \
  add(scalar::key());        \
  add(neon::key());          \
  add(sve::key());           \
  add(sve2::key());
#define PITBENCH_METHOD_AUTOVEC(key) PITBENCH_METHOD(key)
#define PITBENCH_METHOD_FAST_MATH(key)
#endif
#include "kernels/methods.inc"
  return all;
}

#if HWY_ARCH_X86
bool HighwayRuns(std::int64_t target) {
  return (hwy::SupportedTargets() & target) != 0;
}
#endif

}  // namespace

std::span<const Kernel> AllKernels() {
  static const std::vector<Kernel> all = JoinKernels();
  return all;
}

bool RunsHere(Isa isa) {
  switch (isa) {
    case Isa::kScalar:
      return true;
#if HWY_ARCH_X86
    case Isa::kAutovecV2:
      return __builtin_cpu_supports("x86-64-v2") != 0;
    case Isa::kAutovecV3:
      return __builtin_cpu_supports("x86-64-v3") != 0;
    case Isa::kAutovecV4:
      return __builtin_cpu_supports("x86-64-v4") != 0;
    case Isa::kSsse3:
      return HighwayRuns(HWY_SSSE3);
    case Isa::kSse4:
      return HighwayRuns(HWY_SSE4);
    case Isa::kAvx2:
      return HighwayRuns(HWY_AVX2);
    case Isa::kAvx512:
      return HighwayRuns(HWY_AVX3);
#elif HWY_ARCH_ARM_A64
    case Isa::kNeon:
      return true;
    case Isa::kSve:
      return (getauxval(AT_HWCAP) & HWCAP_SVE) != 0;
    case Isa::kSve2:
      return (getauxval(AT_HWCAP2) & HWCAP2_SVE2) != 0;
#endif
    default:
      return false;
  }
}

std::string_view Name(Scalar scalar) {
  switch (scalar) {
    case Scalar::kF32:
      return "f32";
    case Scalar::kF64:
      return "f64";
    case Scalar::kI32:
      return "i32";
  }
  return "?";
}

std::string_view Name(Isa isa) {
  switch (isa) {
    case Isa::kScalar:
      return "scalar";
    case Isa::kAutovecV2:
      return "autovec_v2";
    case Isa::kAutovecV3:
      return "autovec_v3";
    case Isa::kAutovecV4:
      return "autovec_v4";
    case Isa::kSsse3:
      return "ssse3";
    case Isa::kSse4:
      return "sse4";
    case Isa::kAvx2:
      return "avx2";
    case Isa::kAvx512:
      return "avx512";
    case Isa::kNeon:
      return "neon";
    case Isa::kSve:
      return "sve";
    case Isa::kSve2:
      return "sve2";
  }
  return "?";
}

std::string_view Name(Loop loop, Output output) {
  const bool weights = output == Output::kWeights;
  switch (loop) {
    case Loop::kOneTriangle:
      return weights ? "one_triangle_weights" : "one_triangle";
    case Loop::kOnePoint:
      return weights ? "one_point_weights" : "one_point";
    case Loop::kPairs:
      return weights ? "pairs_weights" : "pairs";
    case Loop::kGrid:
      return "grid";
  }
  return "?";
}

std::string_view Name(Boundary boundary) {
  switch (boundary) {
    case Boundary::kClosed:
      return "closed";
    case Boundary::kOpen:
      return "open";
    case Boundary::kHalfOpen:
      return "half_open";
    case Boundary::kTopLeft:
      return "top_left";
  }
  return "?";
}

std::string_view Name(Accepts accepts) {
  return accepts == Accepts::kTriangle ? "triangle" : "third_near_vertex_a";
}

}  // namespace pitbench
