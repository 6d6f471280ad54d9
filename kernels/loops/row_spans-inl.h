// Row spans of triangles on a grid, by divisions of 16-bit integers: for each
// row the first column inside and the first one behind.
//
// Why it is exact. Let an edge go up from (xs, ys) by (dx, dy), dy > 0. In row
// y it is at x = xs + (y − ys)·dx/dy. Of a left edge the first column inside is
// ⌈x⌉, of a right edge the first one behind is ⌊x⌋ + 1, both
//   ⌊n / dy⌋,  n = xs·dy + (y − ys)·dx + r,  r = dy − 1 (left), dy (right).
// Scaled by the power of two f that brings d = dy·f into (32, 64], it is
//   ⌊n·f / d⌋ = ⌊n·f·m / 2^21⌋,  m = ⌊2^21 / d⌋ + 1 < 2^16.
// Proof: m·d = 2^21 + e with 0 < e ≤ d ≤ 64. In the rows of the edge
// 0 ≤ x ≤ 127, so 0 ≤ n·f ≤ 127·d + d ≤ 2^13, and n·f·m / 2^21 is above
// n·f / d by n·f·e / (2^21·d) ≤ 2^13·2^6 / (2^21·d) < 1/d: too little to reach
// the next whole number, as n·f / d is a multiple of 1/d.
// Products and sums are taken modulo 2^16, which keeps those n·f whole.
//
// Holds for vertices in the grid and grids of up to 128 columns and 64 rows. A
// triangle or grid beyond goes to IncrementalTriangle, which is always right.
#if defined(PITBENCH_KERNELS_LOOPS_ROW_SPANS_INL_H_) == \
    defined(HWY_TARGET_TOGGLE)
#ifdef PITBENCH_KERNELS_LOOPS_ROW_SPANS_INL_H_
#undef PITBENCH_KERNELS_LOOPS_ROW_SPANS_INL_H_
#else
#define PITBENCH_KERNELS_LOOPS_ROW_SPANS_INL_H_
#endif

#include <array>

#include "kernels/loops/incremental-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

inline constexpr std::size_t kMostColumns = 128;
inline constexpr std::size_t kMostRows = 64;
inline constexpr int kReciprocalBits = 21;

// Edges of kSpanBlock triangles as the rows want them. Each number has 16 bits
// and stands in both halves of a word: broadcasting words is free, where
// broadcasting halves is not.
inline constexpr std::size_t kSpanBlock = 32;
struct SpanEdges {
  HWY_ALIGN std::uint32_t start[kSpanBlock];       // n·f in row 0
  HWY_ALIGN std::uint32_t step[kSpanBlock];        // dx·f
  HWY_ALIGN std::uint32_t reciprocal[kSpanBlock];  // m
};
// Vertices are sorted upwards. One edge goes from the lowest to the highest,
// two go by way of the middle one: up to it and on from it.
struct SpanTriangles {
  SpanEdges whole, below, above;
  HWY_ALIGN std::uint32_t first[kSpanBlock];  // row of the lowest vertex
  HWY_ALIGN std::uint32_t middle[kSpanBlock];
  HWY_ALIGN std::uint32_t last[kSpanBlock];  // less than `first` if empty
};

// The number of 16 bits in both halves of a word.
HWY_INLINE std::uint32_t Twice(int value) {
  return static_cast<std::uint16_t>(value) * 0x10001u;
}

template <class D>
HWY_INLINE void StoreTwice(D, Vec<D> v, std::uint32_t* to) {
  const hn::RebindToUnsigned<D> u;
  const auto low = And(hn::BitCast(u, v), Set(u, 0xFFFFu));
  hn::StoreU(Or(low, hn::ShiftLeft<16>(low)), u, to);
}

