// What ray methods are known to say of published bugs. A failure that goes away
// is worth knowing as much as a new one.
#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <vector>

#include "tests/rays/ray_kernel_answers.h"

namespace pitbench {
namespace {

// The same, with the vertices in one of their six orders.
template <class T>
Triangle3<T> Reordered(const Triangle3<T>& t, std::size_t order) {
  const std::array<Point3<T>, 3> v = {t.a, t.b, t.c};
  const std::size_t first = order % 3;
  const std::size_t step = order < 3 ? 1 : 2;
  return {v[first], v[(first + step) % 3], v[(first + 2 * step) % 3]};
}

// Oblikovati 2146: a square, cut along the diagonal that the ray meets.
template <class T>
const std::array<Triangle3<T>, 2> kSquare = {
    Triangle3<T>{{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}},
    Triangle3<T>{{-5, -5, 0}, {5, 5, 0}, {-5, 5, 0}}};
template <class T>
const Ray<T> kOnDiagonal = {{0, 0, 10},
                            {T{0.30458447f}, T{0.30458447f}, T{-0.9024725f}},
                            0,
                            std::numeric_limits<T>::infinity()};

// Which of the square's halves a kernel hits, in an order of their vertices.
template <class T>
std::array<bool, 2> HalvesHit(const RayKernel& kernel, std::size_t order) {
  const auto& [lower, upper] = kSquare<T>;
  return {Hits(kernel, Reordered(lower, order), kOnDiagonal<T>),
          Hits(kernel, Reordered(upper, order), kOnDiagonal<T>)};
}

class RayVerdictsTest : public testing::TestWithParam<const RayKernel*> {};

// The diagonal belongs to both: every method is closed, and exact here.
TEST_P(RayVerdictsTest, WithoutContractionBothHalvesOfASquareHitItsDiagonal) {
  const RayMethod& method = GetParam()->method;
  if (method.fma || method.boundary != Boundary::kClosed) return;
  WithFloatOf(*GetParam(), [&]<class T>(T) {
    const std::array<bool, 2> both = {true, true};
    const std::array<bool, 2> none = {false, false};
    // The ray comes from the front of the first three orders.
    for (std::size_t order = 0; order < 6; ++order) {
      EXPECT_EQ(HalvesHit<T>(*GetParam(), order),
                method.culls_backface && order >= 3 ? none : both)
          << order;
    }
  });
}

// libgdx 6882: a point some thousands of lengths beside the triangle and nearly
// in its plane was said to be in it. As a ray along the normal, either way.
TEST_P(RayVerdictsTest, APointFarBesideATriangleIsNotInIt) {
  WithFloatOf(*GetParam(), [&]<class T>(T) {
    const Triangle3<T> t = {{T{50.008057f}, T{22.20586f}, T{124.62208f}},
                            {T{62.282288f}, T{22.205864f}, T{109.665924f}},
                            {T{70.92052f}, T{7.205861f}, T{115.437805f}}};
    for (const T way : {T{1}, T{-1}}) {
      const Ray<T> ray = {
          {T{-5120.8345f}, T{8946.126f}, T{-3270.5813f}},
          {way * T{224.34233f}, way * T{200.04009f}, way * T{184.11353f}},
          0,
          std::numeric_limits<T>::infinity()};
      EXPECT_FALSE(Hits(*GetParam(), t, ray));
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Every, RayVerdictsTest,
                         testing::ValuesIn(EveryRayKernel()), KernelName());

// With multiply-adds the ray falls between the halves, though not in every
// order of their vertices.
TEST(RayVerdictsOfContractionTest, NeitherHalfOfASquareHitsItsDiagonal) {
  struct Verdict {
    std::string_view method;
    Scalar scalar;
    std::size_t order;
  };
  for (const auto& [method, scalar, order] :
       {Verdict{"moller_trumbore_fma", Scalar::kF32, 3},
        Verdict{"moller_trumbore_early_out_fma", Scalar::kF32, 3},
        Verdict{"plane_project_fma", Scalar::kF32, 0},
        Verdict{"plane_gram_fma", Scalar::kF64, 0}}) {
    for (const RayKernel* kernel : RayKernelsWhere([&](const RayKernel& k) {
           return k.method.key == method && k.scalar == scalar;
         })) {
      WithFloatOf(*kernel, [&]<class T>(T) {
        EXPECT_EQ(HalvesHit<T>(*kernel, order),
                  (std::array<bool, 2>{false, false}))
            << NameOf(*kernel);
      });
    }
  }
}

}  // namespace
}  // namespace pitbench
