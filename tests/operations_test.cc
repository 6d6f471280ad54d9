// The counting kernels: that they are the kernels, and what they count.
#include "harness/measure/operations.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <tuple>

#include "harness/measure/answers.h"
#include "harness/scenes/generate.h"
#include "harness/scenes/spec.h"
#include "kernels/counting/number.h"
#include "tests/kernel_answers.h"

namespace pitbench {
namespace {

using counting::CurrentTape;
using counting::Kind;
using Numbers = counting::Number<float>;
using Named = std::map<std::string, double>;

const Kernel& Counting(std::string_view method, Loop loop) {
  for (const Kernel& kernel : CountingKernels()) {
    if (kernel.method.key == method && kernel.loop == loop &&
        kernel.scalar == Scalar::kF32 && kernel.output == Output::kInside) {
      return kernel;
    }
  }
  throw std::invalid_argument("no counting kernel of that name");
}

// Only what is not 0; without what depends on the loop: memory.
Named Arithmetic(const OperationCounts& counts) {
  Named named;
  for (std::size_t k = 0; k < counting::kKinds; ++k) {
    const auto kind = static_cast<Kind>(k);
    if (counts[k] == 0 || kind == Kind::kLoad || kind == Kind::kStore) continue;
    named[std::string(counting::Name(kind))] = counts[k];
  }
  return named;
}
Named PerPoint(std::string_view method) {
  return Arithmetic(
      CountOperations(Counting(method, Loop::kOneTriangle)).per_item);
}
Named PerTriangle(std::string_view method) {
  return Arithmetic(
      CountOperations(Counting(method, Loop::kOneTriangle)).per_call);
}

// What a counting kernel must agree with: the first that runs here.
const Kernel* Counterpart(const Kernel& counting) {
  for (const Kernel& kernel : AllKernels()) {
    if (kernel.method.key == counting.method.key &&
        kernel.scalar == counting.scalar && kernel.loop == counting.loop &&
        kernel.output == counting.output && RunsHere(kernel.isa)) {
      return &kernel;
    }
  }
  return nullptr;
}

template <class T>
void ExpectSameAnswers(const Kernel& counting, const Kernel& kernel,
                       std::initializer_list<const char*> scenes) {
  for (const char* name : scenes) {
    const Scene<T> scene = MakeScene<T>(ParseScene(name), counting.loop,
                                        {.groups = 3, .size = 150}, 7);
    const Answers<T> counted = Run(counting, scene);
    CurrentTape().Clear();
    const Answers<T> answers = Run(kernel, scene);
    EXPECT_TRUE(counted.bits == answers.bits)
        << NameOf(counting) << " and " << NameOf(kernel) << " on " << name;
    for (std::size_t w = 0; w < 3; ++w) {
      ASSERT_EQ(counted.weights[w].size(), answers.weights[w].size());
      for (std::size_t c = 0; c < answers.weights[w].size(); ++c) {
        EXPECT_EQ(counted.weights[w][c], answers.weights[w][c])
            << NameOf(counting) << " on " << name;
      }
    }
  }
}

// Otherwise the counts would be of another program.
TEST(OperationsTest, CountingKernelsAnswerToTheLastBitAsTheKernelsDo) {
  std::size_t compared = 0;
  for (const Kernel& counting : CountingKernels()) {
    const Kernel* const kernel = Counterpart(counting);
    if (kernel == nullptr) continue;  // multiply-add, where no ISA here has it
    ++compared;
    switch (counting.scalar) {
      case Scalar::kF32:
        ExpectSameAnswers<float>(counting, *kernel,
                                 {"near_edge:ulps=1", "needle:aspect=10"});
        break;
      case Scalar::kF64:
        ExpectSameAnswers<double>(counting, *kernel,
                                  {"near_edge:ulps=1", "needle:aspect=24"});
        break;
      case Scalar::kI32:
        ExpectSameAnswers<std::int32_t>(
            counting, *kernel,
            {kernel->loop == Loop::kGrid ? "grid_80x50:sets=fixed"
                                         : "grid_points_80x50:sets=fixed"});
        break;
      case Scalar::kI16:
        ExpectSameAnswers<std::int16_t>(counting, *kernel,
                                        {"grid_points_80x50:sets=fixed"});
        break;
      case Scalar::kU8:
        ADD_FAILURE() << "no method counts in bytes";
        break;
    }
  }
  EXPECT_GT(compared, 100u);
}

// Of the files that kernels/CMakeLists.txt leaves out.
const std::set<std::string_view> kUncounted = {
    "byte_pairs",   "byte_spans", "edge_lanes",       "grid_incremental",
    "grid_clipped", "row_spans",  "row_spans_batched"};

TEST(OperationsTest, EveryKernelOfAvx512IsCountedAndNoOther) {
  using Key = std::tuple<std::string_view, Scalar, Loop, Output>;
  std::set<Key> counted;
  std::set<Key> compiled;
  for (const Kernel& k : CountingKernels()) {
    EXPECT_EQ(k.isa, Isa::kCounting);
    counted.emplace(k.method.key, k.scalar, k.loop, k.output);
  }
  for (const Kernel& k : AllKernels()) {
    EXPECT_NE(k.isa, Isa::kCounting) << "it would be timed";
    // The arithmetic of points side by side is that of loop one_triangle.
    if (k.isa == Isa::kAvx512 && k.loop != Loop::kOneTriangleAos &&
        !kUncounted.contains(k.method.key)) {
      compiled.emplace(k.method.key, k.scalar, k.loop, k.output);
    }
  }
  if (compiled.empty()) GTEST_SKIP() << "not compiled for x86-64";
  EXPECT_EQ(counted, compiled);
}

// By hand, from the formulas in the methods' files.
TEST(OperationsTest, EdgeFunctionsTakeSixProductsAndSixSumsAPoint) {
  EXPECT_EQ(
      PerPoint("edge_function"),
      (Named{{"multiply", 6}, {"add", 6}, {"min_max", 1}, {"compare", 2}}));
  EXPECT_EQ(PerPoint("edge_function_fma"),
            (Named{{"multiply_add", 6}, {"min_max", 1}, {"compare", 2}}));
  // Eight differences of vertices, the area, and −(A·x + B·y) three times;
  // two products of the area, A and B by the winding, and those of C.
  EXPECT_EQ(PerTriangle("edge_function"), (Named{{"add", 8 + 1 + 3 * 2},
                                                 {"multiply", 2 + 6 + 6},
                                                 {"compare", 2},
                                                 {"logic", 4}}));
}

TEST(OperationsTest, CrossProductComparesSixProductsOfSixDifferences) {
  // With the sum and the multiply-add that make an infinite point NaN.
  EXPECT_EQ(PerPoint("cross_product"), (Named{{"add", 6 + 1},
                                              {"multiply", 6},
                                              {"multiply_add", 1},
                                              {"compare", 3}}));
  EXPECT_EQ(
      PerTriangle("cross_product"),
      (Named{
          {"add", 8 + 1}, {"multiply", 2 + 6}, {"compare", 2}, {"logic", 4}}));
}

// qTriangle 2018: 9 subtractions, 6 multiplications, 3 comparisons. A minimum
// of two numbers, compared once, takes the place of two comparisons.
TEST(OperationsTest, ClaimOf2018HoldsForTheFormThatSubtractsProducts) {
  EXPECT_EQ(
      PerPoint("cross_product_det"),
      (Named{{"add", 9}, {"multiply", 6}, {"min_max", 1}, {"compare", 2}}));
}

// qTriangle 2019: 6 subtractions, 6 multiplications, 3 comparisons: so it is
// but for what the contract asks for about points at infinity.
TEST(OperationsTest, ClaimOf2019HoldsForTheFormThatComparesProducts) {
  const Named counted = PerPoint("cross_product");
  EXPECT_EQ(counted.at("add"), 6 + 1);
  EXPECT_EQ(counted.at("multiply"), 6);
  EXPECT_EQ(counted.at("compare"), 3);
}

// qTriangle 2019: 6 additions, 9 multiplications, 3 comparisons.
TEST(OperationsTest, InverseMatrixTakesSixProductsAPointAndNotNine) {
  EXPECT_EQ(
      PerPoint("barycentric_inverse"),
      (Named{{"add", 6}, {"multiply", 6}, {"min_max", 1}, {"compare", 2}}));
  EXPECT_EQ(PerTriangle("barycentric_inverse").at("divide"), 1);
}

TEST(OperationsTest, ExactTakesThreeMultiplyAddsAPointAsLinesDo) {
  // Two operations take the lines from y, one the lesser of the two distances,
  // and one keeps the least of all, which tells whether all are decided. That
  // is asked too rarely to be counted of a point. The sign is made a mask.
  EXPECT_EQ(PerPoint("edge_slope_fma"),
            (Named{{"multiply_add", 3}, {"min_max", 1}, {"compare", 2}}));
  EXPECT_EQ(PerPoint("exact"), (Named{{"multiply_add", 3},
                                      {"add", 2},
                                      {"min_max", 1},
                                      {"integer_min_max", 1 + 1},
                                      {"logic", 1}}));
}

TEST(OperationsTest, PairsPayTheSetUpForEveryItem) {
  const Named set_up = PerTriangle("edge_function_fma");
  const Named point = PerPoint("edge_function_fma");
  const Named pair = Arithmetic(
      CountOperations(Counting("edge_function_fma", Loop::kPairs)).per_item);
  EXPECT_EQ(pair.at("multiply"), set_up.at("multiply"));
  EXPECT_EQ(pair.at("multiply_add"), point.at("multiply_add"));
  EXPECT_EQ(pair.at("add"), set_up.at("add"));
}

TEST(OperationsTest, WhatIsComputedTwiceCountsOnceAndWhatIsUnusedNever) {
  CurrentTape().Clear();
  const Numbers a = 2.0F;
  const Numbers b = 3.0F;
  const Numbers sum = a + b;
  const Numbers product = (a + b) * sum;
  const Numbers unused = a / b;
  EXPECT_EQ(static_cast<float>(product), 25.0F);
  const counting::Operations counts = CurrentTape().Count();
  CurrentTape().Clear();
  (void)unused;
  EXPECT_EQ(counts[static_cast<std::size_t>(Kind::kAdd)], 1u);
  EXPECT_EQ(counts[static_cast<std::size_t>(Kind::kMultiply)], 1u);
  EXPECT_EQ(counts[static_cast<std::size_t>(Kind::kDivide)], 0u);
}

}  // namespace
}  // namespace pitbench
