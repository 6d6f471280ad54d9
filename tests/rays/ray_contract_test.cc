// The contract of ray kernels (kernels/rays/README.md) where it speaks of
// memory: what a kernel reads, what it writes, and that an answer depends on
// its item alone.
#include <gtest/gtest.h>

#include <array>
#include <deque>
#include <limits>
#include <vector>

#include "harness/scenes/random.h"
#include "tests/placed_memory.h"
#include "tests/rays/ray_kernel_answers.h"

namespace pitbench {
namespace {

constexpr std::size_t kMost = 521;
constexpr std::size_t kDegenerate = 4;
constexpr std::size_t kNotFinite = 5;

template <class T>
struct Items {
  std::vector<Triangle3<T>> triangles;
  std::vector<Ray<T>> rays;
};

// Rays from below and from above of which about half meet the triangles, those
// of either winding; every ninth triangle is degenerate, every eleventh ray not
// finite.
template <class T>
Items<T> DrawItems() {
  Random random(7);
  const auto draw = [&] { return static_cast<T>(random.Unit()) - T{0.5}; };
  Items<T> items;
  for (std::size_t i = 0; i < kMost; ++i) {
    const Point3<T> a{draw() - 1, draw() - 1, draw()};
    const Point3<T> b{a.x + 3, a.y, draw()};
    const Point3<T> c{a.x, a.y + 3, draw()};
    const bool turned = i % 4 == 3;
    items.triangles.push_back({a, turned ? c : b,
                               i % 9 == kDegenerate ? a
                               : turned             ? b
                                                    : c});
    const T side = i % 3 == 0 ? T{3} : T{-3};
    items.rays.push_back({{draw(), draw(), side},
                          {draw(), draw(), -side / 3},
                          0,
                          std::numeric_limits<T>::infinity()});
    if (i % 11 == kNotFinite) {
      items.rays.back().direction.y = i % 2 == 0
                                          ? std::numeric_limits<T>::quiet_NaN()
                                          : std::numeric_limits<T>::infinity();
    }
  }
  return items;
}

template <class T>
struct Written {
  std::vector<std::uint8_t> bits;
  std::array<std::vector<T>, 3> tuv;
  std::size_t nearest = kNoTriangle;
};

// Calls of one kernel on guarded memory.
template <class T>
class Caller {
 public:
  // `fixed`: the element of the side that the loop does not batch.
  Caller(const RayKernel& kernel, const Items<T>& items, std::size_t fixed)
      : kernel_(kernel), items_(items), fixed_(fixed) {
    for (std::size_t k = 0; k < 20; ++k) {
      memory_.emplace_back((kMost + 64) * sizeof(double));
    }
  }

  // The kernel on items `first` to `first + n`; expects it to write nothing
  // but its output.
  Written<T> Call(std::size_t first, std::size_t n, Place place) {
    RayBatch<T> batch{};
    batch.n = n;
    batch.t_min = 0;
    batch.t_max = std::numeric_limits<T>::infinity();
    Xyz<T>* const inputs[] = {&batch.a, &batch.b, &batch.c, &batch.origin,
                              &batch.direction};
    for (std::size_t k = 0; k < 5; ++k) {
      const bool single = kernel_.loop == (k < 3 ? RayLoop::kOneTriangleRays
                                                 : RayLoop::kOneRay);
      const std::size_t count = single ? 1 : n;
      const T** const arrays[] = {&inputs[k]->x, &inputs[k]->y, &inputs[k]->z};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        T* const array = At<T>(memory_[3 * k + axis], count, place);
        for (std::size_t i = 0; i < count; ++i) {
          array[i] = Coordinate(k, axis, single ? fixed_ : first + i);
        }
        *arrays[axis] = array;
      }
    }
    const bool bits = kernel_.output != RayOutput::kNearest;
    const bool tuv = kernel_.output == RayOutput::kTuv;
    RayResult<T> result;
    Output<std::uint8_t> of_bits(memory_[15], bits ? BitBytes(n) : 0, place);
    Output<T> of_t(memory_[16], tuv ? n : bits ? 0 : 1, place);
    Output<T> of_u(memory_[17], tuv ? n : 0, place);
    Output<T> of_v(memory_[18], tuv ? n : 0, place);
    Output<std::size_t> of_nearest(memory_[19], bits ? 0 : 1, place);
    result.bits = of_bits.at;
    result.t = of_t.at;
    result.u = of_u.at;
    result.v = of_v.at;
    result.nearest = of_nearest.at;
    FunctionOf<T>(kernel_)(batch, result);

    Written<T> written{of_bits.Read(n),
                       {of_t.Read(n), of_u.Read(n), of_v.Read(n)}};
    if (const auto nearest = of_nearest.Read(n); !nearest.empty()) {
      written.nearest = nearest[0];
    }
    return written;
  }

 private:
  // An array to be written to, among canaries.
  template <class U>
  struct Output {
    Output(const GuardedMemory& memory, std::size_t n, Place place)
        : at(At<U>(memory, n, place)),
          count(n),
          around(memory, at, n * sizeof(U)) {
      around.Fill();
    }
    std::vector<U> Read(std::size_t n) const {
      EXPECT_TRUE(around.Intact()) << "n = " << n;
      return {at, at + count};
    }
    U* at;
    std::size_t count;
    Around around;
  };

