// Loop one_triangle: triangle 0 against n points. The set-up is done once.
#if defined(PITBENCH_KERNELS_LOOPS_ONE_TRIANGLE_INL_H_) == \
    defined(HWY_TARGET_TOGGLE)
#ifdef PITBENCH_KERNELS_LOOPS_ONE_TRIANGLE_INL_H_
#undef PITBENCH_KERNELS_LOOPS_ONE_TRIANGLE_INL_H_
#else
#define PITBENCH_KERNELS_LOOPS_ONE_TRIANGLE_INL_H_
#endif

#include "kernels/loops/bits-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

template <template <class> class M, class T, Output kOutput>
static void OneTriangle(const Batch<T>& batch, const Result<T>& to) {
  const Result<T> result = to;  // local, so that no store can alias them
  const T* const px = batch.px;
  const T* const py = batch.py;
  const OneLane<T> one;
  const M<OneLane<T>> method(
      one, {one, batch.ax, batch.ay, batch.bx, batch.by, batch.cx, batch.cy});
  const Lanes<T> d;
  WriteBits(
      d, batch.n, result.bits,
      [&](std::size_t i) HWY_ATTR {
        return Answer<kOutput, true>(method, d, hn::LoadU(d, px + i),
                                     hn::LoadU(d, py + i), result, i, 0);
      },
      [&](std::size_t i, std::size_t count) HWY_ATTR {
        const Tail<Lanes<T>> x(px + i, count);
        const Tail<Lanes<T>> y(py + i, count);
        return Answer<kOutput, false>(method, d, hn::Load(d, x.data()),
                                      hn::Load(d, y.data()), result, i, count);
      });
}

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

#endif  // include guard that Highway toggles