// The edge from (xs, ys) up to (xe, ye). `left` is −1 for a left edge, 0 for a
// right one. A horizontal edge becomes the vertical line through its start,
// which its one row meets at the vertex.
template <class D>
HWY_INLINE void SetUpEdge(D d, Vec<D> xs, Vec<D> ys, Vec<D> xe, Vec<D> ye,
                          Vec<D> left, SpanEdges& edges, std::size_t at) {
  const auto rise = Sub(ye, ys);
  const auto dy = hn::Max(rise, Set(d, 1));
  const auto dx = hn::IfThenElseZero(Gt(rise, Zero(d)), Sub(xe, xs));
  // 2^(c − 1), where 2^c is the power of two not below dy, has the exponent of
  // dy − 1/2, and f = 2^(6 − c). The quotient is no nearer than 1/64 to a whole
  // number that it is not, and rounds by 2^-9.
  const hn::RebindToFloat<D> fd;
  const auto height = hn::ConvertTo(fd, dy);
  const auto half =
      And(hn::BitCast(d, Sub(height, Set(fd, 0.5f))), Set(d, 0x7F800000));
  const auto scale = hn::BitCast(fd, Sub(Set(d, (127 + 127 + 5) << 23), half));
  const auto quotient = Div(Set(fd, 1 << kReciprocalBits), Mul(height, scale));
  const auto reciprocal = Add(hn::ConvertTo(d, quotient), Set(d, 1));
  const auto f = hn::ConvertTo(d, scale);
  const auto n = Add(Sub(Mul(xs, dy), Mul(ys, dx)), Add(dy, left));
  StoreTwice(d, Mul(n, f), edges.start + at);
  StoreTwice(d, Mul(dx, f), edges.step + at);
  StoreTwice(d, reciprocal, edges.reciprocal + at);
}

// Exchanges two vertices where the first is higher.
template <class V>
HWY_INLINE void SortByRow(V& xp, V& yp, V& xq, V& yq) {
  const auto swap = Gt(yp, yq);
  const V x = IfThenElse(swap, xq, xp);
  xq = IfThenElse(swap, xp, xq);
  xp = x;
  const V y = hn::Min(yp, yq);
  yq = hn::Max(yp, yq);
  yp = y;
}

// Sets up triangles t to t + Lanes(d) of the batch as those from `at` on.
// Returns whether all lie in the grid; one that does not is set up as empty.
template <class D>
HWY_INLINE bool SetUpSpans(D d, const Batch<std::int32_t>& b, std::size_t t,
                           SpanTriangles& to, std::size_t at) {
  auto x0 = hn::LoadU(d, b.ax + t);
  auto y0 = hn::LoadU(d, b.ay + t);
  auto x1 = hn::LoadU(d, b.bx + t);
  auto y1 = hn::LoadU(d, b.by + t);
  auto x2 = hn::LoadU(d, b.cx + t);
  auto y2 = hn::LoadU(d, b.cy + t);
  SortByRow(x0, y0, x1, y1);
  SortByRow(x1, y1, x2, y2);
  SortByRow(x0, y0, x1, y1);
  const auto least = hn::Min(hn::Min(x0, x1), hn::Min(x2, y0));
  const auto width = Set(d, static_cast<std::int32_t>(b.width));
  const auto height = Set(d, static_cast<std::int32_t>(b.height));
  const auto in_grid =
      And(Gt(least, Set(d, -1)),
          And(Gt(width, hn::Max(hn::Max(x0, x1), x2)), Gt(height, y2)));
  x0 = hn::IfThenElseZero(in_grid, x0);
  y0 = hn::IfThenElseZero(in_grid, y0);
  x1 = hn::IfThenElseZero(in_grid, x1);
  y1 = hn::IfThenElseZero(in_grid, y1);
  x2 = hn::IfThenElseZero(in_grid, x2);
  y2 = hn::IfThenElseZero(in_grid, y2);
  // Positive where the middle vertex lies to the right of the whole edge.
  const auto area = Sub(Mul(Sub(x1, x0), Sub(y2, y0)),  //
                        Mul(Sub(x2, x0), Sub(y1, y0)));
  const auto whole_left = hn::VecFromMask(d, Gt(area, Zero(d)));
  const auto parts_left = hn::VecFromMask(d, Lt(area, Zero(d)));
  SetUpEdge(d, x0, y0, x2, y2, whole_left, to.whole, at);
  SetUpEdge(d, x0, y0, x1, y1, parts_left, to.below, at);
  SetUpEdge(d, x1, y1, x2, y2, parts_left, to.above, at);
  const auto empty = hn::Eq(area, Zero(d));
  StoreTwice(d, y0, to.first + at);
  StoreTwice(d, y1, to.middle + at);
  StoreTwice(d, IfThenElse(empty, Set(d, -1), y2), to.last + at);
  return hn::AllTrue(d, in_grid);
}

