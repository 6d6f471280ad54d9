// The copies of kernels in other places are there, and are the same kernels.
#include "kernels/placements.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <string>

#include "harness/measure/answers.h"
#include "harness/scenes/generate.h"
#include "kernels/kernels.h"

namespace pitbench {
namespace {

std::size_t PastALine(const Kernel& kernel) {
  return reinterpret_cast<std::uintptr_t>(kernel.f32) % kAlignment;
}

const Kernel* Aligned(const Kernel& copy) {
  for (const Kernel& kernel : AllKernels()) {
    if (kernel.method.key == copy.method.key && kernel.isa == copy.isa &&
        kernel.loop == copy.loop && kernel.scalar == copy.scalar &&
        kernel.output == copy.output) {
      return &kernel;
    }
  }
  return nullptr;
}

TEST(PlacementsTest, EachKernelLiesInFourPlacesAndOnALine) {
  std::set<std::string> kernels;
  for (const Placement& placement : Placements()) {
    const std::string name = std::string(placement.kernel.method.key) + " " +
                             std::string(Name(placement.kernel.isa));
    kernels.insert(name);
    EXPECT_EQ(PastALine(placement.kernel), placement.shift) << name;
    const Kernel* aligned = Aligned(placement.kernel);
    ASSERT_NE(aligned, nullptr) << name;
    EXPECT_EQ(PastALine(*aligned), 0u) << name;
  }
  EXPECT_EQ(Placements().size(), 4 * kernels.size());
#if defined(__x86_64__)
  EXPECT_TRUE(kernels.contains("edge_function_fma avx512"));
  EXPECT_TRUE(kernels.contains("cross_product avx2"));
#else
  EXPECT_TRUE(kernels.contains("edge_function_fma neon"));
#endif
}

TEST(PlacementsTest, ACopyAnswersAsTheKernelDoes) {
  const Scene<float> scene = MakeScene<float>(
      ParseScene("near_edge:ulps=1"), Loop::kOneTriangle, {}, kDefaultSeed);
  for (const Placement& placement : Placements()) {
    const Kernel& copy = placement.kernel;
    if (!RunsHere(copy.isa)) continue;
    EXPECT_EQ(pitbench::Run(copy, scene).bits,
              pitbench::Run(*Aligned(copy), scene).bits)
        << copy.method.key << ' ' << Name(copy.isa);
  }
}

}  // namespace
}  // namespace pitbench
