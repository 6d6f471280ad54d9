// Loops one_point and pairs: a triangle a lane, set up for one answer each.
#if defined(PITBENCH_KERNELS_LOOPS_MANY_TRIANGLES_INL_H_) == \
    defined(HWY_TARGET_TOGGLE)
#ifdef PITBENCH_KERNELS_LOOPS_MANY_TRIANGLES_INL_H_
#undef PITBENCH_KERNELS_LOOPS_MANY_TRIANGLES_INL_H_
#else
#define PITBENCH_KERNELS_LOOPS_MANY_TRIANGLES_INL_H_
#endif

#include "kernels/loops/bits-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

// Answers for n triangles. kOnePoint: the point is element 0 of px and py,
// else element i.
template <template <class> class M, class T, Output kOutput, bool kOnePoint>
static HWY_INLINE void ManyTriangles(const Batch<T>& batch,
                                     const Result<T>& to) {
  using D = Lanes<T>;
  const D d;
  const Batch<T> b = batch;  // local, so that no store can alias them
  const Result<T> result = to;
  const T x0 = kOnePoint && b.n != 0 ? *b.px : T{0};
  const T y0 = kOnePoint && b.n != 0 ? *b.py : T{0};
  const auto answer = [=](const Triangles<D>& triangles, Vec<D> x, Vec<D> y,
                          auto whole, std::size_t i, std::size_t count)
                          HWY_ATTR {
                            return Answer<kOutput, decltype(whole)::value>(
                                M<D>(d, triangles), d, x, y, result, i, count);
                          };
  WriteBits(
      d, b.n, result.bits,
      [=](std::size_t i) HWY_ATTR {
        const Triangles<D> triangles{d,        b.ax + i, b.ay + i, b.bx + i,
                                     b.by + i, b.cx + i, b.cy + i};
        const auto x =
            kOnePoint ? Set(d, x0) : InRegister(hn::LoadU(d, b.px + i));
        const auto y =
            kOnePoint ? Set(d, y0) : InRegister(hn::LoadU(d, b.py + i));
        return answer(triangles, x, y, std::true_type(), i, 0);
      },
      [=](std::size_t i, std::size_t count) HWY_ATTR {
        const Tail<D> ax(b.ax + i, count), ay(b.ay + i, count);
        const Tail<D> bx(b.bx + i, count), by(b.by + i, count);
        const Tail<D> cx(b.cx + i, count), cy(b.cy + i, count);
        const Tail<D> px(kOnePoint ? b.px : b.px + i, kOnePoint ? 1 : count);
        const Tail<D> py(kOnePoint ? b.py : b.py + i, kOnePoint ? 1 : count);
        const Triangles<D> triangles{d,         ax.data(), ay.data(), bx.data(),
                                     by.data(), cx.data(), cy.data()};
        const auto x = kOnePoint ? Set(d, x0) : hn::Load(d, px.data());
        const auto y = kOnePoint ? Set(d, y0) : hn::Load(d, py.data());
        return answer(triangles, x, y, std::false_type(), i, count);
      });
}

template <template <class> class M, class T, Output kOutput>
static void OnePoint(const Batch<T>& batch, const Result<T>& result) {
  ManyTriangles<M, T, kOutput, true>(batch, result);
}

template <template <class> class M, class T, Output kOutput>
static void Pairs(const Batch<T>& batch, const Result<T>& result) {
  ManyTriangles<M, T, kOutput, false>(batch, result);
}

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

#endif  // include guard that Highway toggles
