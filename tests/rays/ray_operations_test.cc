// The counting ray kernels: that they are the kernels, and what they count.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <tuple>

#include "harness/measure/operations.h"
#include "harness/measure/rays/ray_answers.h"
#include "harness/scenes/generate.h"
#include "harness/scenes/spec.h"
#include "tests/rays/ray_kernel_answers.h"

namespace pitbench {
namespace {

using counting::CurrentTape;
using counting::Kind;
using Named = std::map<std::string, double>;
using Key = std::tuple<std::string_view, Scalar, RayLoop, RayOutput>;

Key KeyOf(const RayKernel& k) {
  return {k.method.key, k.scalar, k.loop, k.output};
}

// Additions, products, divisions and comparisons that are counted a ray, and
// those of the set-up.
CountedKernel Counted(std::string_view method, Scalar scalar = Scalar::kF32,
                      RayLoop loop = RayLoop::kOneTriangleRays,
                      RayOutput output = RayOutput::kHits) {
  for (const RayKernel& k : CountingRayKernels()) {
    if (KeyOf(k) == Key(method, scalar, loop, output)) {
      return CountOperations(k);
    }
  }
  throw std::invalid_argument("no counting kernel of that name");
}
Named Arithmetic(const OperationCounts& counts) {
  Named named;
  for (const Kind kind : {Kind::kAdd, Kind::kMultiply, Kind::kMultiplyAdd,
                          Kind::kDivide, Kind::kMinMax, Kind::kCompare}) {
    const double count = counts[static_cast<std::size_t>(kind)];
    if (count != 0) named[std::string(counting::Name(kind))] = count;
  }
  return named;
}

template <class T>
void ExpectSameAnswers(const RayKernel& counting, const RayKernel& kernel) {
  for (const char* name :
       {"rays_near_edge:ulps=1", "rays_grazing:exponent=12"}) {
    const RayScene<T> scene = MakeRayScene<T>(ParseScene(name), counting.loop,
                                              {.groups = 2, .size = 70}, 7);
    Answers<T> counted;
    Answers<T> answers;
    Run(counting, scene, counted);
    CurrentTape().Clear();
    Run(kernel, scene, answers);
    EXPECT_TRUE(counted.bits == answers.bits)
        << counting.method.key << " " << Name(counting.loop, counting.output)
        << " on " << name;
  }
}

// Otherwise the counts would be of another program.
TEST(RayOperationsTest, CountingKernelsAnswerAsTheKernelsDo) {
  std::map<Key, const RayKernel*> kernels;
  for (const RayKernel* k : EveryRayKernel()) kernels.emplace(KeyOf(*k), k);
  std::size_t compared = 0;
  for (const RayKernel& counting : CountingRayKernels()) {
    const auto found = kernels.find(KeyOf(counting));
    if (found == kernels.end()) continue;  // multiply-add that no ISA has
    ++compared;
    if (counting.scalar == Scalar::kF32) {
      ExpectSameAnswers<float>(counting, *found->second);
    } else {
      ExpectSameAnswers<double>(counting, *found->second);
    }
  }
  EXPECT_GT(compared, 50u);
}

TEST(RayOperationsTest, EveryKernelOfAvx512IsCountedAndNoOther) {
  std::set<Key> counted;
  std::set<Key> compiled;
  for (const RayKernel& k : CountingRayKernels()) {
    EXPECT_EQ(k.isa, Isa::kCounting);
    counted.insert(KeyOf(k));
  }
  for (const RayKernel& k : AllRayKernels()) {
    EXPECT_NE(k.isa, Isa::kCounting) << "it would be timed";
    if (k.isa == Isa::kAvx512) compiled.insert(KeyOf(k));
  }
  if (compiled.empty()) GTEST_SKIP() << "not compiled for x86-64";
  EXPECT_EQ(counted, compiled);
}

// Two cross products of 6 products and 3 differences, four dot products of 3
// and 2, S of 3 differences, u + v, and u, v and t times 1/δ.
TEST(RayOperationsTest, MollerAndTrumboreTakeTwentySevenProductsARay) {
  const double products = 2 * 6 + 4 * 3 + 3;
  EXPECT_EQ(Arithmetic(Counted("moller_trumbore").per_item),
            (Named{{"add", 2 * 3 + 4 * 2 + 3 + 1},
                   {"multiply", products},
                   {"divide", 1},
                   {"min_max", 1},
                   {"compare", 5}}));
  // Contracted, the last two products of a dot product and one of each
  // component of a cross product go into a sum.
  EXPECT_EQ(Arithmetic(Counted("moller_trumbore_fma").per_item),
            (Named{{"add", 3 + 1},
                   {"multiply", products - 14},
                   {"multiply_add", 2 * 3 + 4 * 2},
                   {"divide", 1},
                   {"min_max", 1},
                   {"compare", 5}}));
}

// Three numbers of each vertex, of the origin and of the direction, read once:
// of any other count, a part was not of the call.
TEST(RayOperationsTest, APairIsReadOnce) {
  constexpr auto kLoad = static_cast<std::size_t>(Kind::kLoad);
  std::size_t pairs = 0;
  for (const RayKernel& k : CountingRayKernels()) {
    if (k.loop != RayLoop::kRayPairs) continue;
    ++pairs;
    const CountedKernel counted = CountOperations(k);
    EXPECT_EQ(counted.per_item[kLoad], 15)
        << k.method.key << " " << Name(k.scalar);
    EXPECT_EQ(counted.per_call[kLoad], 0)
        << k.method.key << " " << Name(k.scalar);
  }
  EXPECT_GT(pairs, 20u);
}

// S of 3 differences, a cross product, four dot products, w of 2 differences,
// two ends of the range of two products each, the last one negated. The bounds:
// 6 products for those of the weights and of t, 4 for the ends, each of which
// is asked on both sides, and the largest of D and of S.
// That is all, for the filter decides every ray that is counted.
TEST(RayOperationsTest, TheExactFilterTakesThirtyTwoProductsARay) {
  const double in_sums = 3 + 4 * 2 + 2 + 3 + 2;
  const double products = 6 + 4 * 3 + 4 + 6 + 4;
  for (const std::string_view method : {"exact", "exact_perturbed"}) {
    for (const Scalar scalar : {Scalar::kF32, Scalar::kF64}) {
      EXPECT_EQ(Arithmetic(Counted(method, scalar).per_item),
                (Named{{"add", 3 + 2 + 1 + 4 + 1},
                       {"multiply", products - in_sums},
                       {"multiply_add", in_sums},
                       {"min_max", 4 + 4},
                       {"compare", 5}}))
          << method << " " << Name(scalar);
    }
  }
}

// A bound of one_ray has to hold where nothing is hit: there a call takes,
// beside its triangles, only how large the ray's D is, in one vector.
TEST(RayOperationsTest, NoHitIsCountedForOneRay) {
  for (const std::string_view method : {"exact", "exact_perturbed"}) {
    for (const Scalar scalar : {Scalar::kF32, Scalar::kF64}) {
      const CountedKernel counted =
          Counted(method, scalar, RayLoop::kOneRay, RayOutput::kNearest);
      EXPECT_GT(Arithmetic(counted.per_item).at("multiply_add"), 0);
      EXPECT_EQ(Arithmetic(counted.per_item).count("divide"), 0u);
      const double lanes = scalar == Scalar::kF32 ? 16 : 8;
      EXPECT_EQ(Arithmetic(counted.per_call),
                (Named{{"min_max", 2 * lanes}, {"multiply_add", lanes}}))
          << method << " " << Name(scalar);
    }
  }
}

// N·O, N·D, u and v: two products and two sums each; N·O one sum more, and the
// point two products and two sums; and u + v.
TEST(RayOperationsTest, TheKeptTransformationTakesTenProductsARay) {
  EXPECT_EQ(Arithmetic(Counted("baldwin_weber").per_item),
            (Named{{"add", 12},
                   {"multiply", 10},
                   {"divide", 1},
                   {"min_max", 1},
                   {"compare", 5}}));
  EXPECT_EQ(Arithmetic(Counted("baldwin_weber").per_call).at("divide"), 1);
}

TEST(RayOperationsTest, WatertightDividesFourTimesARayAndOnceATriangleOfOne) {
  EXPECT_EQ(Arithmetic(Counted("watertight").per_item).at("divide"), 4);
  const CountedKernel one_ray = Counted("watertight", Scalar::kF32,
                                        RayLoop::kOneRay, RayOutput::kNearest);
  EXPECT_EQ(Arithmetic(one_ray.per_item).at("divide"), 1);
}

}  // namespace
}  // namespace pitbench
