// A kernel's answers are counted right, and one that is broken is refused
// before it could be timed.
#include "harness/measure/answers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "harness/scenes/generate.h"
#include "kernels/kernels.h"
#include "tests/kernel_answers.h"
#include "tests/spoiled_kernel.h"

namespace pitbench {
namespace {

constexpr auto kUntouched = [](const Batch<float>&, const Result<float>&) {};

// Spoils the answers of triangle (0, 0) (4, 0) (0, 4) only.
template <HandMadePoint kPoint, bool kInside>
constexpr auto kSays =
    [](const Batch<float>& batch, const Result<float>& result) {
      if (*batch.bx == 4) Set(result.bits, kPoint, kInside);
    };

TEST(JudgeSceneTest, HandMadeSceneIsJudgedRight) {
  const SceneTruth truth = JudgeScene(HandMadeScene());
  EXPECT_EQ(truth.interior, 3u);
  EXPECT_EQ(truth.exterior, 4u + 1u);  // NaN in the degenerate one as well
  EXPECT_EQ(truth.boundary, 2u);
  EXPECT_EQ(truth.degenerate, 8u);
  EXPECT_EQ(truth.not_finite, 2u);
  ASSERT_EQ(truth.calls.size(), 2u);
  EXPECT_EQ(truth.calls[0].inside,
            (Bits{1u << kInNearA | 1u << kInNearB | 1u << kInNearC, 0}));
  EXPECT_EQ(truth.calls[0].boundary, (Bits{1u << kOnBc | 1u << kOnA, 0}));
  EXPECT_EQ(truth.calls[0].not_finite, (Bits{1u << kNotANumber, 0}));
  EXPECT_EQ(truth.calls[0].strict,
            (Bits{1u << kInNearA | 1u << kInNearB | 1u << kInNearC |
                      1u << kOutBehindBc | 1u << kOutLeft,
                  1u << (kOutFar - 8)}));
  EXPECT_EQ(truth.calls[1].inside, (Bits{0, 0}));
  EXPECT_EQ(truth.calls[1].strict, (Bits{0, 0}));
}

TEST(AskTest, RightKernelIsRight) {
  const Scene<float> scene = HandMadeScene();
  const auto answers = Ask(SpoiledKernel<Output::kInside, kUntouched>(), scene,
                           JudgeScene(scene));
  EXPECT_TRUE(answers.wrong.empty());
  EXPECT_EQ(answers.boundary_accepted, 2u);
  EXPECT_EQ(answers.stray_bits, 0u);
}

TEST(AskTest, EachKindOfMistakeIsCountedAsWhatItIs) {
  constexpr auto kMistakes = [](const Batch<float>& batch,
                                const Result<float>& result) {
    if (*batch.bx == 4) {
      Set(result.bits, kInNearB, false);
      Set(result.bits, kOutFar, true);
      Set(result.bits, kOnA, false);
      Set(result.bits, 9, true);
      Set(result.bits, 15, true);
    } else {
      Set(result.bits, kInNearA, true);
    }
  };
  const Scene<float> scene = HandMadeScene();
  const auto answers = Ask(SpoiledKernel<Output::kInside, kMistakes>(), scene,
                           JudgeScene(scene));
  ASSERT_EQ(answers.wrong.size(), 3u);
  EXPECT_EQ(answers.wrong[0].call, 0u);
  EXPECT_EQ(answers.wrong[0].answer, kInNearB);
  EXPECT_FALSE(answers.wrong[0].said_inside);
  EXPECT_EQ(answers.wrong[1].call, 0u);
  EXPECT_EQ(answers.wrong[1].answer, kOutFar);
  EXPECT_TRUE(answers.wrong[1].said_inside);
  EXPECT_EQ(answers.wrong[2].call, 1u);
  EXPECT_EQ(answers.wrong[2].answer, kInNearA);
  EXPECT_TRUE(answers.wrong[2].said_inside);
  EXPECT_EQ(answers.boundary_accepted, 1u);
  EXPECT_EQ(answers.stray_bits, 2u);
}

template <Output kOutput, auto kSpoil>
std::string RefusalOf() {
  const Scene<float> scene = HandMadeScene();
  return Refusal(SpoiledKernel<kOutput, kSpoil>(), scene, JudgeScene(scene))
      .value_or("not refused");
}

TEST(RefusalTest, RightKernelsAreTimed) {
  EXPECT_EQ((RefusalOf<Output::kInside, kUntouched>()), "not refused");
  EXPECT_EQ((RefusalOf<Output::kWeights, kUntouched>()), "not refused");
}

TEST(RefusalTest, WrongAnswerIsShown) {
  EXPECT_EQ((RefusalOf<Output::kInside, kSays<kInNearA, false>>()),
            "says outside of (0x1p+0, 0x1p+0) in (0x0p+0, 0x0p+0) "
            "(0x1p+2, 0x0p+0) (0x0p+0, 0x1p+2), which is inside, and rounding "
            "cannot be why");
  EXPECT_NE((RefusalOf<Output::kInside, kSays<kOutLeft, true>>())
                .find("says inside of (-0x1p+0, 0x1p+0)"),
            std::string::npos);
}

TEST(RefusalTest, AcceptingNanIsNoRounding) {
  EXPECT_NE((RefusalOf<Output::kInside, kSays<kNotANumber, true>>())
                .find("says inside of (nan, 0x1p+0)"),
            std::string::npos);
}

TEST(RefusalTest, BoundaryMayFallEitherWay) {
  EXPECT_EQ((RefusalOf<Output::kInside, kSays<kOnBc, false>>()), "not refused");
  EXPECT_EQ((RefusalOf<Output::kInside, kSays<kOnA, false>>()), "not refused");
}

TEST(RefusalTest, BitPastTheLastAnswerIsRefused) {
  constexpr auto kStray = [](const Batch<float>& batch,
                             const Result<float>& result) {
    Set(result.bits, batch.n, true);
  };
  EXPECT_EQ((RefusalOf<Output::kInside, kStray>()),
            "sets bits past the last answer");
}

TEST(RefusalTest, WrongWeightIsRefused) {
  constexpr auto kSwapped = [](const Batch<float>&,
                               const Result<float>& result) {
    std::swap(result.w[1][kInNearB], result.w[2][kInNearB]);
  };
  EXPECT_NE(
      (RefusalOf<Output::kWeights, kSwapped>()).find("weight 1 of answer"),
      std::string::npos);
  constexpr auto kNan = [](const Batch<float>&, const Result<float>& result) {
    result.w[0][kInNearB] = std::numeric_limits<float>::quiet_NaN();
  };
  EXPECT_NE((RefusalOf<Output::kWeights, kNan>()).find("weight 0 of answer"),
            std::string::npos);
}

// A method that declares that it accepts a third may lose the rest, but must
// not accept what is outside.
TEST(RefusalTest, DeclaredThirdIsTimed) {
  const Scene<float> scene = HandMadeScene();
  const SceneTruth truth = JudgeScene(scene);
  const Kernel& third =
      OneTriangleKernel("cross_solve_published", Output::kInside);
  EXPECT_EQ(Ask(third, scene, truth).wrong.size(), 2u);
  EXPECT_EQ(Refusal(third, scene, truth), std::nullopt);

  Kernel undeclared = third;
  undeclared.method.accepts = Accepts::kTriangle;
  EXPECT_NE(Refusal(undeclared, scene, truth), std::nullopt);
  Kernel too_much = SpoiledKernel<Output::kInside, kSays<kOutFar, true>>();
  too_much.method.accepts = Accepts::kThirdNearVertexA;
  EXPECT_NE(Refusal(too_much, scene, truth), std::nullopt);
}

// The point is outside by 1/64 of a triangle of size 2^-8: in f32 the cross
// product is above -1e-6.
TEST(RefusalTest, DeclaredToleranceIsTimed) {
  Scene<float> scene{.name = "", .loop = Loop::kOneTriangle};
  scene.Add(Triangle<float>{{0, 0}, {0x1p-8f, 0}, {0, 0x1p-8f}});
  scene.Add(Point<float>{0x1p-9f, -0x1p-14f});
  scene.calls.push_back({0, 0, 1});
  const SceneTruth truth = JudgeScene(scene);
  const Kernel& epsilon = OneTriangleKernel("epsilon", Output::kInside);
  EXPECT_EQ(Ask(epsilon, scene, truth).wrong.size(), 1u);
  EXPECT_EQ(Refusal(epsilon, scene, truth), std::nullopt);
  Kernel undeclared = epsilon;
  undeclared.method.tolerance = 0;
  EXPECT_NE(Refusal(undeclared, scene, truth), std::nullopt);
  Kernel too_little = epsilon;
  too_little.method.tolerance = 1e-8;
  EXPECT_NE(Refusal(too_little, scene, truth), std::nullopt);
}

// What is timed by default is not refused, for any kernel that runs here.
TEST(RefusalTest, NoKernelIsRefusedOnItsUniformScene) {
  for (const Loop loop : {Loop::kOneTriangle, Loop::kOnePoint, Loop::kPairs}) {
    const auto expect_none = [loop]<class T>(T) {
      const Scene<T> scene =
          MakeScene<T>(ParseScene("uniform:hit=50:bytes=2k:sets=fresh"), loop,
                       {}, kDefaultSeed);
      const SceneTruth truth = JudgeScene(scene);
      for (const Kernel* kernel : FloatKernels()) {
        if (kernel->loop != loop || kernel->scalar != ScalarOf<T>()) continue;
        EXPECT_EQ(Refusal(*kernel, scene, truth), std::nullopt)
            << NameOf(*kernel);
      }
    };
    expect_none(float{});
    expect_none(double{});
  }
}

}  // namespace
}  // namespace pitbench
