// The exact methods are right for every finite input.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "harness/measure/verify.h"
#include "harness/scenes/random.h"
#include "harness/truth/expected.h"
#include "kernels/exact/contains.h"
#include "tests/judged_scene.h"
#include "tests/kernel_answers.h"

namespace pitbench {
namespace {

// Sanitizers and emulators take ten times as long.
#if PITBENCH_SLOW
constexpr std::size_t kHardPoints = 300'000;
constexpr int kRandomInputs = 10'000;
constexpr std::size_t kPlaces = 5;
#else
constexpr std::size_t kHardPoints = 10'000'000;
constexpr int kRandomInputs = 300'000;
constexpr std::size_t kPlaces = 40;
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
  ASSERT_GE(kernels.size(), 12u);
  const auto asked = [&](Loop loop) {
    return Verify<TypeParam>(KernelsWhere([loop](const Kernel& k) {
                               return IsExact(k) && k.loop == loop &&
                                      k.isa == Isa::kScalar &&
                                      k.scalar == ScalarOf<TypeParam>();
                             }),
                             1000, 1)
        .answers;
  };
  EXPECT_GT(asked(Loop::kOneTriangle), 0u);
  EXPECT_EQ(asked(Loop::kOneTriangleAos), asked(Loop::kOneTriangle));
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

// One or two points on an edge, or an ulp beside it, among so many that are
// decided that loops answer many together: they alone are decided again, and
// nothing else changes.
TYPED_TEST(ExactTest, PointsNearAnEdgeAmongManyThatAreNot) {
  using T = TypeParam;
  constexpr std::size_t kMany = 5000;
  constexpr std::size_t kApart = 1 + kMany / kPlaces;
  const T y = T{0.5};
  const std::vector<Point<T>> near_edge = {
      {2, y}, {2, std::nextafter(y, T{0})}, {2, std::nextafter(y, T{1})}};
  for (const Kernel* kernel : this->ExactKernels()) {
    if (kernel->loop == Loop::kOnePoint) continue;  // items are triangles
    for (const Triangle<T>& t :
         {Triangle<T>{{0, 0}, {4, 1}, {1, 4}},     // two edges below, one above
          Triangle<T>{{0, 0}, {1, -3}, {4, 1}},    // one below, two above
          Triangle<T>{{4, 1}, {0, 0}, {4, 4}}}) {  // with a vertical edge
      for (std::size_t k = 0; k < kPlaces; ++k) {
        std::vector<Point<T>> points(kMany);
        for (std::size_t i = 0; i < kMany; ++i) {
          points[i] = i % 3 == 0 ? Point<T>{2, 2} : Point<T>{2, -1};
        }
        points[k * kApart % kMany] = near_edge[k % 3];
        points[(k * kApart + 77 * k) % kMany] = near_edge[(k + 1) % 3];
        const AnswerTable<T> table = AskAll<T>(*kernel, {t}, points);
        for (std::size_t i = 0; i < kMany; ++i) {
          ASSERT_EQ(table.Inside(0, i), Expected(kernel->method, t, points[i]))
              << NameOf(*kernel) << ", item " << i << ": " << points[i]
              << " in " << t;
        }
      }
    }
  }
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

// Points off, on and at the ends of the edges of a mesh: exactly one of the
// triangles around them claims each.
TYPED_TEST(ExactTest, TopLeftGivesEveryPointOfAMeshToOneTriangle) {
  for (const Kernel* kernel : this->ExactKernels()) {
    if (kernel->method.boundary != Boundary::kTopLeft) continue;
    for (const char* mesh : {"pair", "fan", "triangulation"}) {
      for (const int ulps : {0, 1}) {
        const Scene<TypeParam>& scene =
            FindJudgedScene<TypeParam>(
                "mesh_" + std::string(mesh) + ":ulps=" + std::to_string(ulps),
                LoopOfScenes(kernel->loop))
                .scene;
        ASSERT_FALSE(scene.query.empty());
        const Array<TypeParam> xy = PointsFor(*kernel, scene);
        std::vector<int> claims;
        std::size_t answer = 0;
        for (const Call& call : scene.calls) {
          std::vector<std::uint8_t> bits(scene.OutputBytes(call));
          FunctionOf<TypeParam> (*kernel)(
              scene.BatchOf(call, xy.data()),
              Result<TypeParam>{.bits = bits.data()});
          for (std::size_t i = 0; i < call.n; ++i, ++answer) {
            const std::size_t query = scene.query[answer];
            if (claims.size() <= query) claims.resize(query + 1);
            claims[query] += (bits[i / 8] >> (i % 8) & 1) != 0 ? 1 : 0;
          }
        }
        EXPECT_EQ(std::count(claims.begin(), claims.end(), 1),
                  static_cast<std::ptrdiff_t>(claims.size()))
            << NameOf(*kernel) << ", " << scene.name;
      }
    }
  }
}

}  // namespace
}  // namespace pitbench
