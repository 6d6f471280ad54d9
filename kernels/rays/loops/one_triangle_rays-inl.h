// Loop one_triangle_rays: triangle 0 against n rays. The set-up is done once,
// but for a method that turns the triangle with each ray.
#if defined(PITBENCH_KERNELS_RAYS_LOOPS_ONE_TRIANGLE_RAYS_INL_H_) == \
    defined(HWY_TARGET_TOGGLE)
#ifdef PITBENCH_KERNELS_RAYS_LOOPS_ONE_TRIANGLE_RAYS_INL_H_
#undef PITBENCH_KERNELS_RAYS_LOOPS_ONE_TRIANGLE_RAYS_INL_H_
#else
#define PITBENCH_KERNELS_RAYS_LOOPS_ONE_TRIANGLE_RAYS_INL_H_
#endif

#include "kernels/rays/loops/ray_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

// Writes n answers; answer(ray, whole, i, count) gives those of the rays from
// `i` on, of which `count` are real or, if decltype(whole)::value, all.
template <class D, class T, class Answer>
HWY_INLINE void WriteRayBits(D d, const RayBatch<T>& b, std::uint8_t* bits,
                             const Answer& answer) {
  WriteAnswers(
      d, b.n, bits,
      [=](std::size_t i) HWY_ATTR {
        return answer(LoadRays(d, b, i), std::true_type(), i, 0);
      },
      [=](std::size_t i, std::size_t count) HWY_ATTR {
        const RaysTail<D> tail(b, i, count);
        return answer(tail.In(d), std::false_type(), i, count);
      });
}

template <template <class> class M, class T, RayOutput kOutput>
static void OneTriangleRays(const RayBatch<T>& batch, const RayResult<T>& to) {
  using D = Lanes<T>;
  const D d;
  const OneLane<T> one;
  constexpr Turn kTurn = M<D>::kTurn;
  // Local, so that no store can alias them.
  const RayBatch<T> b =
      TurnedAsFirst < kTurn == Turn::kNormal ? kTurn : Turn::kNone > (batch);
  const RayResult<T> result = to;
  const auto range = RangeFor<M<D>>(b);
  const auto triangle = TriangleFor<M<D>>(one, FirstTriangle(b));
  if constexpr (kTurn == Turn::kDirection) {
    WriteRayBits(
        d, b, result.bits,
        [=](const auto& ray, auto whole, std::size_t i,
            std::size_t count) HWY_ATTR {
          return WithTurned<kTurn>(
              d, triangle, ray,
              [&](const auto& turned, const auto& turned_ray) HWY_ATTR {
                return AnswerRays<kOutput, decltype(whole)::value>(
                    M<D>(d, turned), d, turned_ray, range, result, i, count);
              });
        });
  } else {
    const M<OneLane<T>> method(one, triangle);
    WriteRayBits(d, b, result.bits,
                 [=](const auto& ray, auto whole, std::size_t i,
                     std::size_t count) HWY_ATTR {
                   return AnswerRays<kOutput, decltype(whole)::value>(
                       method, d, ray, range, result, i, count);
                 });
  }
}

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

#endif  // include guard that Highway toggles
