// Loop grid: its contract on memory, and its answers against brute force.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "harness/scenes/random.h"
#include "harness/truth/truth.h"
#include "kernels/kernels.h"
#include "tests/guarded_memory.h"
#include "tests/kernel_answers.h"

namespace pitbench {
namespace {

using Coordinate = std::int32_t;

// Random triangles with vertices from `low` to `high`; every fifth one is
// degenerate, by a doubled vertex or by collinear ones.
std::vector<Triangle<Coordinate>> RandomTriangles(std::size_t count,
                                                  Coordinate low,
                                                  Coordinate high) {
  Random random(11);
  const auto draw = [&] {
    return static_cast<Coordinate>(
        low + static_cast<std::int64_t>(random.Below(
                  static_cast<std::uint64_t>(std::int64_t{high} - low + 1))));
  };
  std::vector<Triangle<Coordinate>> triangles;
  for (std::size_t i = 0; i < count; ++i) {
    Triangle<Coordinate>& t = triangles.emplace_back();
    for (Point<Coordinate>* p : {&t.a, &t.b, &t.c}) *p = {draw(), draw()};
    if (i % 10 == 3) t.c = t.a;
    if (i % 10 == 8) {
      t.a = {t.a.x / 2, t.a.y / 2};
      t.b = {t.b.x / 2, t.b.y / 2};
      t.c = {2 * t.b.x - t.a.x, 2 * t.b.y - t.a.y};
    }
  }
  return triangles;
}

struct Grid {
  std::size_t width;
  std::size_t height;

  std::size_t Bytes(std::size_t triangles) const {
    return triangles * height * BitBytes(width);
  }
};

std::vector<std::uint8_t> BruteForce(
    const std::vector<Triangle<Coordinate>>& triangles, const Grid& grid) {
  std::vector<std::uint8_t> bits(grid.Bytes(triangles.size()));
  std::uint8_t* row = bits.data();
  for (const Triangle<Coordinate>& t : triangles) {
    for (std::size_t y = 0; y < grid.height; ++y) {
      for (std::size_t x = 0; x < grid.width; ++x) {
        const Position position = Classify<Coordinate>(
            t, {static_cast<Coordinate>(x), static_cast<Coordinate>(y)});
        if (position == Position::kInside || position == Position::kBoundary) {
          row[x / 8] = static_cast<std::uint8_t>(row[x / 8] | 1u << (x % 8));
        }
      }
      row += BitBytes(grid.width);
    }
  }
  return bits;
}

class KernelGridTest : public testing::TestWithParam<const Kernel*> {
 protected:
  // What the kernel writes, its arrays ending where pages that trap begin.
  static std::vector<std::uint8_t> Ask(
      const std::vector<Triangle<Coordinate>>& triangles, const Grid& grid) {
    const std::size_t n = triangles.size();
    const std::size_t bytes = grid.Bytes(n);
    const GuardedMemory coordinates[6] = {
        GuardedMemory(n * 4), GuardedMemory(n * 4), GuardedMemory(n * 4),
        GuardedMemory(n * 4), GuardedMemory(n * 4), GuardedMemory(n * 4)};
    Coordinate* arrays[6];
    for (std::size_t k = 0; k < 6; ++k) {
      arrays[k] = coordinates[k].AtEnd<Coordinate>(n);
    }
    for (std::size_t i = 0; i < n; ++i) {
      const Triangle<Coordinate>& t = triangles[i];
      const Coordinate values[] = {t.a.x, t.a.y, t.b.x, t.b.y, t.c.x, t.c.y};
      for (std::size_t k = 0; k < 6; ++k) arrays[k][i] = values[k];
    }
    const GuardedMemory output(bytes);
    output.Fill(0xA5);
    auto* const bits = output.AtEnd<std::uint8_t>(bytes);
    const Batch<Coordinate> batch{arrays[0], arrays[1],  arrays[2],  arrays[3],
                                  arrays[4], arrays[5],  nullptr,    nullptr,
                                  n,         grid.width, grid.height};
    GetParam()->i32(batch, {.bits = bits});
    EXPECT_TRUE(std::all_of(output.AtStart<std::uint8_t>(), bits,
                            [](std::uint8_t byte) { return byte == 0xA5; }));
    return {bits, bits + bytes};
  }
};

TEST_P(KernelGridTest, EveryWidthAndHeightIsWrittenWholeAndNothingElse) {
  for (std::size_t width = 0; width <= 82; ++width) {
    for (std::size_t height = 0; height <= 3; ++height) {
      for (const std::size_t n : {0, 1, 3}) {
        const auto triangles =
            RandomTriangles(n, -5, static_cast<Coordinate>(width + 5));
        const Grid grid{width, height};
        ASSERT_EQ(Ask(triangles, grid), BruteForce(triangles, grid))
            << width << " x " << height << ", n = " << n;
      }
    }
  }
}

TEST_P(KernelGridTest, AgreesWithExactArithmeticOnThePublishedGrid) {
  const Grid grid{80, 50};
  const auto triangles = RandomTriangles(500, 0, 79);
  EXPECT_EQ(Ask(triangles, grid), BruteForce(triangles, grid));
}

TEST_P(KernelGridTest, AgreesWithExactArithmeticUpTo15Bits) {
  const Grid grid{17, 3};
  const auto triangles = RandomTriangles(5000, -16384, 16383);
  EXPECT_EQ(Ask(triangles, grid), BruteForce(triangles, grid));
}

TEST_P(KernelGridTest, EverySmallTriangleIsRightInEveryVertexOrder) {
  const Grid grid{5, 5};
  const auto triangles = WholeTriangles<Coordinate>(3);
  EXPECT_EQ(Ask(triangles, grid), BruteForce(triangles, grid));
}

INSTANTIATE_TEST_SUITE_P(Every, KernelGridTest,
                         testing::ValuesIn(KernelsWhere([](const Kernel& k) {
                           return k.loop == Loop::kGrid;
                         })),
                         KernelName());

}  // namespace
}  // namespace pitbench
