// A kernel that is broken has no time, whatever its loop: it is asked for its
// answers, and then never called again.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "harness/measure/speed.h"
#include "harness/scenes/generate.h"
#include "kernels/kernels.h"

namespace pitbench {
namespace {

template <class T>
const Kernel& ScalarEdgeFunction(Loop loop) {
  for (const Kernel& kernel : AllKernels()) {
    if (kernel.method.key == "edge_function" && kernel.isa == Isa::kScalar &&
        kernel.loop == loop && kernel.scalar == ScalarOf<T>() &&
        kernel.output == Output::kInside) {
      return kernel;
    }
  }
  throw std::logic_error("no such kernel");
}

// The kernel of a loop with its calls counted and, if kBroken, the answers of
// its first byte turned round.
template <class T, Loop kLoop, bool kBroken>
struct Watched {
  static inline std::size_t calls = 0;

  static void Answer(const Batch<T>& batch, const Result<T>& result) {
    static const KernelFunction<T> right =
        FunctionOf<T>(ScalarEdgeFunction<T>(kLoop));
    ++calls;
    right(batch, result);
    if (kBroken) result.bits[0] = static_cast<std::uint8_t>(~result.bits[0]);
  }

  static Kernel Make() {
    Kernel kernel = ScalarEdgeFunction<T>(kLoop);
    if constexpr (std::is_same_v<T, float>) kernel.f32 = &Answer;
    if constexpr (std::is_same_v<T, double>) kernel.f64 = &Answer;
    if constexpr (std::is_same_v<T, std::int32_t>) kernel.i32 = &Answer;
    return kernel;
  }
};

template <class T, Loop kLoop>
void BrokenIsRefusedAndRightIsTimed(std::string_view scene_name) {
  SCOPED_TRACE(Name(kLoop));
  const Scene<T> scene =
      MakeScene<T>(ParseScene(scene_name), kLoop, {}, kDefaultSeed);

  using Broken = Watched<T, kLoop, true>;
  const Kernel broken = Broken::Make();
  const SpeedRun refused = MeasureKernels({&broken}, scene, {1e-6});
  EXPECT_EQ(refused.cells, 1u);
  EXPECT_EQ(refused.refused, 1u);
  EXPECT_EQ(Broken::calls, scene.calls.size());
  ASSERT_FALSE(refused.file.at("benchmarks").empty());
  for (const auto& row : refused.file.at("benchmarks")) {
    EXPECT_TRUE(row.value("error_occurred", false)) << row;
    EXPECT_NE(row.value("error_message", ""), "") << row;
    EXPECT_FALSE(row.contains("items_per_second")) << row;
  }

  using Right = Watched<T, kLoop, false>;
  const Kernel right = Right::Make();
  const SpeedRun timed = MeasureKernels({&right}, scene, {1e-6});
  EXPECT_EQ(timed.refused, 0u);
  EXPECT_GE(Right::calls, scene.calls.size() + kRepetitions);
  for (const auto& row : timed.file.at("benchmarks")) {
    EXPECT_FALSE(row.value("error_occurred", false)) << row;
  }
}

constexpr std::string_view kUniform = "uniform:hit=50:bytes=2k:sets=fixed";

TEST(RefusedKernelsTest, OneTriangle) {
  BrokenIsRefusedAndRightIsTimed<float, Loop::kOneTriangle>(kUniform);
  BrokenIsRefusedAndRightIsTimed<double, Loop::kOneTriangle>(kUniform);
}

TEST(RefusedKernelsTest, OnePoint) {
  BrokenIsRefusedAndRightIsTimed<float, Loop::kOnePoint>(kUniform);
  BrokenIsRefusedAndRightIsTimed<double, Loop::kOnePoint>(kUniform);
}

TEST(RefusedKernelsTest, Pairs) {
  BrokenIsRefusedAndRightIsTimed<float, Loop::kPairs>(kUniform);
  BrokenIsRefusedAndRightIsTimed<double, Loop::kPairs>(kUniform);
}

TEST(RefusedKernelsTest, Grid) {
  BrokenIsRefusedAndRightIsTimed<std::int32_t, Loop::kGrid>(
      "grid_80x50:sets=fixed");
}

}  // namespace
}  // namespace pitbench
