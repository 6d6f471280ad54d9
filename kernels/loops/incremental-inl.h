// Edge functions stepped over a grid: from column to column by A, from row to
// row by B, so a pixel costs three additions and no multiplication.
//
// Lanes of 16 bits are exact while grid and vertices lie in a window of 2^7
// columns and 2^7 rows, lanes of 32 bits in one of 2^15: an edge function of
// two points in a window of side s + 1 is at most 2·s², and what wraps on the
// way to it does no harm. Triangles beyond both go to WriteGridRowsExactly.
#if defined(PITBENCH_KERNELS_LOOPS_INCREMENTAL_INL_H_) == \
    defined(HWY_TARGET_TOGGLE)
#ifdef PITBENCH_KERNELS_LOOPS_INCREMENTAL_INL_H_
#undef PITBENCH_KERNELS_LOOPS_INCREMENTAL_INL_H_
#else
#define PITBENCH_KERNELS_LOOPS_INCREMENTAL_INL_H_
#endif

#include <array>
#include <cstring>

#include "kernels/exact/grid_rows.h"
#include "kernels/loops/bits-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

// Columns and rows from `left`, `top` up to but without `right`, `bottom`.
struct PixelBox {
  std::size_t left, right, top, bottom;
};

// The pixels that the bounding box of triangle t has in the grid.
HWY_INLINE PixelBox BoundingPixels(const Batch<std::int32_t>& b,
                                   std::size_t t) {
  const auto range = [](std::int32_t p, std::int32_t q, std::int32_t r,
                        std::size_t end, std::size_t& first,
                        std::size_t& behind) {
    const std::int64_t low = HWY_MAX(HWY_MIN(HWY_MIN(p, q), r), 0);
    const std::int64_t high = std::int64_t{HWY_MAX(HWY_MAX(p, q), r)} + 1;
    behind = high <= low ? 0 : HWY_MIN(static_cast<std::size_t>(high), end);
    first = HWY_MIN(static_cast<std::size_t>(low), behind);
  };
  PixelBox box;
  range(b.ax[t], b.bx[t], b.cx[t], b.width, box.left, box.right);
  range(b.ay[t], b.by[t], b.cy[t], b.height, box.top, box.bottom);
  if (box.left == box.right || box.top == box.bottom) box = {0, 0, 0, 0};
  return box;
}

// The side of the smallest window around triangle t and the grid, less 1.
HWY_INLINE std::int64_t WindowSide(const Batch<std::int32_t>& b,
                                   std::size_t t) {
  const auto side = [](std::int32_t p, std::int32_t q, std::int32_t r,
                       std::size_t pixels) {
    const std::int64_t low = HWY_MIN(HWY_MIN(HWY_MIN(p, q), r), 0);
    return HWY_MAX(std::int64_t{HWY_MAX(HWY_MAX(p, q), r)},
                   static_cast<std::int64_t>(pixels) - 1) -
           low;
  };
  return HWY_MAX(side(b.ax[t], b.bx[t], b.cx[t], b.width),
                 side(b.ay[t], b.by[t], b.cy[t], b.height));
}

// The three edge functions of triangle t; precondition: exact in T.
template <class T>
struct SteppedEdges {
  using D = Lanes<T>;
  T a[3], b[3], corner[3];  // per column, per row, and at the box's corner

  // A triangle without area is below 0 everywhere.
  HWY_INLINE SteppedEdges(const Batch<std::int32_t>& t, std::size_t i,
                          std::size_t left, std::size_t top) {
    const std::int64_t x[] = {t.ax[i], t.bx[i], t.cx[i]};
    const std::int64_t y[] = {t.ay[i], t.by[i], t.cy[i]};
    const std::int64_t area =
        (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]);
    const std::int64_t sign = area < 0 ? -1 : area > 0 ? 1 : 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = k == 2 ? 0 : k + 1;
      const std::int64_t down = sign * (x[next] - x[k]);
      const std::int64_t right = sign * (y[k] - y[next]);
      a[k] = static_cast<T>(right);
      b[k] = static_cast<T>(down);
      corner[k] = static_cast<T>(
          sign == 0 ? -1
                    : right * (static_cast<std::int64_t>(left) - x[k]) +
                          down * (static_cast<std::int64_t>(top) - y[k]));
    }
  }

  // Of a lane a column, `columns` from the corner on.
  HWY_INLINE Vec<D> At(D d, std::size_t k, Vec<D> columns) const {
    return Add(Mul(columns, Set(d, a[k])), Set(d, corner[k]));
  }
};

