// Loop grid: n triangles, each against every pixel of a width × height grid.
// The points are not read from anywhere: pixel (column x, row y) is (x, y).
#if defined(PITBENCH_KERNELS_LOOPS_GRID_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PITBENCH_KERNELS_LOOPS_GRID_INL_H_
#undef PITBENCH_KERNELS_LOOPS_GRID_INL_H_
#else
#define PITBENCH_KERNELS_LOOPS_GRID_INL_H_
#endif

#include "kernels/loops/bits-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

// Set-up once a triangle, then row by row.
template <template <class> class M, class T>
static void Grid(const Batch<T>& batch, const Result<T>& result) {
  const Batch<T> b = batch;  // local, so that no store can alias it
  const OneLane<T> one;
  const Lanes<T> d;
  const auto columns = hn::Iota(d, T{0});  // by way of memory: once is enough
  std::uint8_t* row = result.bits;
  for (std::size_t t = 0; t < b.n; ++t) {
    const M<OneLane<T>> method(
        one, {one, b.ax + t, b.ay + t, b.bx + t, b.by + t, b.cx + t, b.cy + t});
    for (std::size_t y = 0; y < b.height; ++y) {
      // By value, as WriteBits wants it, but for what may have no known size.
      const auto answer = [&columns, method, d, y](std::size_t x) HWY_ATTR {
        return method.Inside(d, Add(columns, Set(d, static_cast<T>(x))),
                             Set(d, static_cast<T>(y)));
      };
      WriteBits(d, b.width, row, answer,
                [=](std::size_t x, std::size_t count)
                    HWY_ATTR { return And(answer(x), hn::FirstN(d, count)); });
      row += BitBytes(b.width);
    }
  }
}

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

#endif  // include guard that Highway toggles
