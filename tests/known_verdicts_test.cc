// What each method is known to say of single inputs: published bugs, and the
// small cases that show why a method fails. A failure that goes away is worth
// knowing as much as a new one.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "harness/truth/expected.h"
#include "harness/truth/weights.h"
#include "kernels/kernels.h"
#include "tests/kernel_answers.h"
#include "tests/real_world_cases.h"

namespace pitbench {
namespace {

using Methods = std::set<std::string_view>;

enum class Cause {
  kRounding,         // the point is nearer to an edge than u of the triangle
  kGramDeterminant,  // 0, since it is the square of an area of 2^-13 (2^-27)
  kMatrixFarAway,    // 4096.5² has 25 bits: the 3×3 determinant is 0 in f32
};

// The methods that get a case wrong, under their own boundary rule. Cases that
// are not listed everybody gets right.
struct KnownFailure {
  std::string_view id;
  Scalar scalar;
  Cause cause;
  Methods methods;
};
const std::vector<KnownFailure> kKnownFailures = {
    {"geos_1207",
     Scalar::kF64,
     Cause::kRounding,
     {"barycentric_determinant", "barycentric_determinant_closed",
      "barycentric_determinant_closed_fma", "barycentric_determinant_fma",
      "barycentric_inverse", "barycentric_inverse_fma", "cross_product",
      "cross_product_early_out", "cross_product_unhoisted", "cross_product_det",
      "cross_product_det_fma", "edge_function", "epsilon", "uv_projection",
      "uv_projection_fma", "edge_slope", "edge_slope_fma", "epsilon_fma"}},
    {"geos_968",
     Scalar::kF64,
     Cause::kRounding,
     {"barycentric_inverse", "barycentric_inverse_fma", "edge_function",
      "edge_function_fma", "epsilon", "epsilon_fma"}},
    {"delaunator_43",
     Scalar::kF64,
     Cause::kRounding,
     {"barycentric_inverse", "barycentric_inverse_fma", "edge_function_fma",
      "edge_function_top_left_fma"}},
    {"drtk_9",
     Scalar::kF32,
     Cause::kRounding,
     {"barycentric_inverse", "barycentric_inverse_fma"}},
    {"gram_needle_f32",
     Scalar::kF32,
     Cause::kGramDeterminant,
     {"uv_projection", "uv_projection_fma"}},
    {"gram_needle_f64",
     Scalar::kF64,
     Cause::kGramDeterminant,
     {"uv_projection", "uv_projection_fma"}},
    {"gram_needle_f64",
     Scalar::kF32,
     Cause::kGramDeterminant,
     {"uv_projection", "uv_projection_fma"}},
    {"inverse_far",
     Scalar::kF32,
     Cause::kMatrixFarAway,
     {"barycentric_inverse"}},
    {"fma_hole_abc",
     Scalar::kF32,
     Cause::kRounding,
     {"barycentric_inverse", "cross_product_centered_fma", "cross_solve_fma",
      "edge_function_fma", "uv_projection", "uv_projection_fma", "edge_slope",
      "edge_slope_fma", "cross_product_centered_top_left_fma",
      "cross_solve_published_fma", "edge_function_top_left_fma"}},
    {"fma_hole_abd",
     Scalar::kF32,
     Cause::kRounding,
     {"barycentric_determinant",
      "barycentric_determinant_closed",
      "barycentric_inverse",
      "barycentric_inverse_fma",
      "cross_product",
      "cross_product_early_out",
      "cross_product_unhoisted",
      "cross_product_centered",
      "cross_product_det",
      "cross_product_kahan",
      "cross_solve",
      "cross_solve_fma",
      "cross_solve_published",
      "edge_function",
      "edge_function_fma",
      "epsilon",
      "edge_slope",
      "edge_slope_fma",
      "cross_solve_published_fma",
      "edge_function_top_left_fma",
      "epsilon_fma"}},
    {"base_vertex_hole",
     Scalar::kF32,
     Cause::kRounding,
     {"barycentric_determinant", "barycentric_determinant_closed",
      "barycentric_determinant_closed_fma", "barycentric_determinant_fma",
      "barycentric_inverse", "barycentric_inverse_fma", "cross_product",
      "cross_product_early_out", "cross_product_unhoisted",
      "cross_product_centered_top_left", "cross_product_det",
      "cross_product_det_fma", "edge_slope", "edge_slope_fma"}},
    {"double_not_exact",
     Scalar::kF32,
     Cause::kRounding,
     {"barycentric_determinant_closed",
      "barycentric_determinant_closed_fma",
      "barycentric_inverse",
      "barycentric_inverse_fma",
      "cross_product",
      "cross_product_early_out",
      "cross_product_unhoisted",
      "cross_product_centered",
      "cross_product_centered_fma",
      "cross_product_det",
      "cross_product_det_fma",
      "cross_product_kahan",
      "cross_solve",
      "cross_solve_fma",
      "epsilon",
      "uv_projection",
      "uv_projection_fma",
      "edge_slope",
      "edge_slope_fma",
      "epsilon_fma"}},
    {"double_not_exact",
     Scalar::kF64,
     Cause::kRounding,
     {"barycentric_determinant", "barycentric_determinant_closed",
      "barycentric_determinant_closed_fma", "barycentric_determinant_fma",
      "cross_product", "cross_product_early_out", "cross_product_unhoisted",
      "cross_product_det", "cross_product_det_fma", "epsilon", "edge_slope",
      "edge_slope_fma", "epsilon_fma"}},
    {"jts_dd",
     Scalar::kF64,
     Cause::kRounding,
     {"barycentric_determinant",
      "barycentric_determinant_closed",
      "barycentric_determinant_closed_fma",
      "barycentric_determinant_fma",
      "barycentric_inverse",
      "barycentric_inverse_fma",
      "cross_product",
      "cross_product_early_out",
      "cross_product_unhoisted",
      "cross_product_centered",
      "cross_product_centered_fma",
      "cross_product_centered_top_left",
      "cross_product_det",
      "cross_product_det_fma",
      "cross_product_kahan",
      "cross_solve",
      "cross_solve_fma",
      "double_double",
      "edge_function_top_left",
      "cross_product_centered_top_left_fma"}},
    {"jts_163", Scalar::kF64, Cause::kRounding, {"edge_function_top_left"}},
    {"geos_failure4",
     Scalar::kF64,
     Cause::kRounding,
     {"cross_product_centered_top_left", "edge_function_top_left",
      "uv_projection_fma"}},
    {"drtk_9_other", Scalar::kF64, Cause::kRounding, {"uv_projection_fma"}},
};

// Whether rounding once can move p across an edge, or for a method that
// accepts a third, across the border of that.
template <class T>
bool WithinRounding(const Triangle<T>& t, const Point<T>& p) {
  const std::array<mpq_class, 3> w = ExactWeights(t, p);
  const double u = static_cast<double>(std::numeric_limits<T>::epsilon()) / 2;
  return std::any_of(w.begin(), w.end(), [u](const mpq_class& weight) {
    return std::abs(weight.get_d()) < u;
  });
}

template <class T>
void ExpectKnownFailuresOnly(const RealWorldCase& one) {
  const Triangle<T> t = one.TriangleAs<T>();
  const Point<T> p = one.PointAs<T>();
  const auto known = std::find_if(kKnownFailures.begin(), kKnownFailures.end(),
                                  [&one](const KnownFailure& failure) {
                                    return failure.id == one.id &&
                                           failure.scalar == ScalarOf<T>();
                                  });
  const bool listed = known != kKnownFailures.end();
  for (const Kernel* kernel : FloatKernels()) {
    if (kernel->scalar != ScalarOf<T>()) continue;
    // Those cases are near an edge, where a method that snaps says anything.
    if (kernel->method.snap_distance > 0) continue;
    const bool wrong = Says(*kernel, t, p) != Expected<T>(kernel->method, t, p);
    EXPECT_EQ(wrong, listed && known->methods.contains(kernel->method.key))
        << one.id << ": " << NameOf(*kernel);
  }
  if (listed && known->cause == Cause::kRounding) {
    EXPECT_TRUE(WithinRounding(t, p)) << one.id << " has another cause";
  }
}

// Each case in its own scalar, and in the other where that holds it exactly.
TEST(KnownVerdictsTest, RealWorldCasesFailWhereKnownAndNowhereElse) {
  std::size_t asked = 0;
  for (const RealWorldCase& one : RealWorldCases()) {
    if (one.Fits<float>()) {
      ExpectKnownFailuresOnly<float>(one);
      ++asked;
    }
    if (one.Fits<double>()) {
      ExpectKnownFailuresOnly<double>(one);
      ++asked;
    }
  }
  EXPECT_EQ(asked, 26u + 18u);
  for (const KnownFailure& failure : kKnownFailures) {
    const auto cases = RealWorldCases();
    EXPECT_TRUE(std::any_of(
        cases.begin(), cases.end(),
        [&](const RealWorldCase& one) { return one.id == failure.id; }))
        << failure.id;
  }
}

// Calls test(kernel) for every kernel of the method and scalar T.
template <class T, class Test>
void ForMethod(std::string_view method, const Test& test) {
  for (const Kernel* kernel : FloatKernels()) {
    if (kernel->method.key == method && kernel->scalar == ScalarOf<T>()) {
      SCOPED_TRACE(NameOf(*kernel));
      test(*kernel);
    }
  }
}

// Both factors of each product are the same two numbers, but only one product
// is rounded: what is left is the rounding error of the other, here
// 0x1.eb852p-32. For the vertex B of a triangle from the origin it has the
// sign that throws B out when x is negated, and the half of it for the
// midpoint of AB.
TEST(KnownVerdictsTest, FmaMakesTheCrossProductOfAVectorWithItselfNonzero) {
  const float x = 0x1.99999ap-4f;
  const float y = 0x1.333334p-2f;
  EXPECT_EQ(std::fma(x, y, -(y * x)), 0x1.eb852p-32f);
  const Triangle<float> t{{0, 0}, {-x, y}, {-1, 0}};
  for (const Point<float>& p : {t.b, Point<float>{-x / 2, y / 2}}) {
    EXPECT_EQ(Classify(t, p), Position::kBoundary);
    ForMethod<float>("cross_product_det_fma", [&](const Kernel& kernel) {
      EXPECT_FALSE(Says(kernel, t, p)) << p;
    });
    for (const char* method : {"cross_product", "cross_product_det"}) {
      ForMethod<float>(method, [&](const Kernel& kernel) {
        EXPECT_TRUE(Says(kernel, t, p)) << p;
      });
    }
  }
}

// The midpoint of the edge that two triangles share: from either side the
// rounding error of the product has the same sign, and both lose it.
TEST(KnownVerdictsTest, FmaLosesAPointOfTheEdgeThatTwoTrianglesShare) {
  const Point<float> a{0, 0};
  const Point<float> b{-0x1.99999ap-4f, 0x1.333334p-2f};
  const Point<float> middle{b.x / 2, b.y / 2};
  const Triangle<float> left{a, b, {-1, 0}};
  const Triangle<float> right{b, a, {1, 0}};
  ForMethod<float>("cross_product_det_fma", [&](const Kernel& kernel) {
    EXPECT_FALSE(Says(kernel, left, middle) || Says(kernel, right, middle));
  });
  for (const char* method :
       {"cross_product", "cross_product_det", "cross_solve"}) {
    ForMethod<float>(method, [&](const Kernel& kernel) {
      EXPECT_TRUE(Says(kernel, left, middle) && Says(kernel, right, middle));
    });
  }
}

// Every product is 0 and 0 ≥ 0 holds, but so is the area: degenerate.
TEST(KnownVerdictsTest, UnderflowMakesATriangleEmptyAndNotFull) {
  const Triangle<double> t{{0, 0}, {1e-170, 0}, {0, 1e-170}};
  for (const Kernel* kernel : FloatKernels()) {
    if (kernel->scalar != Scalar::kF64) continue;
    EXPECT_FALSE(Says<double>(*kernel, t, {3e-170, 3e-170})) << NameOf(*kernel);
    EXPECT_EQ(Says<double>(*kernel, t, {1e-171, 1e-171}), IsExact(*kernel))
        << NameOf(*kernel);
  }
}

TEST(KnownVerdictsTest, CrossSolveAsPublishedRejectsMostOfTheInterior) {
  const Triangle<double> t{{0, 0}, {4, 0}, {0, 4}};
  ForMethod<double>("cross_solve_published", [&](const Kernel& kernel) {
    EXPECT_FALSE(Says<double>(kernel, t, {2, 1}));
    EXPECT_FALSE(Says<double>(kernel, t, {1, 2}));
    EXPECT_TRUE(Says<double>(kernel, t, {1, 1}));
    EXPECT_TRUE(Says<double>(kernel, t, {0.5, 1.5}));
  });
  ForMethod<double>("cross_solve", [&](const Kernel& kernel) {
    EXPECT_TRUE(Says<double>(kernel, t, {2, 1}));
  });
}

}  // namespace
}  // namespace pitbench
