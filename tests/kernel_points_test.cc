// Loop one_triangle on whole numbers: the contract on memory, and the answers
// against integer arithmetic in the range that each scalar declares.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "harness/scenes/random.h"
#include "kernels/kernels.h"
#include "tests/guarded_memory.h"
#include "tests/kernel_answers.h"

namespace pitbench {
namespace {

constexpr std::size_t kMost = 200;

class KernelPointsTest : public testing::TestWithParam<const Kernel*> {
 protected:
  // Calls test(T{}, low, high) with the kernel's scalar and the coordinates
  // for which its methods are exact.
  template <class Test>
  static void WithRange(const Test& test) {
    switch (GetParam()->scalar) {
      case Scalar::kI32:
        return test(std::int32_t{}, -16384, 16383);
      case Scalar::kI16:
        return test(std::int16_t{}, -64, 63);
      default:
        return test(std::uint8_t{}, 0, 127);
    }
  }

  // What the kernel says of n points, all arrays ending where pages that trap
  // begin, and nothing but the output written.
  template <class T>
  static std::vector<std::uint8_t> Ask(const Triangle<T>& t,
                                       const std::vector<Point<T>>& points) {
    const std::size_t n = points.size();
    static const GuardedMemory x(kMost * sizeof(T));
    static const GuardedMemory y(kMost * sizeof(T));
    static const GuardedMemory output(kMost);
    T* const px = x.AtEnd<T>(n);
    T* const py = y.AtEnd<T>(n);
    for (std::size_t i = 0; i < n; ++i) {
      px[i] = points[i].x;
      py[i] = points[i].y;
    }
    auto* const bits = output.AtEnd<std::uint8_t>(BitBytes(n));
    constexpr std::ptrdiff_t kBefore = 256;
    std::fill(bits - kBefore, bits + BitBytes(n), std::uint8_t{0xA5});
    const Batch<T> batch{&t.a.x, &t.a.y, &t.b.x, &t.b.y, &t.c.x,
                         &t.c.y, px,     py,     n};
    FunctionOf<T> (*GetParam())(batch, Result<T>{.bits = bits});
    EXPECT_TRUE(std::all_of(bits - kBefore, bits,
                            [](std::uint8_t byte) { return byte == 0xA5; }));
    return {bits, bits + BitBytes(n)};
  }

  template <class T>
  static std::vector<std::uint8_t> BruteForce(
      const Triangle<T>& t, const std::vector<Point<T>>& points) {
    std::vector<std::uint8_t> bits(BitBytes(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Position position = Classify(t, points[i]);
      if (position == Position::kInside || position == Position::kBoundary) {
        bits[i / 8] = static_cast<std::uint8_t>(bits[i / 8] | 1u << (i % 8));
      }
    }
    return bits;
  }
};

// From none to three of the widest vectors and one (64 bytes).
TEST_P(KernelPointsTest, EveryNumberOfPointsIsAnsweredAndNoMoreIsTouched) {
  WithRange([]<class T>(T, int low, int high) {
    Random random(3);
    const auto draw = [&]() -> Point<T> {
      const auto end = static_cast<std::uint64_t>(high - low + 1);
      const auto x = static_cast<T>(low + static_cast<int>(random.Below(end)));
      return {x, static_cast<T>(low + static_cast<int>(random.Below(end)))};
    };
    for (std::size_t n = 0; n <= kMost; ++n) {
      std::vector<Point<T>> points;
      for (std::size_t i = 0; i < n; ++i) points.push_back(draw());
      Triangle<T> t{draw(), draw(), draw()};
      if (n % 7 == 3) t.c = t.a;
      ASSERT_EQ(Ask(t, points), BruteForce(t, points)) << n;
    }
  });
}

// Corners of the range, where edge functions are largest, on each other.
TEST_P(KernelPointsTest, IsRightUpToTheEndsOfItsRange) {
  WithRange([]<class T>(T, int low, int high) {
    std::vector<Point<T>> points;
    for (const int x : {low, low + 1, (low + high) / 2, high - 1, high}) {
      for (const int y : {low, low + 1, (low + high) / 2, high - 1, high}) {
        points.push_back({static_cast<T>(x), static_cast<T>(y)});
      }
    }
    for (const Point<T>& a : points) {
      for (const Point<T>& b : points) {
        for (const Point<T>& c : points) {
          const Triangle<T> t{a, b, c};
          ASSERT_EQ(Ask(t, points), BruteForce(t, points)) << t;
        }
      }
    }
  });
}

TEST_P(KernelPointsTest, EverySmallTriangleIsRightInEveryVertexOrder) {
  WithRange([]<class T>(T, int, int) {
    const std::vector<Point<T>> points = WholePoints<T>(4);
    for (const Triangle<T>& t : WholeTriangles<T>(3)) {
      ASSERT_EQ(Ask(t, points), BruteForce(t, points)) << t;
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Every, KernelPointsTest,
                         testing::ValuesIn(KernelsWhere([](const Kernel& k) {
                           return !IsFloat(k.scalar) &&
                                  k.loop == Loop::kOneTriangle;
                         })),
                         KernelName());

}  // namespace
}  // namespace pitbench
