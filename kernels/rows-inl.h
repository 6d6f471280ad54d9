// From a method's class to its rows in the table of kernels.
//
// A method file ends with PITBENCH_KERNELS(key, rows), where rows is a sum of
//   FloatRows<M>(method)   f32 and f64, every loop, weights where M has them
//   FmaRows<M>(method)     the same where the ISA has multiply-add
//   F32Rows<M>(method)     f32, every loop
//   F32FmaRows<M>(method)  the same where the ISA has multiply-add
//   GridRows<M>(method)    i32 in loop grid
#if defined(PITBENCH_KERNELS_ROWS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PITBENCH_KERNELS_ROWS_INL_H_
#undef PITBENCH_KERNELS_ROWS_INL_H_
#else
#define PITBENCH_KERNELS_ROWS_INL_H_
#endif

#include <array>

#if defined(PITBENCH_AUTOVEC_V2) || defined(PITBENCH_AUTOVEC_V3) || \
    defined(PITBENCH_AUTOVEC_V4)
#define PITBENCH_AUTOVEC 1
#include "kernels/loops/plain-inl.h"
#else
#define PITBENCH_AUTOVEC 0
#include "kernels/loops/grid-inl.h"
#include "kernels/loops/many_triangles-inl.h"
#include "kernels/loops/one_triangle-inl.h"
#endif

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

template <std::size_t kCount>
using Rows = std::array<Kernel, kCount>;

template <std::size_t kA, std::size_t kB>
constexpr Rows<kA + kB> operator+(const Rows<kA>& a, const Rows<kB>& b) {
  Rows<kA + kB> joined{};
  for (std::size_t i = 0; i < kA; ++i) joined[i] = a[i];
  for (std::size_t i = 0; i < kB; ++i) joined[kA + i] = b[i];
  return joined;
}

template <class T>
constexpr Kernel MakeKernel(const Method& method, Loop loop, Output output,
                            KernelFunction<T> function) {
  Kernel kernel{method, ScalarOf<T>(), kIsa, loop, output};
  if constexpr (std::is_same_v<T, float>) kernel.f32 = function;
  if constexpr (std::is_same_v<T, double>) kernel.f64 = function;
  if constexpr (std::is_same_v<T, std::int32_t>) kernel.i32 = function;
  return kernel;
}

template <template <class> class M, class T, Output kOutput>
constexpr Rows<3> LoopRows(const Method& method) {
  return {
      MakeKernel<T>(method, Loop::kOneTriangle, kOutput,
                    OneTriangle<M, T, kOutput>),
      MakeKernel<T>(method, Loop::kOnePoint, kOutput, OnePoint<M, T, kOutput>),
      MakeKernel<T>(method, Loop::kPairs, kOutput, Pairs<M, T, kOutput>)};
}

template <template <class> class M>
concept HasWeights = requires {
  &M<OneLane<float>>::template Weights<OneLane<float>>;
};

template <template <class> class M>
constexpr auto FloatRows(const Method& method) {
  const auto inside = LoopRows<M, float, Output::kInside>(method) +
                      LoopRows<M, double, Output::kInside>(method);
  if constexpr (HasWeights<M>) {
    return inside + LoopRows<M, float, Output::kWeights>(method) +
           LoopRows<M, double, Output::kWeights>(method);
  } else {
    return inside;
  }
}

template <template <class> class M>
constexpr auto GridRows(const Method& method) {
#if PITBENCH_AUTOVEC
  (void)method;
  return Rows<0>{};
#else
  return Rows<1>{MakeKernel<std::int32_t>(method, Loop::kGrid, Output::kInside,
                                          Grid<M, std::int32_t>)};
#endif
}

// FloatRows of a method that contracts, where the ISA has the instruction.
template <template <class> class M>
constexpr auto FmaRows(const Method& method) {
#if HWY_NATIVE_FMA
  return FloatRows<M>(method);
#else
  (void)method;
  return Rows<0>{};
#endif
}

// Of a method that has no sense for f64, since it computes in f64 itself.
template <template <class> class M>
constexpr auto F32Rows(const Method& method) {
  return LoopRows<M, float, Output::kInside>(method);
}

template <template <class> class M>
constexpr auto F32FmaRows(const Method& method) {
#if HWY_NATIVE_FMA
  return F32Rows<M>(method);
#else
  (void)method;
  return Rows<0>{};
#endif
}

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

#undef PITBENCH_KERNELS
#define PITBENCH_KERNELS(key, ...)             \
  HWY_BEFORE_NAMESPACE();                      \
  namespace pitbench {                         \
  namespace PITBENCH_ISA {                     \
  std::span<const Kernel> key();               \
  std::span<const Kernel> key() {              \
    static constexpr auto kRows = __VA_ARGS__; \
    return {kRows.data(), kRows.size()};       \
  }                                            \
  }                                            \
  }                                            \
  HWY_AFTER_NAMESPACE()

#endif  // include guard that Highway toggles
