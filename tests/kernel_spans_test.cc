// Loop grid on the scene that is published: a million triangles, every pixel,
// every kernel that runs here, against integer arithmetic.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

#include "harness/scenes/random.h"
#include "kernels/kernels.h"
#include "tests/kernel_answers.h"

namespace pitbench {
namespace {

using Coordinate = std::int32_t;

#if PITBENCH_SLOW
constexpr std::size_t kTriangles = 4000;
#else
constexpr std::size_t kTriangles = 1000000;
#endif

struct Triangles {
  std::vector<Coordinate> ax, ay, bx, by, cx, cy;

  void Add(Coordinate x0, Coordinate y0, Coordinate x1, Coordinate y1,
           Coordinate x2, Coordinate y2) {
    ax.push_back(x0);
    ay.push_back(y0);
    bx.push_back(x1);
    by.push_back(y1);
    cx.push_back(x2);
    cy.push_back(y2);
  }
  std::size_t size() const { return ax.size(); }
};

// A·x + B·y + C of the edge from (vx, vy) to (wx, wy) times `sign`, in row y:
// its value in column 0 and what a column adds.
struct EdgeInRow {
  int at_0, right;

  EdgeInRow(int sign, int vx, int vy, int wx, int wy, int y)
      : at_0(sign * ((wx - vx) * (y - vy) + (wy - vy) * vx)),
        right(-sign * (wy - vy)) {}
};

// Appends the rows of triangle i to `to`, a bit a pixel: plainly the
// definition, and written so that the compiler makes it fast; for coordinates
// that int has room for.
void AppendBruteForce(const Triangles& t, std::size_t i, std::size_t width,
                      std::size_t height, std::vector<std::uint8_t>& to) {
  const int ax = t.ax[i], ay = t.ay[i], bx = t.bx[i], by = t.by[i];
  const int cx = t.cx[i], cy = t.cy[i];
  const int area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
  const int sign = area > 0 ? 1 : -1;
  std::uint8_t inside[208] = {};
  const int columns = static_cast<int>(width);
  for (int y = 0; y < static_cast<int>(height); ++y) {
    const EdgeInRow ab(sign, ax, ay, bx, by, y);
    const EdgeInRow bc(sign, bx, by, cx, cy, y);
    const EdgeInRow ca(sign, cx, cy, ax, ay, y);
    int e0 = ab.at_0;
    int e1 = bc.at_0;
    int e2 = ca.at_0;
    for (int x = 0; x < columns; ++x) {
      inside[x] = static_cast<std::uint8_t>((e0 | e1 | e2) >= 0);
      e0 += ab.right;
      e1 += bc.right;
      e2 += ca.right;
    }
    for (std::size_t x = 0; x < width; x += 8) {
      std::uint64_t bytes;
      std::memcpy(&bytes, inside + x, 8);
      // Gathers the last bit of byte k into bit 56 + k.
      to.push_back(static_cast<std::uint8_t>(
          area == 0 ? 0 : (bytes * 0x0102040810204080u) >> 56));
    }
  }
}

// All kernels of loop grid; but the published scene asks only those that are
// made for it, edge_function being a hundred times slower.
const std::vector<const Kernel*>& GridKernels(bool all) {
  // Once: asking the CPU is slow on a virtual one.
  static const auto every =
      KernelsWhere([](const Kernel& k) { return k.loop == Loop::kGrid; });
  static const auto spans = KernelsWhere([](const Kernel& k) {
    return k.loop == Loop::kGrid && k.method.key.starts_with("row_spans");
  });
  return all ? every : spans;
}

// Expects of every kernel what brute force says of these triangles.
void ExpectBruteForce(const Triangles& t, std::size_t width, std::size_t height,
                      const std::vector<const Kernel*>& kernels) {
  std::vector<std::uint8_t> expected;
  for (std::size_t i = 0; i < t.size(); ++i) {
    AppendBruteForce(t, i, width, height, expected);
  }
  const Batch<Coordinate> batch{t.ax.data(), t.ay.data(), t.bx.data(),
                                t.by.data(), t.cx.data(), t.cy.data(),
                                nullptr,     nullptr,     t.size(),
                                width,       height};
  std::vector<std::uint8_t> bits(expected.size());
  for (const Kernel* kernel : kernels) {
    std::fill(bits.begin(), bits.end(), std::uint8_t{0xA5});
    kernel->i32(batch, {.bits = bits.data()});
    ASSERT_TRUE(bits == expected)
        << NameOf(*kernel) << " on " << width << " x " << height;
  }
}

TEST(KernelSpansTest, AMillionTrianglesOfThePublishedGridAreRight) {
  constexpr std::size_t kBlock = 1000;
  Random random(5);
  const auto x = [&] { return static_cast<Coordinate>(random.Below(80)); };
  const auto y = [&] { return static_cast<Coordinate>(random.Below(50)); };
  for (std::size_t done = 0; done < kTriangles; done += kBlock) {
    Triangles t;
    for (std::size_t i = 0; i < kBlock; ++i)
      t.Add(x(), y(), x(), y(), x(), y());
    ExpectBruteForce(t, 80, 50, GridKernels(false));
  }
}

// A right triangle on either side of every edge that the largest grid of spans
// can hold, so every divisor and every slope.
TEST(KernelSpansTest, EverySlopeIsRightOnTheLargestGrid) {
  constexpr Coordinate kStep = kTriangles < 1000000 ? 7 : 1;
  for (Coordinate dy = 1; dy < 64; ++dy) {
    Triangles t;
    for (Coordinate dx = 0; dx < 128; dx += kStep) {
      t.Add(0, 0, dx, dy, 0, dy);
      t.Add(127, 63, 127 - dx, 63 - dy, 127, 63 - dy);
      t.Add(127, 63 - dy, 127 - dx, 63, 127, 63);
      t.Add(0, dy, dx, 0, 0, 0);
    }
    ExpectBruteForce(t, 128, 64, GridKernels(false));
  }
}

// Around the sizes where another way of writing begins: rows of ten bytes, 16
// bytes, 32 and 64 rows; and a few triangles beside the grid or with a
// coordinate that is just outside.
TEST(KernelSpansTest, OtherSizesAndTrianglesPartlyOutsideAreRight) {
  struct Size {
    std::size_t width, height;
  };
  for (const auto& [width, height] :
       {Size{80, 49}, Size{80, 50}, Size{80, 51}, Size{80, 64}, Size{80, 65},
        Size{73, 33}, Size{72, 32}, Size{81, 31}, Size{80, 1}, Size{77, 2},
        Size{128, 64}, Size{127, 63}, Size{129, 64}, Size{200, 70}, Size{1, 64},
        Size{8, 7}, Size{16, 16}, Size{121, 5}}) {
    for (const std::size_t n : {1, 2, 31, 33, 70}) {
      Random random(n);
      Triangles t;
      for (std::size_t i = 0; i < n; ++i) {
        // Every fourth triangle may reach out by a few pixels, or far.
        const Coordinate out = i % 4 != 3 ? 0 : i % 8 == 3 ? 3 : 900;
        const auto in = [&](std::size_t end) {
          return static_cast<Coordinate>(
                     random.Below(end + 2 * static_cast<std::size_t>(out))) -
                 out;
        };
        t.Add(in(width), in(height), in(width), in(height), in(width),
              in(height));
      }
      ExpectBruteForce(t, width, height, GridKernels(true));
    }
  }
}

// edge_function declares 15 bits; the others have no such bound.
TEST(KernelSpansTest, NoCoordinateIsTooLarge) {
  constexpr Coordinate kLeast = INT32_MIN;
  constexpr Coordinate kMost = INT32_MAX;
  Triangles t;
  t.Add(kLeast, kLeast, kMost, kLeast, kLeast, kMost);  // contains the grid
  t.Add(kMost, kMost, kMost, kLeast, kLeast, kMost);    // does not
  t.Add(kLeast, -1, kMost, 3, kMost, 1);
  t.Add(kMost, kMost, kLeast, kLeast, 0, 2);
  t.Add(kMost, kMost, kMost, kMost, kMost, kMost);
  t.Add(0, 0, 40000, 0, 0, 40000);
  t.Add(1, 1, 7, 2, 3, 4);
  const Batch<Coordinate> batch{t.ax.data(),
                                t.ay.data(),
                                t.bx.data(),
                                t.by.data(),
                                t.cx.data(),
                                t.cy.data(),
                                nullptr,
                                nullptr,
                                t.size(),
                                11,
                                5};
  for (const Kernel* kernel : GridKernels(true)) {
    if (kernel->method.key == "edge_function") continue;
    std::vector<std::uint8_t> bits(t.size() * 5 * 2);
    kernel->i32(batch, {.bits = bits.data()});
    for (std::size_t i = 0; i < t.size(); ++i) {
      for (Coordinate y = 0; y < 5; ++y) {
        for (Coordinate x = 0; x < 11; ++x) {
          const Position position = Classify<Coordinate>(
              {{t.ax[i], t.ay[i]}, {t.bx[i], t.by[i]}, {t.cx[i], t.cy[i]}},
              {x, y});
          const std::size_t byte = (i * 5 + static_cast<std::size_t>(y)) * 2 +
                                   static_cast<std::size_t>(x) / 8;
          ASSERT_EQ(
              (bits[byte] >> (x % 8) & 1) != 0,
              position == Position::kInside || position == Position::kBoundary)
              << NameOf(*kernel) << ", triangle " << i << ", pixel " << x
              << ", " << y;
        }
      }
    }
  }
}

}  // namespace
}  // namespace pitbench