// The vector of columns from `first` on of every row of the box, `count` of
// them. Three additions and a compare a vector, all else stays in registers.
template <bool kWhole, class T>
HWY_INLINE void StepDown(const SteppedEdges<T>& edges, std::size_t first,
                         std::size_t count, std::size_t height,
                         std::size_t row_bytes, std::uint8_t* row,
                         const std::uint8_t* end) {
  const Lanes<T> d;
  const std::size_t bytes = hn::Lanes(d) / 8;
  const auto columns = hn::Iota(d, static_cast<T>(first));
  auto e0 = edges.At(d, 0, columns);
  auto e1 = edges.At(d, 1, columns);
  auto e2 = edges.At(d, 2, columns);
  const auto down0 = Set(d, edges.b[0]);
  const auto down1 = Set(d, edges.b[1]);
  const auto down2 = Set(d, edges.b[2]);
  const auto real = hn::FirstN(d, count);
  const auto next = [&]() HWY_ATTR {
    const auto inside = AllNonNegative(d, e0, e1, e2);
    e0 = Add(e0, down0);
    e1 = Add(e1, down1);
    e2 = Add(e2, down2);
    if constexpr (kWhole) {
      return inside;
    } else {
      return And(inside, real);
    }
  };
  const auto room = static_cast<std::size_t>(end - row);
  std::size_t with_room = height;  // rows with so many bytes to write to
  while (with_room > 0 && (with_room - 1) * row_bytes + bytes > room) {
    --with_room;
  }
  for (std::size_t y = 0; y < with_room; ++y, row += row_bytes) {
    hn::StoreMaskBits(d, next(), row);
  }
  for (std::size_t y = with_room; y < height; ++y, row += row_bytes) {
    const std::uint64_t word = MaskBits(d, next());
    std::memcpy(row, &word, BitBytes(count));
  }
}

// Writes the rows of triangle t in lanes of T, as far as they are in the box;
// precondition: exact in T. `spare` is how many bytes behind these rows may be
// set to 0 as well.
template <class T>
HWY_INLINE void StepThrough(const Batch<std::int32_t>& b, std::size_t t,
                            const PixelBox& box, std::uint8_t* rows,
                            std::size_t spare) {
  const Lanes<T> d;
  const std::size_t lanes = hn::Lanes(d);
  const std::size_t row_bytes = BitBytes(b.width);
  // Whole bytes and whole vectors.
  const std::size_t step = HWY_MAX(lanes, std::size_t{8});
  const std::size_t left = box.left / step * step;
  const std::size_t width = box.right - left;
  const std::size_t height = box.bottom - box.top;
  const SteppedEdges<T> edges(b, t, left, box.top);
  std::uint8_t* row = rows + box.top * row_bytes + left / 8;
  if (lanes >= 8) {
    // From right to left: the last vector of a row also clears the first bytes
    // of the next.
    for (std::size_t x = (width + lanes - 1) / lanes * lanes; x > 0;) {
      x -= lanes;
      const std::uint8_t* const end = rows + b.height * row_bytes + spare;
      if (width - x >= lanes) {
        StepDown<true>(edges, x, lanes, height, row_bytes, row + x / 8, end);
      } else {
        StepDown<false>(edges, x, width - x, height, row_bytes, row + x / 8,
                        end);
      }
    }
    return;
  }
  const auto columns = hn::Iota(d, T{0});
  const auto few = static_cast<T>(lanes);
  auto row0 = edges.At(d, 0, columns);
  auto row1 = edges.At(d, 1, columns);
  auto row2 = edges.At(d, 2, columns);
  const auto right0 = Set(d, static_cast<T>(edges.a[0] * few));
  const auto right1 = Set(d, static_cast<T>(edges.a[1] * few));
  const auto right2 = Set(d, static_cast<T>(edges.a[2] * few));
  const auto down0 = Set(d, edges.b[0]);
  const auto down1 = Set(d, edges.b[1]);
  const auto down2 = Set(d, edges.b[2]);
  for (std::size_t y = 0; y < height; ++y, row += row_bytes) {
    auto e0 = row0;
    auto e1 = row1;
    auto e2 = row2;
    const auto next = [&](std::size_t) HWY_ATTR {
      const auto inside = AllNonNegative(d, e0, e1, e2);
      e0 = Add(e0, right0);
      e1 = Add(e1, right1);
      e2 = Add(e2, right2);
      return inside;
    };
    WriteBits(d, width, row, next,
              [&](std::size_t i, std::size_t count)
                  HWY_ATTR { return And(next(i), hn::FirstN(d, count)); });
    row0 = Add(row0, down0);
    row1 = Add(row1, down1);
    row2 = Add(row2, down2);
  }
}

// The rows of triangle t, whatever its coordinates.
template <bool kClipped>
HWY_INLINE void IncrementalTriangle(const Batch<std::int32_t>& b, std::size_t t,
                                    std::uint8_t* rows, std::size_t spare) {
  PixelBox box{0, b.width, 0, b.height};
  if constexpr (kClipped) {
    box = BoundingPixels(b, t);
    std::memset(rows, 0, b.height * BitBytes(b.width));
  }
  const std::int64_t side = WindowSide(b, t);
  if (side < std::int64_t{1} << 7) {
    StepThrough<std::int16_t>(b, t, box, rows, spare);
  } else if (side < std::int64_t{1} << 15) {
    StepThrough<std::int32_t>(b, t, box, rows, spare);
  } else {
    WriteGridRowsExactly(b, t, rows);
  }
}

template <bool kClipped>
static void IncrementalGrid(const Batch<std::int32_t>& batch,
                            const Result<std::int32_t>& result) {
  const Batch<std::int32_t> b = batch;  // local, so that no store can alias it
  const std::size_t bytes = b.height * BitBytes(b.width);
  std::uint8_t* rows = result.bits;
  for (std::size_t t = 0; t < b.n; ++t, rows += bytes) {
    IncrementalTriangle<kClipped>(b, t, rows, (b.n - 1 - t) * bytes);
  }
}

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

#endif  // include guard that Highway toggles
