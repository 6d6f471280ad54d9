// The kernel contract (kernels/README.md) where it speaks of memory: what a
// kernel reads, what it writes, and that an answer depends on its item alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <deque>
#include <limits>
#include <vector>

#include "harness/scenes/random.h"
#include "kernels/kernels.h"
#include "tests/kernel_answers.h"
#include "tests/placed_memory.h"

namespace pitbench {
namespace {

constexpr std::size_t kMost = 1031;

template <class T>
struct Items {
  std::vector<Triangle<T>> triangles;
  std::vector<Point<T>> points;
};
constexpr std::size_t kDegenerate = 4;
constexpr std::size_t kNotFinite = 5;

// Triangles that contain about half of their points, most of them near A; every
// ninth triangle is degenerate, every eleventh point not finite.
template <class T>
Items<T> DrawItems() {
  Random random(7);
  const auto draw = [&]() -> Point<T> {
    const auto x = static_cast<T>(random.Unit());
    return {x, static_cast<T>(random.Unit())};
  };
  Items<T> items;
  for (std::size_t i = 0; i < kMost; ++i) {
    const Point<T> a{draw().x - T{0.5}, draw().y - T{0.5}};
    const Point<T> b{a.x + 3, a.y};
    const Point<T> c{a.x, a.y + (i % 4 == 3 ? T{-3} : T{3})};
    items.triangles.push_back({a, b, i % 9 == kDegenerate ? a : c});
    items.points.push_back(draw());
    if (i % 11 == kNotFinite) {
      items.points.back().y = i % 2 == 0 ? std::numeric_limits<T>::quiet_NaN()
                                         : std::numeric_limits<T>::infinity();
    }
  }
  // Contains the origin: lanes past the last item read zeros.
  items.triangles[0] = {{-0.25, -0.25}, {1.25, -0.25}, {-0.25, 1.25}};
  return items;
}

template <class T>
struct Written {
  std::vector<std::uint8_t> bits;
  std::array<std::vector<T>, 3> weights;
};

// Calls of one kernel on guarded memory.
template <class T>
class Caller {
 public:
  // `fixed`: the triangle of loops one_triangle and one_triangle_aos, the point
  // of one_point.
  Caller(const Kernel& kernel, const Items<T>& items, std::size_t fixed)
      : kernel_(kernel), items_(items), fixed_(fixed) {
    for (int k = 0; k < 12; ++k) {
      memory_.emplace_back((2 * kMost + 64) * sizeof(T));
    }
  }

  // The kernel on items `first` to `first + n`; expects it to write nothing
  // but its output.
  Written<T> Call(std::size_t first, std::size_t n, Place place) {
    Batch<T> batch{};
    const T** const inputs[] = {&batch.ax, &batch.ay, &batch.bx, &batch.by,
                                &batch.cx, &batch.cy, &batch.px, &batch.py};
    // Loop one_triangle_aos has no arrays but those of the triangle and one.
    const bool aos = kernel_.loop == Loop::kOneTriangleAos;
    for (std::size_t k = 0; k < (aos ? 6 : 8); ++k) {
      const bool single = LoopOfScenes(kernel_.loop) ==
                          (k < 6 ? Loop::kOneTriangle : Loop::kOnePoint);
      const std::size_t count = single ? 1 : n;
      T* const array = At<T>(memory_[k], count, place);
      for (std::size_t i = 0; i < count; ++i) {
        array[i] = Coordinate(k, single ? fixed_ : first + i);
      }
      *inputs[k] = array;
    }
    if (aos) {
      T* const pairs = At<T>(memory_[6], 2 * n, place);
      for (std::size_t i = 0; i < 2 * n; ++i) {
        pairs[i] = Coordinate(6 + i % 2, first + i / 2);
      }
      batch.pxy = pairs;
    }
    batch.n = n;
    for (std::size_t k = 8; k < 12; ++k) memory_[k].Fill(kCanary);
    std::uint8_t* const bits = At<std::uint8_t>(memory_[8], BitBytes(n), place);
    Result<T> result{.bits = bits};
    const bool weights = kernel_.output == Output::kWeights;
    for (std::size_t k = 0; k < 3 && weights; ++k) {
      result.w[k] = At<T>(memory_[9 + k], n, place);
      Around(memory_[9 + k], result.w[k], n * sizeof(T)).Fill();
    }
    FunctionOf<T>(kernel_)(batch, result);

    Written<T> written;
    written.bits.assign(bits, bits + BitBytes(n));
    EXPECT_TRUE(Around(memory_[8], bits, BitBytes(n)).Intact()) << n;
    for (std::size_t k = 0; k < 3 && weights; ++k) {
      written.weights[k].assign(result.w[k], result.w[k] + n);
      EXPECT_TRUE(Around(memory_[9 + k], result.w[k], n * sizeof(T)).Intact())
          << n << ", weight " << k;
    }
    return written;
  }

