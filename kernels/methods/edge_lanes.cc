// Point in triangle with the three edges of one point as lanes of a register.
//
//   (A₀, A₁, A₂)·x + (B₀, B₁, B₂)·y + (C₀, C₁, C₂), no lane negative
//
// This is how qTriangle's vector code uses a register: one point at a time, a
// register of 128 bits holding its edges, one of four lanes idle, whatever the
// ISA. Kept to show what points as lanes gain. The ISA `scalar` has no register
// to share and no such row.
// Set-up: 3 edges, 6 multiplications, 3 subtractions. Per point: 2 broadcasts,
// 2 multiplications, 2 additions, 1 compare and the gathering of its lanes.
// Boundary: closed. Winding: fixed by the set-up. Degenerate: contains nothing.
// Range: as edge_function in i32.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/methods/edge_lanes.cc"
#include <hwy/foreach_target.h>

#include "kernels/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

#if HWY_TARGET != HWY_SCALAR
static void EdgeLanes(const Batch<std::int32_t>& batch,
                      const Result<std::int32_t>& result) {
  const hn::CappedTag<std::int32_t, 4> d;
  const std::int64_t x[] = {*batch.ax, *batch.bx, *batch.cx};
  const std::int64_t y[] = {*batch.ay, *batch.by, *batch.cy};
  const std::int64_t area =
      (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]);
  const std::int64_t sign = area < 0 ? -1 : area > 0 ? 1 : 0;
  HWY_ALIGN std::int32_t factors[3][4] = {};  // the fourth lane is never < 0
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = k == 2 ? 0 : k + 1;
    const std::int64_t right = sign * (y[k] - y[next]);
    const std::int64_t down = sign * (x[next] - x[k]);
    factors[0][k] = static_cast<std::int32_t>(right);
    factors[1][k] = static_cast<std::int32_t>(down);
    factors[2][k] = static_cast<std::int32_t>(
        sign == 0 ? -1 : -(right * x[k] + down * y[k]));
  }
  const auto a = hn::Load(d, factors[0]);
  const auto b = hn::Load(d, factors[1]);
  const auto c = hn::Load(d, factors[2]);
  const std::int32_t* const px = batch.px;
  const std::int32_t* const py = batch.py;
  const std::size_t n = batch.n;
  for (std::size_t first = 0; first < n; first += 8) {
    const std::size_t count = HWY_MIN(n - first, std::size_t{8});
    unsigned byte = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const auto e = Add(
          Add(Mul(a, Set(d, px[first + i])), Mul(b, Set(d, py[first + i]))), c);
      byte |= (hn::AllFalse(d, Lt(e, Zero(d))) ? 1u : 0u) << i;
    }
    result.bits[first / 8] = static_cast<std::uint8_t>(byte);
  }
}
#endif

constexpr Method kEdgeLanes{
    .key = "edge_lanes",
    .source = "qTriangle's use of a register",
    .formula = "A·x + B·y + C, the three edges as lanes, none negative",
};

constexpr auto EdgeLanesRows() {
#if HWY_TARGET == HWY_SCALAR
  return Rows<0>{};
#else
  return Rows<1>{MakeKernel<std::int32_t>(kEdgeLanes, Loop::kOneTriangle,
                                          Output::kInside, EdgeLanes)};
#endif
}

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

PITBENCH_KERNELS(edge_lanes, EdgeLanesRows());
