// Every method agrees with exact arithmetic where it has to: on uniform random
// input, and where its own arithmetic is exact, boundary included.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "harness/measure/answers.h"
#include "harness/truth/expected.h"
#include "harness/truth/weights.h"
#include "kernels/kernels.h"
#include "tests/judged_scene.h"
#include "tests/kernel_answers.h"

namespace pitbench {
namespace {

// 256 sets of 4 kB; of pairs 32 of 32 kB.
template <class T>
const JudgedScene<T>& Uniform(Loop loop) {
  return FindJudgedScene<T>(loop == Loop::kPairs
                                ? "uniform:hit=50:bytes=32k:sets=fresh"
                                : "uniform:hit=50:bytes=4k:sets=fresh",
                            loop);
}

class KernelTruthTest : public testing::TestWithParam<const Kernel*> {
 protected:
  bool AcceptsAThird() const {
    return GetParam()->method.accepts == Accepts::kThirdNearVertexA;
  }
  bool Snaps() const { return GetParam()->method.snap_distance > 0; }
};

TEST_P(KernelTruthTest, UniformPointsAreAllRight) {
  if (AcceptsAThird() || Snaps()) return;
  WithFloatOf(*GetParam(), [&]<class T>(T) {
    const auto& [scene, truth] = Uniform<T>(GetParam()->loop);
    EXPECT_GT(truth.interior, 1000u);
    EXPECT_GT(truth.exterior, 1000u);
    const Answers<T> answers = Ask(*GetParam(), scene, truth);
    EXPECT_EQ(answers.wrong.size(), 0u);
    EXPECT_EQ(answers.stray_bits, 0u);
  });
}

// Some are wrong, and none of them farther from the boundary than declared;
// less than was declared is too little.
TEST_P(KernelTruthTest, UniformPointsAreRightButWithinTheSnapDistance) {
  if (!Snaps()) return;
  WithFloatOf(*GetParam(), [&]<class T>(T) {
    const auto& [scene, truth] = Uniform<T>(GetParam()->loop);
    const Answers<T> answers = Ask(*GetParam(), scene, truth);
    EXPECT_GT(answers.wrong.size(), 50u);
    EXPECT_LT(answers.wrong.size(), (truth.interior + truth.exterior) / 50);
    EXPECT_EQ(Refusal(*GetParam(), scene, truth), std::nullopt);
    Kernel tenth = *GetParam();
    tenth.method.snap_distance /= 10;
    EXPECT_NE(Refusal(tenth, scene, truth), std::nullopt);
  });
}

// A third of the triangles with whole vertices up to 3.
template <class T>
std::vector<Triangle<T>> SmallTriangles() {
  const std::vector<Triangle<T>> all = WholeTriangles<T>(3);
  std::vector<Triangle<T>> some;
  for (std::size_t k = 0; k < all.size(); k += 3) some.push_back(all[k]);
  return some;
}

// Expected for each of them and every whole point up to 3, computed once for
// each kind of method.
template <class T>
const std::vector<bool>& ExpectedOnWholePoints(const Method& method) {
  static std::map<std::pair<Boundary, Accepts>, std::vector<bool>> all;
  std::vector<bool>& expected = all[{method.boundary, method.accepts}];
  if (!expected.empty()) return expected;
  for (const Triangle<T>& t : SmallTriangles<T>()) {
    for (const Point<T>& p : WholePoints<T>(3)) {
      expected.push_back(Expected(method, t, p));
    }
  }
  return expected;
}

// Twice the area; exact for small whole coordinates.
template <class T>
double DoubleArea(const Triangle<T>& t) {
  const auto wide = [](T x) { return static_cast<double>(x); };
  return std::abs((wide(t.b.x) - wide(t.a.x)) * (wide(t.c.y) - wide(t.a.y)) -
                  (wide(t.b.y) - wide(t.a.y)) * (wide(t.c.x) - wide(t.a.x)));
}

// Whether each edge reaches 0 or a power of two along x; up to 2, as here,
// means any of 0, 1 and 2, so small triangles are all but a few.
template <class T>
bool RunsArePowersOfTwo(const Triangle<T>& t) {
  const auto is = [](T run) {
    int exponent = 0;
    return run == 0 || std::abs(std::frexp(run, &exponent)) == T{0.5};
  };
  return is(t.b.x - t.a.x) && is(t.c.x - t.b.x) && is(t.a.x - t.c.x);
}

// On small whole coordinates every product and sum is exact, so every answer
// has to be: edges, vertices, both windings, degenerate triangles. A method
// that divides, by the area or by the edges, is exact where that is a power of
// two.
TEST_P(KernelTruthTest, ExactlyRepresentableInputIsRightOnTheBoundaryToo) {
  const Kernel& kernel = *GetParam();
  if (Snaps()) return;
  WithFloatOf(kernel, [&]<class T>(T) {
    const std::vector<Triangle<T>> triangles = SmallTriangles<T>();
    const std::vector<Point<T>> points = WholePoints<T>(3);
    const std::vector<bool>& expected = ExpectedOnWholePoints<T>(kernel.method);
    const AnswerTable<T> table = AskAll(kernel, triangles, points);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      int exponent = 0;
      const double half = std::frexp(DoubleArea(triangles[t]), &exponent);
      if (DividesByArea(kernel) && half != 0 && half != 0.5) continue;
      if (DividesByRuns(kernel) && !RunsArePowersOfTwo(triangles[t])) continue;
      for (std::size_t p = 0; p < points.size(); ++p) {
        ASSERT_EQ(table.Inside(t, p), expected[table.At(t, p)])
            << points[p] << " in " << triangles[t];
      }
    }
  });
}

// The rule by name, on one triangle: AB and AC are in, BC and its ends are not.
TEST_P(KernelTruthTest, HalfOpenMeansAbAndAcInAndBcOut) {
  const Kernel& kernel = *GetParam();
  if (kernel.method.boundary != Boundary::kHalfOpen) return;
  WithFloatOf(kernel, [&]<class T>(T) {
    const Triangle<T> counter_clockwise{{1, 1}, {5, 1}, {1, 5}};
    const Triangle<T> clockwise{{1, 1}, {1, 5}, {5, 1}};
    for (const Triangle<T>& t : {counter_clockwise, clockwise}) {
      for (const Point<T>& in :
           {Point<T>{1, 1}, Point<T>{3, 1}, Point<T>{1, 3}, Point<T>{2, 2}}) {
        EXPECT_TRUE(Says(kernel, t, in)) << in << " in " << t;
      }
      for (const Point<T>& out :
           {Point<T>{5, 1}, Point<T>{1, 5}, Point<T>{3, 3}, Point<T>{2, 4}}) {
        EXPECT_FALSE(Says(kernel, t, out)) << out << " in " << t;
      }
    }
  });
}

// Interior points whose weights are all at least 1/1000 apart from each other
// and from 0 leave rounding nothing to decide.
TEST_P(KernelTruthTest, AThirdIsWhereTheWeightOfAIsLargest) {
  if (!AcceptsAThird()) return;
  WithFloatOf(*GetParam(), [&]<class T>(T) {
    const auto& [scene, truth] = Uniform<T>(GetParam()->loop);
    const Answers<T> answers = Ask(*GetParam(), scene, truth);
    std::size_t accepted = 0;
    std::size_t rejected = 0;
    for (std::size_t c = 0; c < scene.calls.size(); c += 4) {
      for (std::size_t i = 0; i < scene.calls[c].n; i += 3) {
        const Triangle<T> t = scene.TriangleOf(scene.calls[c], i);
        const Point<T> p = scene.PointOf(scene.calls[c], i);
        if (!BitAt(truth.calls[c].inside, i)) continue;
        const std::array<mpq_class, 3> w = ExactWeights(t, p);
        const double lead = mpq_class(w[0] - std::max(w[1], w[2])).get_d();
        if (std::abs(lead) < 1e-3) continue;
        ASSERT_EQ(BitAt(answers.bits[c], i), lead > 0) << p << " in " << t;
        ++(lead > 0 ? accepted : rejected);
      }
    }
    EXPECT_GT(accepted, 50u);
    EXPECT_GT(rejected, accepted);
  });
}

INSTANTIATE_TEST_SUITE_P(Every, KernelTruthTest,
                         testing::ValuesIn(FloatInsideKernels()), KernelName());

}  // namespace
}  // namespace pitbench
