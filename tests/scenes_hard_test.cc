// The hard families are what their names say.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "harness/measure/answers.h"
#include "harness/scenes/corpus.h"
#include "harness/scenes/step.h"
#include "harness/truth/orientation.h"
#include "tests/made_scene.h"

namespace pitbench {
namespace {

template <class T>
class ScenesHardTest : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(ScenesHardTest, Scalars);

template <class T>
std::array<T, 8> Coordinates(const Triangle<T>& t, const Point<T>& p) {
  return {t.a.x, t.a.y, t.b.x, t.b.y, t.c.x, t.c.y, p.x, p.y};
}

// How many representable numbers lie between x and y, which are within 2^17 of
// each other.
template <class T>
std::int64_t Apart(T x, T y) {
  std::int64_t low = -(1 << 17);
  std::int64_t high = 1 << 17;
  while (low < high) {
    const std::int64_t middle = (low + high) >> 1;
    (Step(x, middle) < y ? low : high) =
        Step(x, middle) < y ? middle + 1 : middle;
  }
  return std::abs(low);
}

TEST(StepTest, CountsNumbersOnBothSidesOfZero) {
  const float tiny = std::numeric_limits<float>::denorm_min();
  EXPECT_EQ(Step(0.0f, 1), tiny);
  EXPECT_EQ(Step(0.0f, -1), -tiny);
  EXPECT_EQ(Step(-0.0f, 1), tiny);
  EXPECT_EQ(Step(tiny, -2), -tiny);
  EXPECT_EQ(Step(1.0, 1), std::nextafter(1.0, 2.0));
  EXPECT_EQ(Step(-1.0, 3), -1 + 3 * 0x1p-53);
  EXPECT_EQ(Apart(-tiny, tiny), 2);
}

TYPED_TEST(ScenesHardTest, NearVertexPointsAreThatManyNumbersFromAVertex) {
  for (const std::int64_t ulps : {0, 1, 16, 65536}) {
    for (const Loop loop : kLoops) {
      ForEachAnswer(
          Make<TypeParam>("near_vertex:ulps=" + std::to_string(ulps), loop),
          [&](const auto& t, const auto& p) {
            std::int64_t nearest = std::numeric_limits<std::int64_t>::max();
            for (const auto& v : {t.a, t.b, t.c}) {
              // Anywhere near: else Apart would not know.
              if (std::abs(v.x - p.x) > 0.02 || std::abs(v.y - p.y) > 0.02) {
                continue;
              }
              nearest =
                  std::min(nearest, std::max(Apart(v.x, p.x), Apart(v.y, p.y)));
            }
            EXPECT_EQ(nearest, ulps) << Name(loop);
          });
    }
  }
}

TYPED_TEST(ScenesHardTest, ScaleFillsASquareOfThatSize) {
  using Limits = std::numeric_limits<TypeParam>;
  const int lowest = Limits::min_exponent - Limits::digits + 4;
  for (const int exponent :
       {lowest, Limits::min_exponent, 0, Limits::max_exponent - 1}) {
    const TypeParam side = std::ldexp(TypeParam{1}, exponent);
    for (const Loop loop : kLoops) {
      const auto scene =
          Make<TypeParam>("scale:exponent=" + std::to_string(exponent), loop);
      TypeParam largest = 0;
      ForEachAnswer(scene, [&](const auto& t, const auto& p) {
        for (const TypeParam x : Coordinates(t, p)) {
          EXPECT_GE(x, 0);
          EXPECT_LE(x, side);
          largest = std::max(largest, x);
        }
      });
      EXPECT_GT(largest, side / 2) << exponent;
      const SceneTruth truth = JudgeScene(scene);
      EXPECT_GT(truth.interior, kSize.groups * kSize.size / 20) << exponent;
      EXPECT_GT(truth.exterior, kSize.groups * kSize.size / 3) << exponent;
    }
  }
  EXPECT_THROW(Make<TypeParam>("scale:exponent=" + std::to_string(lowest - 1),
                               Loop::kPairs),
               SceneError);
}

TYPED_TEST(ScenesHardTest, ExponentsSpreadOverThatManyBinades) {
  for (const int binades : {0, 10, sizeof(TypeParam) == 4 ? 60 : 120}) {
    const std::string name =
        "exponent_spread:binades=" + std::to_string(binades);
    for (const Loop loop : kLoops) {
      const auto scene = Make<TypeParam>(name, loop);
      // Of what is drawn and not computed: of the triangles, or of the points.
      int lowest = 0;
      const bool one_point = loop == Loop::kOnePoint;
      for (const auto* array : {one_point ? &scene.px : &scene.ax,
                                one_point ? &scene.py : &scene.cy}) {
        for (const TypeParam x : *array) {
          EXPECT_LE(std::abs(x), 1);
          EXPECT_GE(std::ilogb(x), -binades - 1);
          lowest = std::min(lowest, std::ilogb(x));
        }
      }
      EXPECT_LE(lowest, -binades * 3 / 5) << Name(loop);
      // Rounding onto an edge leaves points on both sides.
      const SceneTruth truth = JudgeScene(scene);
      const std::size_t all = kSize.groups * kSize.size;
      EXPECT_GT(truth.interior + truth.boundary, all / 10) << Name(loop);
      EXPECT_GT(truth.exterior, all / 10) << Name(loop);
      EXPECT_LT(truth.degenerate, all / 10) << Name(loop);
    }
  }
}

// What share of a scene's points is on the boundary.
template <class T>
double BoundaryShare(const std::string& name, Loop loop) {
  const SceneTruth truth = JudgeScene(Make<T>(name, loop));
  return static_cast<double>(truth.boundary) /
         static_cast<double>(kSize.groups * kSize.size);
}

TYPED_TEST(ScenesHardTest, HalfOfThePointsAtDistance0AreOnTheEdgeExactly) {
  constexpr std::size_t kAll = kSize.groups * kSize.size;
  for (const Loop loop : kLoops) {
    const SceneTruth truth =
        JudgeScene(Make<TypeParam>("near_edge:ulps=0", loop));
    EXPECT_GT(truth.boundary, kAll / 4) << Name(loop);
    EXPECT_LT(truth.boundary, kAll * 3 / 4) << Name(loop);
    EXPECT_GT(truth.interior, kAll / 20) << Name(loop);
    EXPECT_GT(truth.exterior, kAll / 20) << Name(loop);
  }
}

TYPED_TEST(ScenesHardTest, NearEdgePointsAreOnBothSidesAsOften) {
  constexpr std::size_t kAll = kSize.groups * kSize.size;
  for (const Loop loop : kLoops) {
    const SceneTruth truth =
        JudgeScene(Make<TypeParam>("near_edge:ulps=16", loop));
    EXPECT_GT(truth.interior, kAll * 2 / 5) << Name(loop);
    EXPECT_GT(truth.exterior, kAll * 2 / 5) << Name(loop);
  }
}

TYPED_TEST(ScenesHardTest, OnEdgeHasThatShareOfPointsOnAnEdge) {
  for (const Loop loop : kLoops) {
    EXPECT_LT(BoundaryShare<TypeParam>("on_edge:percent=0", loop), 0.02);
    EXPECT_NEAR(BoundaryShare<TypeParam>("on_edge:percent=50", loop), 0.5,
                0.07);
    EXPECT_EQ(BoundaryShare<TypeParam>("on_edge:percent=100", loop), 1);
  }
}

TYPED_TEST(ScenesHardTest, OnBoundaryEveryPointIs) {
  using Limits = std::numeric_limits<TypeParam>;
  constexpr int kMost = sizeof(TypeParam) == 4 ? 240 : 2000;
  for (const std::string at : {"edge", "vertex"}) {
    for (const int binades : {0, 10, kMost}) {
      const std::string name =
          "on_boundary:at=" + at + ":binades=" + std::to_string(binades);
      for (const Loop loop : kLoops) {
        EXPECT_EQ(BoundaryShare<TypeParam>(name, loop), 1) << name;
        int lowest = 0;
        int highest = 0;
        std::size_t at_vertex = 0;
        const auto scene = Make<TypeParam>(name, loop);
        ForEachAnswer(scene, [&](const auto& t, const auto& p) {
          for (const TypeParam x : Coordinates(t, p)) {
            ASSERT_GE(std::abs(x), Limits::min());
            lowest = std::min(lowest, std::ilogb(x));
            highest = std::max(highest, std::ilogb(x));
          }
          for (const auto& v : {t.a, t.b, t.c}) {
            at_vertex += v.x == p.x && v.y == p.y ? 1u : 0u;
          }
        });
        EXPECT_GE(highest - lowest, binades * 9 / 10) << name;
        EXPECT_LE(highest - lowest, binades + 4) << name;
        EXPECT_EQ(at_vertex, at == "vertex" ? kSize.groups * kSize.size : 0u)
            << name;
      }
    }
  }
}

TYPED_TEST(ScenesHardTest, CancellationIsOnBothSidesOfALongEdge) {
  for (const int binades : {0, 20, 29, 60}) {
    const std::string name = "cancellation:binades=" + std::to_string(binades);
    for (const Loop loop : kLoops) {
      const SceneTruth truth = JudgeScene(Make<TypeParam>(name, loop));
      const double all = kSize.groups * kSize.size;
      EXPECT_NEAR(static_cast<double>(truth.boundary), 0.2 * all, 0.06 * all)
          << name;
      EXPECT_EQ(truth.degenerate, 0u);
      if (binades == 0) continue;  // beside a vertex
      EXPECT_NEAR(static_cast<double>(truth.interior), 0.4 * all, 0.1 * all)
          << name;
      EXPECT_NEAR(static_cast<double>(truth.exterior), 0.4 * all, 0.1 * all)
          << name;
    }
  }
}

// Twice the area of a triangle of whole numbers, over the greatest common
// divisor of an edge's components, is the distance to that edge in steps.
TYPED_TEST(ScenesHardTest, WholeNumbersAreOnAnEdgeOrOneStepBesideIt) {
  constexpr int kDigits = std::numeric_limits<TypeParam>::digits;
  for (const int bits : {3, kDigits / 2, kDigits}) {
    const std::string name = "whole_numbers:bits=" + std::to_string(bits);
    for (const Loop loop : kLoops) {
      TypeParam largest = 0;
      std::array<std::size_t, 2> at_steps{};  // 0, 1
      ForEachAnswer(Make<TypeParam>(name, loop), [&](const auto& t,
                                                     const auto& p) {
        for (const TypeParam x : Coordinates(t, p)) {
          ASSERT_EQ(std::trunc(x), x);
          largest = std::max(largest, std::abs(x));
        }
        const std::array vertices = {t.a, t.b, t.c};
        mpz_class fewest = -1;
        for (std::size_t k = 0; k < vertices.size(); ++k) {
          const auto& v = vertices[k];
          const auto& w = vertices[(k + 1) % 3];
          const mpz_class ex = mpz_class(w.x) - mpz_class(v.x);
          const mpz_class ey = mpz_class(w.y) - mpz_class(v.y);
          const mpz_class double_area = ex * (mpz_class(p.y) - mpz_class(v.y)) -
                                        ey * (mpz_class(p.x) - mpz_class(v.x));
          const mpz_class steps = abs(double_area) / gcd(ex, ey);
          if (fewest < 0 || steps < fewest) fewest = steps;
        }
        ASSERT_LE(fewest, 1);
        ++at_steps[fewest.get_ui()];
      });
      EXPECT_LE(largest, std::ldexp(TypeParam{1}, bits));
      EXPECT_GT(largest, std::ldexp(TypeParam{1}, bits - 1));
      EXPECT_GT(at_steps[0], 0u) << name;
      EXPECT_GT(at_steps[1], at_steps[0]) << name;
    }
  }
}

TYPED_TEST(ScenesHardTest, DegenerateTrianglesHaveNoAreaAtAll) {
  for (const std::string kind : {"collinear", "doubled", "single"}) {
    for (const Loop loop : kLoops) {
      std::size_t on_line = 0;
      std::size_t rounded = 0;
      std::size_t all = 0;
      ForEachAnswer(
          Make<TypeParam>("degenerate:kind=" + kind, loop),
          [&](const auto& t, const auto& p) {
            EXPECT_EQ(OrientationExactly(t.a, t.b, t.c), 0);
            const std::set<std::pair<TypeParam, TypeParam>> different = {
                {t.a.x, t.a.y}, {t.b.x, t.b.y}, {t.c.x, t.c.y}};
            EXPECT_EQ(different.size(), kind == "collinear" ? 3u
                                        : kind == "doubled" ? 2u
                                                            : 1u);
            ++all;
            const double x = double{t.b.x} - double{t.a.x};
            const mpq_class exact = mpq_class(t.b.x) - mpq_class(t.a.x);
            rounded += exact != mpq_class(static_cast<TypeParam>(x)) ? 1u : 0u;
            if (kind == "single") {
              on_line += p.x == t.a.x && p.y == t.a.y ? 1u : 0u;
            } else {
              on_line +=
                  Orientation(t.a, t.b, p) == 0 && Orientation(t.b, t.c, p) == 0
                      ? 1u
                      : 0u;
            }
          });
      EXPECT_GT(on_line, all * 25 / 100) << kind << " " << Name(loop);
      EXPECT_LT(on_line, all * 75 / 100) << kind << " " << Name(loop);
      // Differences are exact but for half of the collinear ones.
      if (kind == "collinear") {
        EXPECT_GT(rounded, all / 20) << Name(loop);
      } else {
        EXPECT_EQ(rounded, 0u) << Name(loop);
      }
    }
  }
}

// How many coordinates of the scene's arrays hold.
template <class T, class Holds>
std::size_t CountCoordinates(const Scene<T>& scene, const Holds& holds) {
  std::size_t count = 0;
  for (const auto* array : {&scene.ax, &scene.ay, &scene.bx, &scene.by,
                            &scene.cx, &scene.cy, &scene.px, &scene.py}) {
    count += static_cast<std::size_t>(std::ranges::count_if(*array, holds));
  }
  return count;
}

TYPED_TEST(ScenesHardTest, SpecialValuesAreInTrianglesAndPoints) {
  using T = TypeParam;
  using Limits = std::numeric_limits<T>;
  struct Kind {
    std::string name;
    bool (*has)(T);
    bool finite;
  };
  const Kind kinds[] = {
      {"nan", [](T x) { return std::isnan(x); }, false},
      {"infinite", [](T x) { return std::isinf(x); }, false},
      {"minus_zero", [](T x) { return x == 0 && std::signbit(x); }, true},
      {"subnormal", [](T x) { return x != 0 && std::abs(x) < Limits::min(); },
       true},
      {"largest", [](T x) { return std::abs(x) == Limits::max(); }, true}};
  for (const Kind& kind : kinds) {
    for (const Loop loop : kLoops) {
      const auto scene = Make<T>("special:kind=" + kind.name, loop);
      std::size_t in_triangles = 0;
      std::size_t in_points = 0;
      std::size_t all = 0;
      ForEachAnswer(scene, [&](const auto& t, const auto& p) {
        const auto at = Coordinates(t, p);
        ++all;
        in_triangles += std::any_of(at.begin(), at.begin() + 6, kind.has);
        in_points += std::any_of(at.begin() + 6, at.end(), kind.has);
        EXPECT_TRUE(IsFinite(t, p) || !kind.finite) << kind.name;
      });
      EXPECT_GT(in_triangles, 0u) << kind.name << " " << Name(loop);
      EXPECT_GT(in_points, 0u) << kind.name << " " << Name(loop);
      EXPECT_LT(CountCoordinates(scene, kind.has),
                2 * scene.px.size() + 6 * scene.ax.size())
          << kind.name << ": nothing to compare it with";
      // Something is to be found in all of them.
      const SceneTruth truth = JudgeScene(scene);
      EXPECT_GT(truth.interior, all / 50) << kind.name << " " << Name(loop);
      EXPECT_GT(truth.exterior, all / 5) << kind.name << " " << Name(loop);
      EXPECT_EQ(truth.degenerate, 0u) << kind.name << " " << Name(loop);
    }
  }
}

TYPED_TEST(ScenesHardTest, InfinityAndZeroHaveBothSigns) {
  const auto infinite = Make<TypeParam>("special:kind=infinite", Loop::kPairs);
  const auto zeros = Make<TypeParam>("special:kind=minus_zero", Loop::kPairs);
  for (const bool negative : {false, true}) {
    const auto sign = [&](TypeParam x) { return std::signbit(x) == negative; };
    EXPECT_GT(
        CountCoordinates(infinite,
                         [&](TypeParam x) { return std::isinf(x) && sign(x); }),
        0u);
    EXPECT_GT(
        CountCoordinates(zeros, [&](TypeParam x) { return x == 0 && sign(x); }),
        0u);
  }
}

TYPED_TEST(ScenesHardTest, CorpusHoldsTheCasesOfItsScalarWithTheirTruth) {
  for (const Loop loop : kLoops) {
    const auto scene = Make<TypeParam>("corpus", loop);
    std::vector<std::string> positions;
    ForEachAnswer(scene, [&](const auto& t, const auto& p) {
      positions.emplace_back(Name(Classify(t, p)));
    });
    std::vector<std::string> expected;
    for (const CorpusCase& one : RealWorldCorpus()) {
      if (one.scalar == Name(ScalarOf<TypeParam>())) {
        expected.push_back(one.truth);
      }
    }
    EXPECT_GT(expected.size(), 5u);
    EXPECT_EQ(positions, expected) << Name(loop);
  }
}

}  // namespace
}  // namespace pitbench