  T Coordinate(std::size_t point, std::size_t axis, std::size_t item) const {
    const Triangle3<T>& t = items_.triangles[item];
    const Ray<T>& r = items_.rays[item];
    const Point3<T>& p =
        *std::array{&t.a, &t.b, &t.c, &r.origin, &r.direction}[point];
    return std::array{p.x, p.y, p.z}[axis];
  }

  const RayKernel& kernel_;
  const Items<T>& items_;
  std::size_t fixed_;
  std::deque<GuardedMemory> memory_;
};

class RayContractTest : public testing::TestWithParam<const RayKernel*> {
 protected:
  // Calls test(caller, alone), where alone[i] is what the kernel writes when
  // item i is all it is given.
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
        test(caller, alone);
        if (GetParam()->loop == RayLoop::kRayPairs) break;
      }
    });
  }

  // Else nothing would be compared with nothing.
  template <class T>
  static void ExpectBothKinds(const std::vector<Written<T>>& alone) {
    std::size_t hits = 0;
    for (const Written<T>& one : alone) {
      if (!one.bits.empty()) {
        ASSERT_LE(one.bits[0], 1);
        hits += one.bits[0];
      } else {
        hits += one.nearest == 0 ? 1u : 0u;
      }
    }
    EXPECT_GT(hits, alone.size() / 20);
    EXPECT_LT(hits, alone.size() * 19 / 20);
  }

  template <class T>
  static void ExpectAsAlone(const Written<T>& written,
                            const std::vector<Written<T>>& alone,
                            std::size_t first, std::size_t n) {
    const testing::Message where = testing::Message()
                                   << "first " << first << ", n = " << n;
    if (written.bits.empty() && n != 0) {
      ExpectNearestOfAlone(written, alone, first, n, where);
      return;
    }
    std::vector<std::uint8_t> bits(written.bits.size());
    std::size_t wrong_values = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const Written<T>& expected = alone[first + i];
      bits[i / 8] |= static_cast<std::uint8_t>(expected.bits[0] << (i % 8));
      for (std::size_t k = 0; k < 3 && !written.tuv[k].empty(); ++k) {
        const T value = written.tuv[k][i];
        wrong_values += Same(value, expected.tuv[k][0]) ? 0u : 1u;
        EXPECT_EQ(value == value, expected.bits[0] == 1) << where;
      }
    }
    // The bits past n as well: they are 0 in `bits`.
    EXPECT_EQ(written.bits, bits) << where;
    EXPECT_EQ(wrong_values, 0u) << where;
  }

  template <class T>
  static void ExpectNearestOfAlone(const Written<T>& written,
                                   const std::vector<Written<T>>& alone,
                                   std::size_t first, std::size_t n,
                                   const testing::Message& where) {
    std::size_t nearest = kNoTriangle;
    T t = std::numeric_limits<T>::quiet_NaN();
    for (std::size_t i = 0; i < n; ++i) {
      const Written<T>& one = alone[first + i];
      if (one.nearest == 0 && (nearest == kNoTriangle || one.tuv[0][0] < t)) {
        nearest = i;
        t = one.tuv[0][0];
      }
    }
    EXPECT_EQ(written.nearest, nearest) << where;
    EXPECT_TRUE(Same(written.tuv[0][0], t)) << where;
  }
};

TEST_P(RayContractTest, ReadsAndWritesNothingPastTheEndOfAnyArray) {
  ForEachFixedItem([&](auto& caller, const auto& alone) {
    for (const std::size_t n : SizesUpTo(kMost)) {
      ExpectAsAlone(caller.Call(0, n, kAtEnd), alone, 0, n);
    }
  });
}

TEST_P(RayContractTest, ReadsAndWritesNothingBeforeTheStartOfAnyArray) {
  ForEachFixedItem([&](auto& caller, const auto& alone) {
    for (const std::size_t n : SizesUpTo(kMost)) {
      ExpectAsAlone(caller.Call(0, n, kAtStart), alone, 0, n);
    }
  });
}

TEST_P(RayContractTest, AnswersAreTheSameAtEveryPositionAndAlignment) {
  ForEachFixedItem([&](auto& caller, const auto& alone) {
    for (std::size_t shift = 1; shift <= 17; ++shift) {
      for (const std::size_t n : {1, 15, 50, 129}) {
        const Place place{.at_end = false, .offset = shift};
        ExpectAsAlone(caller.Call(3 * shift, n, place), alone, 3 * shift, n);
      }
    }
  });
}

TEST_P(RayContractTest, NoTriangleIsTheNearestOfNone) {
  WithFloatOf(*GetParam(), [&]<class T>(T) {
    const Items<T> items = DrawItems<T>();
    const Written<T> none = Caller<T>(*GetParam(), items, 0).Call(0, 0, kAtEnd);
    EXPECT_EQ(none.nearest, kNoTriangle);
    if (GetParam()->output == RayOutput::kNearest) {
      EXPECT_NE(none.tuv[0][0], none.tuv[0][0]);
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Every, RayContractTest,
                         testing::ValuesIn(EveryRayKernel()), KernelName());

}  // namespace
}  // namespace pitbench
