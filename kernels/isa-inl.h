// Names the ISA that this pass over the file is compiled for.
//
// PITBENCH_ISA is the namespace of everything that depends on it and kIsa its
// value. The autovec ISAs are Highway's one-lane target compiled with
// -march=x86-64-v{2,3,4}; CMake tells which by PITBENCH_AUTOVEC_V{2,3,4}. With
// PITBENCH_COUNTING what is compiled counts its operations (kernels/counting).
// For kernels/placements.h the namespaces lie in one of the placement, which
// CMake gives as PITBENCH_PLACE, e.g. `placed_16::`.
#if defined(PITBENCH_KERNELS_ISA_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PITBENCH_KERNELS_ISA_INL_H_
#undef PITBENCH_KERNELS_ISA_INL_H_
#else
#define PITBENCH_KERNELS_ISA_INL_H_
#endif

#if defined(PITBENCH_COUNTING)
#include "kernels/counting/highway_counting.h"
#else
#include <hwy/highway.h>
#endif

#include "kernels/kernels.h"

#ifndef PITBENCH_PLACE
#define PITBENCH_PLACE
#define PITBENCH_IS_PLACED 0
#elif !defined(PITBENCH_IS_PLACED)
#define PITBENCH_IS_PLACED 1
#endif

#undef PITBENCH_AUTOVEC
#if defined(PITBENCH_AUTOVEC_V2) || defined(PITBENCH_AUTOVEC_V3) || \
    defined(PITBENCH_AUTOVEC_V4)
#define PITBENCH_AUTOVEC 1
#else
#define PITBENCH_AUTOVEC 0
#endif

#undef PITBENCH_ISA
#undef PITBENCH_ISA_VALUE
#if defined(PITBENCH_COUNTING)
#define PITBENCH_ISA counting
#define PITBENCH_ISA_VALUE Isa::kCounting
#elif defined(PITBENCH_AUTOVEC_V2)
#define PITBENCH_ISA autovec_v2
#define PITBENCH_ISA_VALUE Isa::kAutovecV2
#elif defined(PITBENCH_AUTOVEC_V3)
#define PITBENCH_ISA autovec_v3
#define PITBENCH_ISA_VALUE Isa::kAutovecV3
#elif defined(PITBENCH_AUTOVEC_V4)
#define PITBENCH_ISA autovec_v4
#define PITBENCH_ISA_VALUE Isa::kAutovecV4
#elif HWY_TARGET == HWY_SCALAR
#define PITBENCH_ISA scalar
#define PITBENCH_ISA_VALUE Isa::kScalar
#elif HWY_TARGET == HWY_SSSE3
#define PITBENCH_ISA PITBENCH_PLACE ssse3
#define PITBENCH_ISA_VALUE Isa::kSsse3
#elif HWY_TARGET == HWY_SSE4
#define PITBENCH_ISA PITBENCH_PLACE sse4
#define PITBENCH_ISA_VALUE Isa::kSse4
#elif HWY_TARGET == HWY_AVX2
#define PITBENCH_ISA PITBENCH_PLACE avx2
#define PITBENCH_ISA_VALUE Isa::kAvx2
#elif HWY_TARGET == HWY_AVX3
#define PITBENCH_ISA PITBENCH_PLACE avx512
#define PITBENCH_ISA_VALUE Isa::kAvx512
#elif HWY_TARGET == HWY_NEON
#define PITBENCH_ISA PITBENCH_PLACE neon
#define PITBENCH_ISA_VALUE Isa::kNeon
#elif HWY_TARGET == HWY_SVE
#define PITBENCH_ISA sve
#define PITBENCH_ISA_VALUE Isa::kSve
#elif HWY_TARGET == HWY_SVE2
#define PITBENCH_ISA sve2
#define PITBENCH_ISA_VALUE Isa::kSve2
#else
#error "pitbench has no name for this Highway target: add it to enum Isa"
#endif

namespace pitbench {
namespace PITBENCH_ISA {

inline constexpr Isa kIsa = PITBENCH_ISA_VALUE;

}  // namespace PITBENCH_ISA
}  // namespace pitbench

#endif  // include guard that Highway toggles
