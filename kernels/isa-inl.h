// Names the ISA that this pass over the file is compiled for.
//
// PITBENCH_ISA is the namespace of everything that depends on it and kIsa its
// value. The autovec ISAs are Highway's one-lane target compiled with
// -march=x86-64-v{2,3,4}; CMake tells which by PITBENCH_AUTOVEC_V{2,3,4}.
#if defined(PITBENCH_KERNELS_ISA_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PITBENCH_KERNELS_ISA_INL_H_
#undef PITBENCH_KERNELS_ISA_INL_H_
#else
#define PITBENCH_KERNELS_ISA_INL_H_
#endif

#include <hwy/highway.h>

#include "kernels/kernels.h"

#undef PITBENCH_ISA
#undef PITBENCH_ISA_VALUE
#if defined(PITBENCH_AUTOVEC_V2)
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
#define PITBENCH_ISA ssse3
#define PITBENCH_ISA_VALUE Isa::kSsse3
#elif HWY_TARGET == HWY_SSE4
#define PITBENCH_ISA sse4
#define PITBENCH_ISA_VALUE Isa::kSse4
#elif HWY_TARGET == HWY_AVX2
#define PITBENCH_ISA avx2
#define PITBENCH_ISA_VALUE Isa::kAvx2
#elif HWY_TARGET == HWY_AVX3
#define PITBENCH_ISA avx512
#define PITBENCH_ISA_VALUE Isa::kAvx512
#elif HWY_TARGET == HWY_NEON
#define PITBENCH_ISA neon
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
