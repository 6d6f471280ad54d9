// From a ray method's class to its rows in the table of ray kernels.
//
// A method file ends with PITBENCH_RAY_KERNELS(key, rows), where rows is a sum
// of
//   RayRows<M>(method)     f32 and f64, every loop, with t, u, v and without
//   RayFmaRows<M>(method)  the same where the ISA has multiply-add
#if defined(PITBENCH_KERNELS_RAYS_RAY_ROWS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PITBENCH_KERNELS_RAYS_RAY_ROWS_INL_H_
#undef PITBENCH_KERNELS_RAYS_RAY_ROWS_INL_H_
#else
#define PITBENCH_KERNELS_RAYS_RAY_ROWS_INL_H_
#endif

#include "kernels/rays/loops/one_ray-inl.h"
#include "kernels/rays/loops/one_triangle_rays-inl.h"
#include "kernels/rays/loops/ray_pairs-inl.h"
#include "kernels/table-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

template <std::size_t kCount>
using RaysTable = std::array<RayKernel, kCount>;

template <class T>
constexpr RayKernel MakeRayKernel(const RayMethod& method, RayLoop loop,
                                  RayOutput output, RayFunction<T> function) {
  RayKernel kernel{method, ScalarOf<T>(), kIsa, loop, output};
  if constexpr (std::is_same_v<T, float>) kernel.f32 = function;
  if constexpr (std::is_same_v<T, double>) kernel.f64 = function;
  return kernel;
}

template <template <class> class M, class T>
constexpr RaysTable<5> RayLoopRows(const RayMethod& method,
                                   RayFunction<T> one_ray) {
  using enum RayLoop;
  using enum RayOutput;
  return {MakeRayKernel<T>(method, kOneTriangleRays, kHits,
                           OneTriangleRays<M, T, kHits>),
          MakeRayKernel<T>(method, kOneTriangleRays, kTuv,
                           OneTriangleRays<M, T, kTuv>),
          MakeRayKernel<T>(method, kOneRay, kNearest, one_ray),
          MakeRayKernel<T>(method, kRayPairs, kHits, RayPairs<M, T, kHits>),
          MakeRayKernel<T>(method, kRayPairs, kTuv, RayPairs<M, T, kTuv>)};
}

template <template <class> class M>
constexpr auto RayRows(const RayMethod& method) {
  return RayLoopRows<M, float>(method, OneRay<M, float>) +
         RayLoopRows<M, double>(method, OneRay<M, double>);
}

template <template <class> class M>
constexpr auto RayFmaRows(const RayMethod& method) {
#if HWY_NATIVE_FMA
  return RayRows<M>(method);
#else
  (void)method;
  return RaysTable<0>{};
#endif
}

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

#undef PITBENCH_RAY_KERNELS
#define PITBENCH_RAY_KERNELS(key, ...) \
  PITBENCH_EXPORT_ROWS(RayKernel, ray_##key, __VA_ARGS__)

#endif  // include guard that Highway toggles
