// Loop ray_pairs: ray i against triangle i, which is set up for it alone.
#if defined(PITBENCH_KERNELS_RAYS_LOOPS_RAY_PAIRS_INL_H_) == \
    defined(HWY_TARGET_TOGGLE)
#ifdef PITBENCH_KERNELS_RAYS_LOOPS_RAY_PAIRS_INL_H_
#undef PITBENCH_KERNELS_RAYS_LOOPS_RAY_PAIRS_INL_H_
#else
#define PITBENCH_KERNELS_RAYS_LOOPS_RAY_PAIRS_INL_H_
#endif

#include "kernels/rays/loops/ray_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

template <template <class> class M, class T, RayOutput kOutput>
static void RayPairs(const RayBatch<T>& batch, const RayResult<T>& to) {
  using D = Lanes<T>;
  const D d;
  const RayBatch<T> b = batch;  // local, so that no store can alias them
  const RayResult<T> result = to;
  const auto range = RangeFor<M<D>>(b);
  const auto answer = [=](const auto& triangle, const auto& ray, auto whole,
                          std::size_t i, std::size_t count) HWY_ATTR {
    return WithTurned<M<D>::kTurn>(
        d, TriangleFor<M<D>>(d, triangle), ray,
        [&](const auto& turned, const auto& turned_ray) HWY_ATTR {
          return AnswerRays<kOutput, decltype(whole)::value>(
              M<D>(d, turned), d, turned_ray, range, result, i, count);
        });
  };
  WriteAnswers(
      d, b.n, result.bits,
      [=](std::size_t i) HWY_ATTR {
        return answer(LoadTriangles(d, b, i), LoadRays(d, b, i),
                      std::true_type(), i, 0);
      },
      [=](std::size_t i, std::size_t count) HWY_ATTR {
        const TrianglesTail<D> triangles(b, i, count);
        const RaysTail<D> rays(b, i, count);
        return answer(triangles.In(d), rays.In(d), std::false_type(), i, count);
      });
}

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

#endif  // include guard that Highway toggles
