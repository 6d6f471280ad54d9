// The calls into other libraries: right where rounding cannot matter, and
// with the boundary rules that they declare.
#include "peers/peers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "harness/measure/accuracy.h"
#include "harness/measure/answers.h"
#include "harness/measure/measured_kernels.h"
#include "harness/scenes/generate.h"
#include "harness/truth/expected.h"

namespace pitbench {
namespace {

std::string NameOf(const testing::TestParamInfo<Kernel>& info) {
  const Kernel& kernel = info.param;
  return std::string(kernel.method.key) + "_" +
         std::string(Name(kernel.scalar)) + "_" +
         std::string(Name(kernel.loop));
}

class PeerTest : public testing::TestWithParam<Kernel> {};
INSTANTIATE_TEST_SUITE_P(Rows, PeerTest,
                         testing::ValuesIn(PeerKernels().begin(),
                                           PeerKernels().end()),
                         NameOf);

template <class T>
void ExpectTimed(const Kernel& kernel, const std::string& name) {
  const Scene<T> scene = MakeScene<T>(ParseScene(name), kernel.loop,
                                      {.groups = 16, .size = 67}, /*seed=*/1);
  const auto refusal = Refusal(kernel, scene, JudgeScene(scene));
  EXPECT_FALSE(refusal.has_value()) << *refusal;
}

TEST_P(PeerTest, is_right_on_the_scenes_on_which_it_is_timed) {
  const Kernel& kernel = GetParam();
  switch (kernel.scalar) {
    case Scalar::kF32:
      return ExpectTimed<float>(kernel, "uniform:hit=50:bytes=24k:sets=fixed");
    case Scalar::kF64:
      return ExpectTimed<double>(kernel, "uniform:hit=50:bytes=24k:sets=fixed");
    case Scalar::kI32:
      return ExpectTimed<std::int32_t>(kernel, "grid_80x50:sets=fixed");
    case Scalar::kI16:
    case Scalar::kU8:
      break;
  }
  FAIL() << "no scene is timed in " << Name(kernel.scalar);
}

// The answer of a kernel of one triangle about one point.
template <class T>
bool Says(const Kernel& kernel, const Triangle<T>& t, const Point<T>& p) {
  std::uint8_t bits = 0xFF;
  FunctionOf<T>(kernel)(
      {&t.a.x, &t.a.y, &t.b.x, &t.b.y, &t.c.x, &t.c.y, &p.x, &p.y, /*n=*/1},
      {.bits = &bits});
  EXPECT_LE(bits, 1) << "bits past the last answer are set";
  return bits == 1;
}

// Every triangle with an area and every point of a small grid: coordinates so
// small that no rounding is at work, a third of the answers on boundaries.
template <class T>
void ExpectDeclaredAnswers(const Kernel& kernel) {
  constexpr int kSide = 4;
  // It divides by twice the area, which is exact for powers of two.
  const bool divides = kernel.method.key == "eigen_inverse";
  const auto at = [](int k) {
    return Point<T>{static_cast<T>(k % kSide), static_cast<T>(k / kSide)};
  };
  for (int a = 0; a < kSide * kSide; ++a) {
    for (int b = 0; b < kSide * kSide; ++b) {
      for (int c = 0; c < kSide * kSide; ++c) {
        const Triangle<T> t{at(a), at(b), at(c)};
        const T area = std::abs((t.b.x - t.a.x) * (t.c.y - t.a.y) -
                                (t.b.y - t.a.y) * (t.c.x - t.a.x));
        if (area == 0) continue;
        if (divides && std::exp2(std::round(std::log2(area))) != area) continue;
        for (int p = 0; p < kSide * kSide; ++p) {
          ASSERT_EQ(Says(kernel, t, at(p)), Expected(kernel.method, t, at(p)))
              << a << " " << b << " " << c << " " << p;
        }
      }
    }
  }
}

TEST_P(PeerTest, keeps_its_boundary_rule_where_arithmetic_is_exact) {
  const Kernel& kernel = GetParam();
  if (kernel.loop == Loop::kGrid) {
    GTEST_SKIP() << "draws its outline: the declared width is checked above";
  }
  if (kernel.scalar == Scalar::kF32) {
    ExpectDeclaredAnswers<float>(kernel);
  } else {
    ExpectDeclaredAnswers<double>(kernel);
  }
}

template <class T>
void ExpectSurvivesNotFinite(const Kernel& kernel) {
  const T odd[] = {std::numeric_limits<T>::quiet_NaN(),
                   std::numeric_limits<T>::infinity(),
                   -std::numeric_limits<T>::infinity()};
  for (const T value : odd) {
    for (std::size_t k = 0; k < 8; ++k) {
      std::array<T, 8> x = {0, 0, 4, 0, 0, 4, 1, 1};
      x[k] = value;
      Says<T>(kernel, {{x[0], x[1]}, {x[2], x[3]}, {x[4], x[5]}}, {x[6], x[7]});
    }
  }
}

TEST_P(PeerTest, survives_what_it_may_be_asked) {
  const Kernel& kernel = GetParam();
  if (kernel.method.finite_only || kernel.loop == Loop::kGrid) return;
  if (kernel.scalar == Scalar::kF32) {
    ExpectSurvivesNotFinite<float>(kernel);
  } else {
    ExpectSurvivesNotFinite<double>(kernel);
  }
}

TEST(PeersTest, what_must_not_meet_nan_is_refused_before_it_does) {
  const Scene<double> scene =
      MakeScene<double>(ParseScene("special:kind=nan"), Loop::kPairs,
                        {.groups = 4, .size = 67}, /*seed=*/1);
  const SceneTruth truth = JudgeScene(scene);
  ASSERT_NE(truth.not_finite, 0u);
  std::size_t found = 0;
  for (const Kernel& kernel : PeerKernels()) {
    if (!kernel.method.finite_only || kernel.loop != Loop::kPairs) continue;
    if (kernel.scalar != Scalar::kF64) continue;
    ++found;
    EXPECT_EQ(Refusal(kernel, scene, truth),
              "must not be asked about NaN and infinity");
    EXPECT_TRUE(MeasureAccuracyOn(scene, {&kernel}).empty());
  }
  EXPECT_NE(found, 0u);
}

TEST(PeersTest, the_build_measures_them_behind_its_own_kernels) {
  const auto measured = MeasuredKernels();
  ASSERT_EQ(measured.size(), AllKernels().size() + PeerKernels().size());
  for (const Kernel& kernel : AllKernels()) {
    EXPECT_NE(kernel.isa, Isa::kLibrary) << kernel.method.key;
  }
  for (const Kernel& kernel : measured.last(PeerKernels().size())) {
    EXPECT_EQ(kernel.isa, Isa::kLibrary) << kernel.method.key;
  }
}

TEST(PeersTest, every_row_names_its_library) {
  for (const Kernel& kernel : PeerKernels()) {
    const auto of = std::count_if(
        PeerLibraries().begin(), PeerLibraries().end(),
        [&](const PeerLibrary& library) {
          return kernel.method.key.starts_with(std::string(library.name) + "_");
        });
    EXPECT_EQ(of, 1) << kernel.method.key;
  }
  for (const PeerLibrary& library : PeerLibraries()) {
    EXPECT_NE(library.version, "") << library.name;
    EXPECT_EQ(PeerVersions()[library.name], library.version);
  }
}

}  // namespace
}  // namespace pitbench
