// A value of which the compiler knows nothing.
#if defined(PITBENCH_KERNELS_OPAQUE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PITBENCH_KERNELS_OPAQUE_INL_H_
#undef PITBENCH_KERNELS_OPAQUE_INL_H_
#else
#define PITBENCH_KERNELS_OPAQUE_INL_H_
#endif

#include "kernels/method-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

#if defined(PITBENCH_COUNTING)
using hn::Opaque;
#else
// `v`, at no cost but a register. What is computed from it in a loop stays
// there: for all that the compiler knows, it is another value every time.
template <class V>
HWY_INLINE V Opaque(V v) {
#if HWY_HAVE_SCALABLE
  asm volatile("" : "+w"(v));
#elif HWY_ARCH_ARM
  asm volatile("" : "+w"(v.raw));
#elif HWY_TARGET == HWY_AVX3
  asm volatile("" : "+v"(v.raw));
#else
  asm volatile("" : "+x"(v.raw));
#endif
  return v;
}
#endif

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

#endif  // include guard that Highway toggles
