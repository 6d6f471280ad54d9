// A verification of ray kernels counts what is wrong, and nothing else.
#include "harness/measure/rays/ray_verify.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "harness/scenes/generate.h"
#include "harness/scenes/spec.h"
#include "tests/rays/ray_kernel_answers.h"

namespace pitbench {
namespace {

constexpr std::size_t kRays = PITBENCH_SLOW ? 2000 : 40000;

std::vector<const RayKernel*> OfMethod(std::string_view method, Scalar scalar) {
  return RayKernelsWhere([&](const RayKernel& k) {
    return k.method.key == method && k.scalar == scalar;
  });
}

template <class T>
void ExpectAllRight(std::string_view method) {
  const Verification v =
      VerifyRays<T>(OfMethod(method, ScalarOf<T>()), kRays, 7);
  EXPECT_GE(v.points, kRays);
  EXPECT_GT(v.boundary, 100u);
  EXPECT_GT(v.answers, v.points);
  EXPECT_EQ(v.wrong, 0u) << v.first_wrong;
}

TEST(RayVerifyTest, TheExactKernelsAreRightAboutHardRays) {
  ExpectAllRight<float>("exact");
  ExpectAllRight<double>("exact");
  ExpectAllRight<float>("exact_perturbed");
  ExpectAllRight<double>("exact_perturbed");
}

TEST(RayVerifyTest, AMethodThatRoundsIsWrongAndTheFirstIsDescribed) {
  const Verification v =
      VerifyRays<float>(OfMethod("plane_gram", Scalar::kF32), kRays, 7);
  EXPECT_GT(v.wrong, 100u);
  EXPECT_NE(v.first_wrong.find("plane_gram on "), std::string::npos);
  EXPECT_NE(v.first_wrong.find(" a ray from ("), std::string::npos);
}

void Nothing(const RayBatch<float>& batch, const RayResult<float>& result) {
  if (result.nearest != nullptr) *result.nearest = kNoTriangle;
  if (result.bits != nullptr) {
    std::fill_n(result.bits, BitBytes(batch.n), std::uint8_t{0});
  }
}

// A kernel that never hits is wrong about every hit, and, being closed, about
// every ray through an edge; one that need not be closed only about hits.
TEST(RayVerifyTest, AClosedKernelHasToHitWhatIsOnABoundary) {
  for (const RayKernel* kernel : OfMethod("exact", Scalar::kF32)) {
    if (kernel->output == RayOutput::kTuv) continue;
    RayKernel never = *kernel;
    never.f32 = Nothing;
    const Verification closed = VerifyRays<float>({&never}, kRays, 7);
    never.method.boundary = Boundary::kPerturbed;
    const Verification perturbed = VerifyRays<float>({&never}, kRays, 7);
    EXPECT_GT(perturbed.wrong, 0u);
    EXPECT_GT(closed.wrong, perturbed.wrong);
    if (kernel->output == RayOutput::kHits) {
      EXPECT_EQ(closed.wrong, perturbed.wrong + closed.boundary);
    }
  }
}

TEST(RayVerifyTest, EveryHardSceneCanBeMade) {
  for (const std::string& name : HardRayScenes()) {
    const auto scene = MakeRayScene<double>(
        ParseScene(name), RayLoop::kRayPairs, {.groups = 2, .size = 8}, 1);
    EXPECT_GT(scene.calls.size(), 0u) << name;
  }
}

}  // namespace
}  // namespace pitbench
