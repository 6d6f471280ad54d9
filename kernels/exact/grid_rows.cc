#include "kernels/exact/grid_rows.h"

#include <cstring>

namespace pitbench {
namespace {

// Differences of int32 have 33 bits, their products 66.
__extension__ using Wide = __int128;

struct Edge {
  Wide a, b, c;  // a·x + b·y + c, positive on the left of the edge

  Edge(std::int32_t vx, std::int32_t vy, std::int32_t wx, std::int32_t wy)
      : a(Wide{vy} - wy), b(Wide{wx} - vx), c(-(a * vx + b * vy)) {}
  Wide At(std::size_t x, std::size_t y) const {
    return a * static_cast<Wide>(x) + b * static_cast<Wide>(y) + c;
  }
};

}  // namespace

void WriteGridRowsExactly(const Batch<std::int32_t>& batch, std::size_t t,
                          std::uint8_t* rows) {
  const Edge edges[] = {{batch.ax[t], batch.ay[t], batch.bx[t], batch.by[t]},
                        {batch.bx[t], batch.by[t], batch.cx[t], batch.cy[t]},
                        {batch.cx[t], batch.cy[t], batch.ax[t], batch.ay[t]}};
  const std::size_t row_bytes = BitBytes(batch.width);
  std::memset(rows, 0, row_bytes * batch.height);
  // The sum of the three is twice the area, everywhere.
  const Wide area = edges[0].c + edges[1].c + edges[2].c;
  if (area == 0) return;
  const Wide winding = area > 0 ? 1 : -1;
  for (std::size_t y = 0; y < batch.height; ++y) {
    for (std::size_t x = 0; x < batch.width; ++x) {
      bool inside = true;
      for (const Edge& edge : edges) inside &= winding * edge.At(x, y) >= 0;
      rows[y * row_bytes + x / 8] = static_cast<std::uint8_t>(
          rows[y * row_bytes + x / 8] | (inside ? 1u << (x % 8) : 0u));
    }
  }
}

}  // namespace pitbench
