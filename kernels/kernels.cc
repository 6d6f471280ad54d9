#include "kernels/kernels.h"

#include <hwy/targets.h>

#include <cstdint>

#if HWY_ARCH_ARM_A64
#include <sys/auxv.h>
#endif

namespace pitbench {

#define PITBENCH_KERNEL Kernel
#define PITBENCH_FUNCTION(key) key
#define PITBENCH_METHODS "kernels/methods.inc"
#include "kernels/join_kernels.inc"

namespace {

#if HWY_ARCH_X86
bool HighwayRuns(std::int64_t target) {
  return (hwy::SupportedTargets() & target) != 0;
}
#endif

constexpr bool kAll =
#if defined(PITBENCH_FEWER_KERNELS)
    false;
#else
    true;
#endif

bool AskCpu(Isa isa) {
  switch (isa) {
    case Isa::kScalar:
      return true;
#if HWY_ARCH_X86
    case Isa::kAutovecV2:
      return kAll && __builtin_cpu_supports("x86-64-v2") != 0;
    case Isa::kAutovecV3:
      return __builtin_cpu_supports("x86-64-v3") != 0;
    case Isa::kAutovecV4:
      return kAll && __builtin_cpu_supports("x86-64-v4") != 0;
    case Isa::kSsse3:
      return HighwayRuns(HWY_SSSE3);
    case Isa::kSse4:
      return kAll && HighwayRuns(HWY_SSE4);
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
    case Isa::kLibrary:
      return true;
    default:
      return false;
  }
}

// Bit k: the ISA of value k.
std::uint32_t AskCpuOfAll() {
  std::uint32_t runs = 0;
  for (int k = 0; k <= static_cast<int>(Isa::kCounting); ++k) {
    if (AskCpu(static_cast<Isa>(k))) runs |= std::uint32_t{1} << k;
  }
  return runs;
}

}  // namespace

std::span<const Kernel> AllKernels() {
  static const std::vector<Kernel> all = JoinKernels();
  return all;
}

bool RunsHere(Isa isa) {
  static const std::uint32_t runs = AskCpuOfAll();
  return (runs >> static_cast<unsigned>(isa) & 1) != 0;
}

std::string_view Name(Scalar scalar) {
  switch (scalar) {
    case Scalar::kF32:
      return "f32";
    case Scalar::kF64:
      return "f64";
    case Scalar::kI32:
      return "i32";
    case Scalar::kI16:
      return "i16";
    case Scalar::kU8:
      return "u8";
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
    case Isa::kCounting:
      return "counting";
    case Isa::kLibrary:
      return "library";
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
    case Loop::kOneTriangleAos:
      return "one_triangle_aos";
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
    case Boundary::kBottomLeft:
      return "bottom_left";
    case Boundary::kPerturbed:
      return "perturbed";
  }
  return "?";
}

std::string_view Name(Accepts accepts) {
  return accepts == Accepts::kTriangle ? "triangle" : "third_near_vertex_a";
}

}  // namespace pitbench