// Whether SetUpSpans takes triangle t.
HWY_INLINE bool LiesInGrid(const Batch<std::int32_t>& b, std::size_t t) {
  const auto in = [](std::int32_t v, std::size_t end) {
    return v >= 0 && static_cast<std::size_t>(v) < end;
  };
  return in(b.ax[t], b.width) && in(b.bx[t], b.width) && in(b.cx[t], b.width) &&
         in(b.ay[t], b.height) && in(b.by[t], b.height) &&
         in(b.cy[t], b.height);
}

using SpanLanes = hn::CappedTag<std::uint16_t, 32>;

// A number that StoreTwice stored, in every lane.
HWY_INLINE Vec<SpanLanes> Broadcast(SpanLanes d, std::uint32_t twice) {
#if HWY_TARGET == HWY_SCALAR
  return Set(d, static_cast<std::uint16_t>(twice));
#else
  return hn::BitCast(d, Set(hn::RepartitionToWide<SpanLanes>(), twice));
#endif
}

HWY_INLINE Vec<SpanLanes> Crossing(Vec<SpanLanes> rows, Vec<SpanLanes> start,
                                   Vec<SpanLanes> step,
                                   Vec<SpanLanes> reciprocal) {
  return hn::ShiftRight<kReciprocalBits - 16>(
      hn::MulHigh(Add(Mul(rows, step), start), reciprocal));
}

// Edge k of those that are set up.
struct SpanEdge {
  const SpanEdges& of;
  std::size_t k;

  HWY_INLINE Vec<SpanLanes> Start(SpanLanes d) const {
    return Broadcast(d, of.start[k]);
  }
  HWY_INLINE Vec<SpanLanes> Step(SpanLanes d) const {
    return Broadcast(d, of.step[k]);
  }
  HWY_INLINE Vec<SpanLanes> Reciprocal(SpanLanes d) const {
    return Broadcast(d, of.reciprocal[k]);
  }
};

// One triangle: its edges, and its rows as SpanTriangles has them.
struct SpanTriangle {
  SpanEdge whole, below, above;
  std::uint32_t first, middle, last;
};

HWY_INLINE SpanTriangle TriangleOf(const SpanTriangles& t, std::size_t k) {
  return {{t.whole, k}, {t.below, k}, {t.above, k},
          t.first[k],   t.middle[k],  t.last[k]};
}

// In each of the rows the two ends of the triangle's span, in either order: the
// first column inside and the first behind; in rows beyond it two equal
// numbers, with kBounded 0.
template <bool kBounded>
HWY_INLINE void SpanEnds(SpanLanes d, Vec<SpanLanes> rows,
                         const SpanTriangle& t, Vec<SpanLanes>& u,
                         Vec<SpanLanes>& v) {
  const hn::RebindToSigned<SpanLanes> s;
  const auto row = hn::BitCast(s, rows);
  const auto at = [&](std::uint32_t of_triangle) HWY_ATTR {
    return hn::BitCast(s, Broadcast(d, of_triangle));
  };
  const auto is_below = hn::RebindMask(d, Lt(row, at(t.middle)));
  u = Crossing(rows, t.whole.Start(d), t.whole.Step(d), t.whole.Reciprocal(d));
  v = Crossing(
      rows, IfThenElse(is_below, t.below.Start(d), t.above.Start(d)),
      IfThenElse(is_below, t.below.Step(d), t.above.Step(d)),
      IfThenElse(is_below, t.below.Reciprocal(d), t.above.Reciprocal(d)));
  const auto outside =
      hn::RebindMask(d, Or(Lt(row, at(t.first)), Gt(row, at(t.last))));
  if constexpr (kBounded) {
    u = hn::IfThenZeroElse(outside, u);
    v = hn::IfThenZeroElse(outside, v);
  } else {
    v = IfThenElse(outside, u, v);
  }
}

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

#endif  // include guard that Highway toggles
