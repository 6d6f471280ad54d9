// Traces of instructions, and the loop found in them.
#include "harness/measure/instruction_trace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

#include "harness/measure/instructions.h"

namespace pitbench {
namespace {

// Three instructions before a loop, two behind it.
Trace Around(const Trace& loop) {
  Trace trace = {1, 2, 3};
  trace.insert(trace.end(), loop.begin(), loop.end());
  trace.insert(trace.end(), {90, 91});
  return trace;
}
Trace Repeated(const Trace& iteration, std::size_t times) {
  Trace loop;
  for (std::size_t i = 0; i < times; ++i) {
    loop.insert(loop.end(), iteration.begin(), iteration.end());
  }
  return loop;
}

TEST(SteadyLoopTest, OneLoopIsFoundWithItsItems) {
  const Trace iteration = {10, 14, 18, 22};
  const SteadyLoop loop = FindSteadyLoop(Around(Repeated(iteration, 8)),
                                         Around(Repeated(iteration, 16)), 64,
                                         /*around=*/2);
  EXPECT_EQ(loop.items, 8u);
  EXPECT_EQ(loop.per_item, 0.5);
  EXPECT_EQ(loop.per_call, 3);
  EXPECT_EQ(loop.iteration, iteration);
}

TEST(SteadyLoopTest, InnerLoopIsWrittenOutInTheOuterOne) {
  const Trace iteration = {10, 20, 24, 20, 24, 20, 24, 30};
  const SteadyLoop loop =
      FindSteadyLoop(Around(Repeated(iteration, 4)),
                     Around(Repeated(iteration, 8)), 32, /*around=*/5);
  EXPECT_EQ(loop.items, 8u);
  EXPECT_EQ(loop.iteration, iteration);
  EXPECT_EQ(loop.per_call, 0);
}

TEST(SteadyLoopTest, IterationsOfDifferentLengthsAreNoSteadyLoop) {
  const Trace once = Around({10, 12, 30, 10, 30});
  const Trace twice = Around({10, 12, 30, 10, 30, 10, 12, 14, 30, 10, 30});
  const SteadyLoop loop = FindSteadyLoop(once, twice, 2, /*around=*/5);
  EXPECT_EQ(loop.items, 0u);
  EXPECT_TRUE(loop.iteration.empty());
  EXPECT_EQ(loop.per_item, 3);
}

TEST(InstructionLengthTest, BranchesTellTheirOwnLength) {
  const auto length = [](std::initializer_list<std::uint8_t> bytes,
                         std::ptrdiff_t step) {
    std::uint8_t memory[1024] = {};
    std::uint8_t* const code = memory + 256;
    std::copy(bytes.begin(), bytes.end(), code);
    return InstructionLength(code, code + step);
  };
  EXPECT_EQ(length({0x75, 0xF0}, -14), 2u);                        // jne
  EXPECT_EQ(length({0x75, 0x05}, 7), 2u);                          // forward
  EXPECT_EQ(length({0x0F, 0x85, 0, 0, 0, 0}, -99), 6u);            // jne
  EXPECT_EQ(length({0xE8, 0, 0, 0, 0}, 500), 5u);                  // call
  EXPECT_EQ(length({0xC3}, 500), 1u);                              // ret
  EXPECT_EQ(length({0xFF, 0x25, 0, 0, 0, 0}, 500), 6u);            // jmp *
  EXPECT_EQ(length({0xC5, 0xF8, 0x28, 0xC1}, 4), 4u);              // vmovaps
  EXPECT_EQ(length({0x62, 0xF1, 0x7C, 0x48, 0x58, 0xC1}, 6), 6u);  // vaddps
}

TEST(TraceTest, TheSameCallGivesTheSameTrace) {
  if (!CannotTrace().empty()) GTEST_SKIP() << CannotTrace();
  volatile int sink = 0;
  const auto count_to = [&sink](int n) {
    return TraceOf([&sink, n] {
      for (int i = 0; i < n; ++i) sink = i;
    });
  };
  count_to(4);
  const Trace four = count_to(4);
  EXPECT_EQ(four, count_to(4));
  const std::size_t eight = count_to(8).size();
  const std::size_t twelve = count_to(12).size();
  EXPECT_GT(eight, four.size());
  EXPECT_EQ(twelve - eight, eight - four.size());
}

// 6 multiply-adds a vector of 16 points on AVX-512: an iteration holds them
// and little else.
TEST(TraceTest, WidestEdgeFunctionTakesFourVectorsAnIteration) {
  if (!CannotTrace().empty()) GTEST_SKIP() << CannotTrace();
  if (!RunsHere(Isa::kAvx512)) GTEST_SKIP() << "no AVX-512 here";
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the sanitizer's own instructions stand in the loop";
#endif
  for (const Kernel& kernel : AllKernels()) {
    if (kernel.method.key != "edge_function_fma" ||
        kernel.isa != Isa::kAvx512 || kernel.scalar != Scalar::kF32 ||
        kernel.loop != Loop::kOneTriangle || kernel.output != Output::kInside) {
      continue;
    }
    const SteadyLoop loop = TraceKernel(kernel);
    EXPECT_EQ(loop.items, 64u);
    // Six multiply-adds, two loads, a minimum and two comparisons a vector.
    EXPECT_GE(loop.iteration.size(), 4 * (6u + 2 + 3));
    EXPECT_EQ(loop.per_item * 64, static_cast<double>(loop.iteration.size()));
    EXPECT_EQ(InstructionBytes(loop.iteration).size(), loop.iteration.size());
  }
}

}  // namespace
}  // namespace pitbench
