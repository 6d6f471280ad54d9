// The kernels that write barycentric weights: how right they are, and that
// they answer as those that do not.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "harness/measure/answers.h"
#include "harness/truth/weights.h"
#include "kernels/kernels.h"
#include "tests/judged_scene.h"
#include "tests/kernel_answers.h"

namespace pitbench {
namespace {

class KernelWeightsTest : public testing::TestWithParam<const Kernel*> {};

// The largest coordinate over the smallest altitude.
template <class T>
double SizeOverAltitude(const Triangle<T>& t, const Point<T>& p) {
  const auto wide = [](T x) { return static_cast<double>(x); };
  double size = 0;
  for (const T x : {t.a.x, t.a.y, t.b.x, t.b.y, t.c.x, t.c.y, p.x, p.y}) {
    size = std::max(size, std::abs(wide(x)));
  }
  const auto length = [&](const Point<T>& v, const Point<T>& w) {
    return std::hypot(wide(w.x) - wide(v.x), wide(w.y) - wide(v.y));
  };
  const double longest =
      std::max({length(t.a, t.b), length(t.b, t.c), length(t.c, t.a)});
  const double double_area =
      std::abs((wide(t.b.x) - wide(t.a.x)) * (wide(t.c.y) - wide(t.a.y)) -
               (wide(t.b.y) - wide(t.a.y)) * (wide(t.c.x) - wide(t.a.x)));
  return size * longest / double_area;
}

// The bound: with M the largest coordinate and h the smallest altitude, every
// method sums products of size M² with a few roundings each and divides by
// twice the area, at least h² (Gram: by its square): the error of a weight is
// k·u·(M/h)², with k about a dozen, doubled for good measure.
TEST_P(KernelWeightsTest, WeightsOfUniformPointsAreWithinTheBound) {
  const Kernel& kernel = *GetParam();
  WithFloatOf(kernel, [&]<class T>(T) {
    const auto& [scene, truth] =
        FindJudgedScene<T>("uniform:hit=50:bytes=2k:sets=fresh", kernel.loop);
    const Answers<T> answers = Ask(kernel, scene, truth);
    const double u = static_cast<double>(std::numeric_limits<T>::epsilon()) / 2;
    for (std::size_t c = 0; c < scene.calls.size(); c += 16) {
      for (std::size_t i = 0; i < scene.calls[c].n; i += 13) {
        const Triangle<T> t = scene.TriangleOf(scene.calls[c], i);
        const Point<T> p = scene.PointOf(scene.calls[c], i);
        const double ratio = SizeOverAltitude(t, p);
        const std::array<mpq_class, 3> exact = ExactWeights(t, p);
        for (std::size_t k = 0; k < 3; ++k) {
          const mpq_class computed(
              static_cast<double>(answers.weights[k][c][i]));
          ASSERT_LE(std::abs(mpq_class(computed - exact[k]).get_d()),
                    24 * u * ratio * ratio)
              << "weight " << k << " of " << p << " in " << t;
        }
      }
    }
  });
}

// Which weight is whose: each is 1 at its own vertex, 0 at the others.
TEST_P(KernelWeightsTest, WeightsBelongToTheVerticesInOrder) {
  WithFloatOf(*GetParam(), [&]<class T>(T) {
    const std::vector<Point<T>> vertices = {{1, 1}, {5, 2}, {2, 6}};
    const std::vector<Triangle<T>> both_windings = {
        {vertices[0], vertices[1], vertices[2]},
        {vertices[0], vertices[2], vertices[1]}};
    const AnswerTable<T> table = AskAll(*GetParam(), both_windings, vertices);
    for (std::size_t p = 0; p < 3; ++p) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t swapped = k == 0 ? 0 : 3 - k;
        EXPECT_NEAR(table.weights[k][table.At(0, p)], k == p ? 1 : 0, 1e-5);
        EXPECT_NEAR(table.weights[k][table.At(1, p)], swapped == p ? 1 : 0,
                    1e-5);
      }
    }
  });
}

// NaN in the weights tells a degenerate triangle from a point far outside.
TEST_P(KernelWeightsTest, DegenerateTriangleHasNanForWeights) {
  WithFloatOf(*GetParam(), [&]<class T>(T) {
    const std::vector<Triangle<T>> triangles = {{{1, 2}, {3, 4}, {5, 6}},
                                                {{1, 2}, {1, 2}, {5, 6}},
                                                {{7, 7}, {7, 7}, {7, 7}}};
    const AnswerTable<T> table =
        AskAll(*GetParam(), triangles, WholePoints<T>(2));
    for (const std::vector<T>& weights : table.weights) {
      for (const T weight : weights) EXPECT_TRUE(std::isnan(weight));
    }
  });
}

// So what the other tests show of answers holds here too.
TEST_P(KernelWeightsTest, WeightsDoNotChangeAnswers) {
  const Kernel& kernel = *GetParam();
  const std::vector<const Kernel*> plain = KernelsWhere([&](const Kernel& k) {
    return k.method.key == kernel.method.key && k.scalar == kernel.scalar &&
           k.isa == kernel.isa && k.loop == kernel.loop &&
           k.output == Output::kInside;
  });
  ASSERT_EQ(plain.size(), 1u);
  WithFloatOf(kernel, [&]<class T>(T) {
    for (const char* name : {"near_edge:ulps=0", "needle:aspect=10"}) {
      const auto& [scene, truth] = FindJudgedScene<T>(name, kernel.loop);
      EXPECT_EQ(Ask(kernel, scene, truth).bits,
                Ask(*plain[0], scene, truth).bits);
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Every, KernelWeightsTest,
                         testing::ValuesIn(KernelsWhere([](const Kernel& k) {
                           return k.output == Output::kWeights;
                         })),
                         KernelName());

}  // namespace
}  // namespace pitbench
