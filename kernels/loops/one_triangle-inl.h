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

// A method may answer by one of several forms, each a class of its own with
// Inside(…), and choose it once for a triangle: Choose(walk) calls walk(form).
template <class M, class Walk>
HWY_INLINE void WalkForm(const M& method, const Walk& walk) {
  if constexpr (requires { method.Choose(walk); }) {
    method.Choose(walk);
  } else {
    walk(method);
  }
}

template <template <class> class M, class T, Output kOutput>
static void OneTriangle(const Batch<T>& batch, const Result<T>& to) {
  const Result<T> result = to;  // local, so that no store can alias them
  const std::size_t n = batch.n;
  const T* const px = batch.px;
  const T* const py = batch.py;
  const OneLane<T> one;
  const M<OneLane<T>> method(
      one, {one, batch.ax, batch.ay, batch.bx, batch.by, batch.cx, batch.cy});
  const Lanes<T> d;
  WalkForm(method, [=](const auto& chosen) HWY_ATTR {
    const auto form = chosen;
    WriteBits<kOutput == Output::kInside ? 4 : 1>(
        d, n, result.bits,
        [=](std::size_t i) HWY_ATTR {
          return Answer<kOutput, true>(
              form, d, InRegister(hn::LoadU(d, px + i)),
              InRegister(hn::LoadU(d, py + i)), result, i, 0);
        },
        [=](std::size_t i, std::size_t count) HWY_ATTR {
          const Tail<Lanes<T>> x(px + i, count);
          const Tail<Lanes<T>> y(py + i, count);
          return Answer<kOutput, false>(form, d, hn::Load(d, x.data()),
                                        hn::Load(d, y.data()), result, i,
                                        count);
        });
  });
}

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

#endif  // include guard that Highway toggles
