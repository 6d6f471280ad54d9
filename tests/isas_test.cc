// Which ISAs run here. The other tests ask every kernel that runs here, so one
// that is wrongly left out would not be tested at all.
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <set>
#include <string>

#include "kernels/kernels.h"

#if defined(__aarch64__)
#include <sys/prctl.h>
#endif

namespace pitbench {
namespace {

std::string IsasThatRunHere() {
  std::string isas;
  for (int k = 0; k <= static_cast<int>(Isa::kSve2); ++k) {
    const auto isa = static_cast<Isa>(k);
    if (!RunsHere(isa)) continue;
    if (!isas.empty()) isas += " ";
    isas += Name(isa);
  }
  return isas;
}

TEST(IsasTest, EveryIsaThatRunsHereHasKernelsOfEveryScalarAndLoop) {
  for (int k = 0; k <= static_cast<int>(Isa::kSve2); ++k) {
    const auto isa = static_cast<Isa>(k);
    if (!RunsHere(isa)) continue;
    std::set<std::pair<Scalar, Loop>> seen;
    for (const Kernel& kernel : AllKernels()) {
      if (kernel.isa == isa) seen.insert({kernel.scalar, kernel.loop});
    }
    const bool autovec = Name(isa).starts_with("autovec");
    EXPECT_EQ(seen.size(), autovec ? 10u : 12u) << Name(isa);
  }
}

TEST(IsasTest, EveryKernelHasTheOneFunctionOfItsScalar) {
  for (const Kernel& kernel : AllKernels()) {
    EXPECT_EQ(kernel.f32 != nullptr, kernel.scalar == Scalar::kF32);
    EXPECT_EQ(kernel.f64 != nullptr, kernel.scalar == Scalar::kF64);
    EXPECT_EQ(kernel.i32 != nullptr, kernel.scalar == Scalar::kI32);
    EXPECT_EQ(kernel.i16 != nullptr, kernel.scalar == Scalar::kI16);
    EXPECT_EQ(kernel.u8 != nullptr, kernel.scalar == Scalar::kU8);
  }
}

// So the last kernel of a method that runs here is the widest.
TEST(IsasTest, KernelsOfAMethodAreOrderedByIsa) {
  std::map<std::string_view, Isa> last;
  for (const Kernel& kernel : AllKernels()) {
    const auto [found, first] = last.try_emplace(kernel.method.key, kernel.isa);
    EXPECT_LE(found->second, kernel.isa) << kernel.method.key;
    found->second = kernel.isa;
  }
}

#if defined(__x86_64__) && !defined(PITBENCH_FEWER_KERNELS)
TEST(IsasTest, WhoeverHasAWiderIsaHasTheNarrowerOnes) {
  EXPECT_TRUE(RunsHere(Isa::kScalar));
  EXPECT_TRUE(!RunsHere(Isa::kAvx512) || RunsHere(Isa::kAvx2));
  EXPECT_TRUE(!RunsHere(Isa::kAvx2) || RunsHere(Isa::kSse4));
  EXPECT_TRUE(!RunsHere(Isa::kSse4) || RunsHere(Isa::kSsse3));
  EXPECT_TRUE(!RunsHere(Isa::kAutovecV4) || RunsHere(Isa::kAutovecV3));
  EXPECT_TRUE(!RunsHere(Isa::kAutovecV3) || RunsHere(Isa::kAutovecV2));
  EXPECT_FALSE(RunsHere(Isa::kNeon));
}
#endif

// Set where the CPU is emulated, and so known: names parted by blanks, and the
// bytes of an SVE vector (0 without SVE).
TEST(IsasTest, AnEmulatedCpuRunsWhatItHas) {
  const char* expected = std::getenv("PITBENCH_EXPECTED_ISAS");
  if (expected == nullptr) GTEST_SKIP() << "not emulated";
  EXPECT_EQ(IsasThatRunHere(), expected);
#if defined(__aarch64__)
  constexpr int kLengthMask = 0xffff;  // PR_SVE_VL_LEN_MASK
  const int sve = prctl(PR_SVE_GET_VL);
  EXPECT_EQ(std::to_string(sve < 0 ? 0 : sve & kLengthMask),
            std::getenv("PITBENCH_EXPECTED_SVE_BYTES"));
#endif
}

}  // namespace
}  // namespace pitbench
