// From a method's class to its rows in the table of kernels.
//
// A method file ends with PITBENCH_KERNELS(key, rows), where rows is a sum of
//   FloatRows<M>(method)   f32 and f64, every loop, weights where M has them
//   FmaRows<M>(method)     the same where the ISA has multiply-add
//   F32Rows<M>(method)     f32, every loop
//   F32FmaRows<M>(method)  the same where the ISA has multiply-add
//   OneTriangleRows<M>(method), OneTriangleFmaRows<M>(method)
//                          f32 and f64, loop one_triangle only
//   AosRows<M>(method), AosFmaRows<M>(method)
//                          f32 and f64, loop one_triangle_aos
//   GridRows<M>(method)    i32 in loop grid
//   GridFunctionRow(method, function)  the same by a loop of its own
//   PointListRows<M>(method)  i32 and i16 in loop one_triangle
#if defined(PITBENCH_KERNELS_ROWS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PITBENCH_KERNELS_ROWS_INL_H_
#undef PITBENCH_KERNELS_ROWS_INL_H_
#else
#define PITBENCH_KERNELS_ROWS_INL_H_
#endif

#include "kernels/table-inl.h"

#if PITBENCH_AUTOVEC
#include "kernels/loops/plain-inl.h"
#else
#include "kernels/loops/grid-inl.h"
#include "kernels/loops/many_triangles-inl.h"
#include "kernels/loops/one_triangle-inl.h"
#if !defined(PITBENCH_COUNTING)
#include "kernels/loops/one_triangle_aos-inl.h"
#endif
#endif

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

template <std::size_t kCount>
using Rows = std::array<Kernel, kCount>;

template <class T>
constexpr Kernel MakeKernel(const Method& method, Loop loop, Output output,
                            KernelFunction<T> function) {
  Kernel kernel{method, ScalarOf<T>(), kIsa, loop, output};
  if constexpr (std::is_same_v<T, float>) kernel.f32 = function;
  if constexpr (std::is_same_v<T, double>) kernel.f64 = function;
  if constexpr (std::is_same_v<T, std::int32_t>) kernel.i32 = function;
  if constexpr (std::is_same_v<T, std::int16_t>) kernel.i16 = function;
  if constexpr (std::is_same_v<T, std::uint8_t>) kernel.u8 = function;
  return kernel;
}

// PITBENCH_ONE_TRIANGLE_ONLY leaves out the other loops, and with them most of
// the time that compiling takes: for harness/arm64.
template <template <class> class M, class T, Output kOutput>
constexpr auto LoopRows(const Method& method) {
  const Rows<1> one{MakeKernel<T>(method, Loop::kOneTriangle, kOutput,
                                  OneTriangle<M, T, kOutput>)};
#if defined(PITBENCH_ONE_TRIANGLE_ONLY)
  return one;
#else
  return one + Rows<2>{MakeKernel<T>(method, Loop::kOnePoint, kOutput,
                                     OnePoint<M, T, kOutput>),
                       MakeKernel<T>(method, Loop::kPairs, kOutput,
                                     Pairs<M, T, kOutput>)};
#endif
}

template <template <class> class M>
concept HasWeights = requires {
  &M<OneLane<float>>::template Weights<OneLane<float>>;
};

// Placements are of one kernel a method.
template <template <class> class M>
constexpr auto FloatRows(const Method& method) {
#if PITBENCH_IS_PLACED
  return Rows<1>{MakeKernel<float>(method, Loop::kOneTriangle, Output::kInside,
                                   OneTriangle<M, float, Output::kInside>)};
#else
  const auto inside = LoopRows<M, float, Output::kInside>(method) +
                      LoopRows<M, double, Output::kInside>(method);
#if defined(PITBENCH_ONE_TRIANGLE_ONLY)
  constexpr bool kWithWeights = false;
#else
  constexpr bool kWithWeights = HasWeights<M>;
#endif
  if constexpr (kWithWeights) {
    return inside + LoopRows<M, float, Output::kWeights>(method) +
           LoopRows<M, double, Output::kWeights>(method);
  } else {
    return inside;
  }
#endif
}

template <template <class> class M>
constexpr auto GridRows(const Method& method) {
#if PITBENCH_AUTOVEC || PITBENCH_IS_PLACED
  (void)method;
  return Rows<0>{};
#else
  return Rows<1>{MakeKernel<std::int32_t>(method, Loop::kGrid, Output::kInside,
                                          Grid<M, std::int32_t>)};
#endif
}

// A method that is a loop of its own over the grid.
constexpr auto GridFunctionRow(const Method& method,
                               KernelFunction<std::int32_t> function) {
  return Rows<1>{
      MakeKernel<std::int32_t>(method, Loop::kGrid, Output::kInside, function)};
}

template <template <class> class M>
constexpr auto PointListRows(const Method& method) {
#if PITBENCH_IS_PLACED
  (void)method;
  return Rows<0>{};
#else
  return Rows<2>{
      MakeKernel<std::int32_t>(method, Loop::kOneTriangle, Output::kInside,
                               OneTriangle<M, std::int32_t, Output::kInside>),
      MakeKernel<std::int16_t>(method, Loop::kOneTriangle, Output::kInside,
                               OneTriangle<M, std::int16_t, Output::kInside>)};
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

// The same for a method that declares something else for f64 than for f32.
template <template <class> class M>
constexpr auto FmaOnly(const Method& f32, const Method& f64) {
#if HWY_NATIVE_FMA
  return LoopRows<M, float, Output::kInside>(f32) +
         LoopRows<M, double, Output::kInside>(f64);
#else
  (void)f32;
  (void)f64;
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

// Of a method whose set-up pays only for many points.
template <template <class> class M>
constexpr auto OneTriangleRows(const Method& method) {
  return Rows<2>{MakeKernel<float>(method, Loop::kOneTriangle, Output::kInside,
                                   OneTriangle<M, float, Output::kInside>),
                 MakeKernel<double>(method, Loop::kOneTriangle, Output::kInside,
                                    OneTriangle<M, double, Output::kInside>)};
}

template <template <class> class M>
constexpr auto OneTriangleFmaRows(const Method& method) {
#if HWY_NATIVE_FMA
  return OneTriangleRows<M>(method);
#else
  (void)method;
  return Rows<0>{};
#endif
}

// The arithmetic is that of loop one_triangle: it is counted there.
template <template <class> class M>
constexpr auto AosRows(const Method& method) {
#if PITBENCH_IS_PLACED || defined(PITBENCH_COUNTING)
  (void)method;
  return Rows<0>{};
#else
  return Rows<2>{
      MakeKernel<float>(method, Loop::kOneTriangleAos, Output::kInside,
                        OneTriangleAos<M, float>),
      MakeKernel<double>(method, Loop::kOneTriangleAos, Output::kInside,
                         OneTriangleAos<M, double>)};
#endif
}

template <template <class> class M>
constexpr auto AosFmaRows(const Method& method) {
#if HWY_NATIVE_FMA
  return AosRows<M>(method);
#else
  (void)method;
  return Rows<0>{};
#endif
}

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

#undef PITBENCH_KERNELS
#define PITBENCH_KERNELS(key, ...) \
  PITBENCH_EXPORT_ROWS(Kernel, key, __VA_ARGS__)

#endif  // include guard that Highway toggles