 private:
  T Coordinate(std::size_t array, std::size_t item) const {
    const Triangle<T>& t = items_.triangles[item];
    const Point<T>& p = items_.points[item];
    return std::array<T, 8>{
        t.a.x, t.a.y, t.b.x, t.b.y, t.c.x, t.c.y, p.x, p.y}[array];
  }

  const Kernel& kernel_;
  const Items<T>& items_;
  std::size_t fixed_;
  std::deque<GuardedMemory> memory_;
};

class KernelContractTest : public testing::TestWithParam<const Kernel*> {
 protected:
  // Calls test(T{}, caller, alone), where alone[i] is what the kernel writes
  // when item i is all it is given.
  template <class Test>
  void ForEachFixedItem(const Test& test) {
    WithFloatOf(*GetParam(), [&]<class T>(T) {
      const Items<T> items = DrawItems<T>();
      for (const std::size_t fixed :
           {std::size_t{0}, kDegenerate, kNotFinite}) {
        Caller<T> caller(*GetParam(), items, fixed);
        std::vector<Written<T>> alone;
        for (std::size_t i = 0; i < kMost; ++i) {
          alone.push_back(caller.Call(i, 1, kAtEnd));
        }
        if (fixed == 0) ExpectBothKinds(alone);
        test(T{}, caller, alone);
        if (GetParam()->loop == Loop::kPairs) break;  // has no fixed item
      }
    });
  }

  // Else nothing would be compared with nothing.
  template <class T>
  static void ExpectBothKinds(const std::vector<Written<T>>& alone) {
    std::size_t inside = 0;
    for (const Written<T>& one : alone) {
      ASSERT_LE(one.bits[0], 1);
      inside += one.bits[0];
    }
    EXPECT_GT(inside, alone.size() / 20);
    EXPECT_LT(inside, alone.size() * 19 / 20);
  }

  template <class T>
  static void ExpectAsAlone(const Written<T>& written,
                            const std::vector<Written<T>>& alone,
                            std::size_t first, std::size_t n) {
    std::vector<std::uint8_t> bits(BitBytes(n));
    std::size_t wrong_weights = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const Written<T>& expected = alone[first + i];
      bits[i / 8] |= static_cast<std::uint8_t>(expected.bits[0] << (i % 8));
      for (std::size_t k = 0; k < 3 && !written.weights[k].empty(); ++k) {
        wrong_weights +=
            Same(written.weights[k][i], expected.weights[k][0]) ? 0u : 1u;
      }
    }
    // The bits past n as well: they are 0 in `bits`.
    EXPECT_EQ(written.bits, bits) << "first " << first << ", n = " << n;
    EXPECT_EQ(wrong_weights, 0u) << "first " << first << ", n = " << n;
  }
};

TEST_P(KernelContractTest, ReadsAndWritesNothingPastTheEndOfAnyArray) {
  ForEachFixedItem([&](auto, auto& caller, const auto& alone) {
    for (const std::size_t n : SizesUpTo(kMost)) {
      ExpectAsAlone(caller.Call(0, n, kAtEnd), alone, 0, n);
    }
  });
}

TEST_P(KernelContractTest, ReadsAndWritesNothingBeforeTheStartOfAnyArray) {
  ForEachFixedItem([&](auto, auto& caller, const auto& alone) {
    for (const std::size_t n : SizesUpTo(kMost)) {
      ExpectAsAlone(caller.Call(0, n, kAtStart), alone, 0, n);
    }
  });
}

TEST_P(KernelContractTest, AnswersAreTheSameAtEveryPositionAndAlignment) {
  ForEachFixedItem([&](auto, auto& caller, const auto& alone) {
    for (std::size_t shift = 1; shift <= 17; ++shift) {
      for (const std::size_t n : {1, 15, 50, 129}) {
        const Place place{.at_end = false, .offset = shift};
        ExpectAsAlone(caller.Call(3 * shift, n, place), alone, 3 * shift, n);
      }
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Every, KernelContractTest,
                         testing::ValuesIn(FloatKernels()), KernelName());

}  // namespace
}  // namespace pitbench
