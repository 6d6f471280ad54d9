// The exact methods are right for every finite input.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "harness/measure/verify.h"
#include "harness/scenes/random.h"
#include "harness/truth/expected.h"
#include "kernels/exact/contains.h"
#include "tests/kernel_answers.h"

namespace pitbench {
namespace {

// Sanitizers and emulators take ten times as long.
#if PITBENCH_EMULATED || defined(__SANITIZE_ADDRESS__)
constexpr std::size_t kHardPoints = 300'000;
constexpr int kRandomInputs = 10'000;
#else
constexpr std::size_t kHardPoints = 10'000'000;
constexpr int kRandomInputs = 300'000;
#endif

template <class T>
class ExactTest : public testing::Test {
 protected:
  static std::vector<const Kernel*> ExactKernels() {
    return KernelsWhere([](const Kernel& k) {
      return IsExact(k) && k.scalar == ScalarOf<T>();
    });
  }
};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(ExactTest, Scalars);

TYPED_TEST(ExactTest, NoErrorOnHardPoints) {
  const std::vector<const Kernel*> kernels = this->ExactKernels();
  ASSERT_GE(kernels.size(), 9u);
  const Verification v = Verify<TypeParam>(kernels, kHardPoints, 1);
  EXPECT_GE(v.points, kHardPoints);
  EXPECT_GT(v.boundary, kHardPoints / 100);
  EXPECT_EQ(v.wrong, 0u) << v.first_wrong;
}

// A method that rounds does not pass the same verification.
TYPED_TEST(ExactTest, VerificationFindsAMethodThatRounds) {
  const Verification v = Verify<TypeParam>(
      KernelsWhere([](const Kernel& k) {
        return k.method.key == "cross_product" && k.isa == Isa::kScalar &&
               k.scalar == ScalarOf<TypeParam>() && k.output == Output::kInside;
      }),
      10'000, 1);
  EXPECT_GT(v.wrong, 100u);
  EXPECT_NE(v.first_wrong.find("cross_product on scalar"), std::string::npos);
}

// Any bits that are a finite number, of every exponent; coordinates repeat, so
// that determinants vanish.
template <class T>
T AnyFinite(Random& random) {
  using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
  while (true) {
    const T x = std::bit_cast<T>(static_cast<Bits>(random.Bits()));
    if (std::isfinite(x)) return x;
  }
}

TYPED_TEST(ExactTest, AnyBitsAgreeWithTruth) {
  using T = TypeParam;
  Random random(7);
  int boundary = 0;
  for (int k = 0; k < kRandomInputs; ++k) {
    std::vector<T> numbers(2 + random.Below(5));
    for (T& x : numbers) x = AnyFinite<T>(random);
    const auto draw = [&] { return numbers[random.Below(numbers.size())]; };
    const T ax = draw(), ay = draw(), bx = draw(), by = draw();
    const T cx = draw(), cy = draw(), px = draw(), py = draw();
    const Triangle<T> t{{ax, ay}, {bx, by}, {cx, cy}};
    const Point<T> p{px, py};
    ASSERT_EQ(ExactOrientation<T>({ax, ay, bx, by, cx, cy}),
              OrientationExactly(t.a, t.b, t.c))
        << t;
    const Position position = ClassifyExactly(t, p);
    boundary += position == Position::kBoundary ? 1 : 0;
    for (const Boundary rule :
         {Boundary::kClosed, Boundary::kOpen, Boundary::kTopLeft}) {
      const bool inside =
          position == Position::kInside ||
          (position == Position::kBoundary && BoundaryCounts(rule, t, p));
      ASSERT_EQ(ExactlyContains<T>(rule, {ax, ay, bx, by, cx, cy}, px, py),
                inside)
          << p << " in " << t << ", " << Name(rule);
    }
  }
  EXPECT_GT(boundary, kRandomInputs / 100);
}

// Of the triangles around an inner point that is a vertex, or lies on an edge,
// exactly one claims it.
TYPED_TEST(ExactTest, TopLeftGivesEveryPointOfAMeshToOneTriangle) {
  using T = TypeParam;
  for (const Kernel* kernel : this->ExactKernels()) {
    if (kernel->method.key != "exact_top_left") continue;
    Random random(9);
    for (int k = 0; k < 200; ++k) {
      // A hub, and a rim around it in counter-clockwise order.
      const auto hub_x = static_cast<T>(random.In(-0.25, 0.25));
      const Point<T> hub{hub_x, static_cast<T>(random.In(-0.25, 0.25))};
      const Point<T> rim[] = {
          {1, static_cast<T>(random.In(-0.5, 0.5))},
          {static_cast<T>(random.In(-0.5, 0.5)), 1},
          {-1, static_cast<T>(random.In(-0.5, 0.5))},
          {static_cast<T>(random.In(-0.5, 0.5)), -1},
      };
      std::vector<Triangle<T>> fan;
      std::vector<Point<T>> points = {hub};
      for (std::size_t i = 0; i < 4; ++i) {
        fan.push_back({hub, rim[i], rim[(i + 1) % 4]});
        if (random.Below(2) == 0) std::swap(fan.back().a, fan.back().c);
        // Near the spoke, and on it where halves are exact.
        for (const T s : {T{0.5}, T{0.25}, static_cast<T>(random.Unit() / 2)}) {
          points.push_back(
              {hub.x + s * (rim[i].x - hub.x), hub.y + s * (rim[i].y - hub.y)});
        }
      }
      const AnswerTable<T> table = AskAll(*kernel, fan, points);
      for (std::size_t p = 0; p < points.size(); ++p) {
        int claims = 0;
        for (std::size_t t = 0; t < fan.size(); ++t) {
          claims += table.Inside(t, p) ? 1 : 0;
        }
        ASSERT_EQ(claims, 1) << NameOf(*kernel) << ": " << points[p];
      }
    }
  }
}

}  // namespace
}  // namespace pitbench
