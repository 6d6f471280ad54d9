// One method gives the same answers, to the last bit of its weights, whatever
// it was compiled for and however the points lie in memory: the arithmetic is
// IEEE's, lane by lane, and nothing is contracted unless the method says so. On
// hard scenes, where one rounding more or less shows.
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "harness/measure/answers.h"
#include "kernels/kernels.h"
#include "tests/judged_scene.h"
#include "tests/kernel_answers.h"

namespace pitbench {
namespace {

// The kernels of one method, scalar and loop, ISA by ISA; one_triangle_aos with
// one_triangle.
std::vector<std::vector<const Kernel*>> Groups() {
  std::map<std::tuple<std::string_view, Scalar, Loop, Output>,
           std::vector<const Kernel*>>
      groups;
  for (const Kernel* kernel : FloatKernels()) {
    groups[{kernel->method.key, kernel->scalar, LoopOfScenes(kernel->loop),
            kernel->output}]
        .push_back(kernel);
  }
  std::vector<std::vector<const Kernel*>> found;
  for (const auto& [key, kernels] : groups) found.push_back(kernels);
  return found;
}

class IsaAgreementTest
    : public testing::TestWithParam<std::vector<const Kernel*>> {};

template <class T>
bool SameWeights(const Array<T>& x, const Array<T>& y) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i] != y[i] && (x[i] == x[i] || y[i] == y[i])) return false;
  }
  return x.size() == y.size();
}

TEST_P(IsaAgreementTest, EveryIsaAndLayoutGivesTheSameBitsOnHardScenes) {
  const std::vector<const Kernel*>& kernels = GetParam();
  WithFloatOf(*kernels[0], [&]<class T>(T) {
    const bool wide = sizeof(T) == 8;
    for (const char* name : {"near_edge:ulps=0", "near_edge:ulps=1",
                             wide ? "needle:aspect=24" : "needle:aspect=10",
                             wide ? "offset:ratio=40" : "offset:ratio=12"}) {
      const auto& [scene, truth] = FindJudgedScene<T>(name, kernels[0]->loop);
      const Answers<T> first = Ask(*kernels[0], scene, truth);
      for (std::size_t k = 1; k < kernels.size(); ++k) {
        const Answers<T> other = Ask(*kernels[k], scene, truth);
        const std::string pair = name + std::string(": ") +
                                 NameOf(*kernels[0]) + " and " +
                                 NameOf(*kernels[k]);
        EXPECT_TRUE(other.bits == first.bits) << pair;
        for (std::size_t w = 0; w < 3; ++w) {
          ASSERT_EQ(other.weights[w].size(), first.weights[w].size());
          for (std::size_t c = 0; c < first.weights[w].size(); ++c) {
            EXPECT_TRUE(SameWeights(other.weights[w][c], first.weights[w][c]))
                << pair << ", weight " << w << " of call " << c;
          }
        }
      }
    }
  });
}

// Else the test above shows nothing: these scenes are not easy. (For most
// methods: some are exact on them.)
TEST(IsaAgreementScenesTest, HardScenesAreHard) {
  std::size_t kernels = 0;
  std::size_t challenged = 0;
  for (const Kernel* kernel : FloatInsideKernels()) {
    if (kernel->isa != Isa::kScalar || kernel->scalar != Scalar::kF32) continue;
    const auto& [scene, truth] =
        FindJudgedScene<float>("near_edge:ulps=0", kernel->loop);
    ++kernels;
    if (Ask(*kernel, scene, truth).wrong.size() > 10) ++challenged;
  }
  EXPECT_GT(3 * challenged, 2 * kernels);
}

std::string GroupName(
    const testing::TestParamInfo<std::vector<const Kernel*>>& group) {
  const Kernel& kernel = *group.param[0];
  return std::string(kernel.method.key)
      .append("_")
      .append(Name(kernel.scalar))
      .append("_")
      .append(Name(kernel.loop, kernel.output));
}

INSTANTIATE_TEST_SUITE_P(Every, IsaAgreementTest, testing::ValuesIn(Groups()),
                         GroupName);

}  // namespace
}  // namespace pitbench
