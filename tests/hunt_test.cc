// A hunt finds wrong answers, and what it reports of them is true.
#include "harness/measure/hunt.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "harness/truth/weights.h"
#include "tests/kernel_answers.h"

namespace pitbench {
namespace {

template <class T>
const Kernel& UvProjection() {
  return *KernelsWhere([](const Kernel& k) {
            return k.method.key == "uv_projection" &&
                   k.scalar == ScalarOf<T>() && k.loop == Loop::kPairs &&
                   k.output == Output::kInside;
          }).front();
}

template <class T>
void EveryFindIsWrong() {
  const Kernel& kernel = UvProjection<T>();
  const std::vector<WrongInput<T>> found = Hunt<T>(kernel, 0.2, 1, 5);
  ASSERT_FALSE(found.empty());
  EXPECT_LE(found.size(), 5u);
  for (const WrongInput<T>& input : found) {
    const auto& [a, b, c] = input.triangle;
    const AnswerTable<T> answer =
        AskAll<T>(kernel, {input.triangle}, {input.p});
    EXPECT_EQ(answer.Inside(0, 0), input.said_inside);
    EXPECT_EQ(ClassifyExactly(input.triangle, input.p), input.truth);
    EXPECT_NE(input.truth, Position::kBoundary);
    EXPECT_NE(input.truth == Position::kInside, input.said_inside);
    EXPECT_EQ(input.distance_ulps,
              BoundaryDistanceInUlps(input.triangle, input.p));
    for (const T x : {a.x, a.y, b.x, b.y, c.x, c.y, input.p.x, input.p.y}) {
      EXPECT_LE(std::abs(x), 1);
      EXPECT_TRUE(x == 0 || std::abs(x) >= static_cast<T>(0x1p-30));
    }
    EXPECT_GE(std::max(std::abs(input.p.x), std::abs(input.p.y)), 0.5);
  }
  EXPECT_TRUE(std::is_sorted(found.begin(), found.end(),
                             [](const auto& one, const auto& other) {
                               return one.distance_ulps > other.distance_ulps;
                             }));
}

TEST(HuntTest, EveryFindIsWrongF32) { EveryFindIsWrong<float>(); }
TEST(HuntTest, EveryFindIsWrongF64) { EveryFindIsWrong<double>(); }

// Ulps from the boundary: random needles alone give a thousand.
TEST(HuntTest, ClimbsFarFromTheBoundary) {
  const auto found = Hunt<float>(UvProjection<float>(), 0.2, 1, 1);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_GT(found[0].distance_ulps, 1e5);
}

// A kernel that is always right: truth itself.
TEST(HuntTest, FindsNothingWhereNothingIsWrong) {
  Kernel right = UvProjection<float>();
  right.f32 = [](const Batch<float>& b, const Result<float>& result) {
    std::fill_n(result.bits, BitBytes(b.n), std::uint8_t{0});
    for (std::size_t i = 0; i < b.n; ++i) {
      const Triangle<float> t{
          {b.ax[i], b.ay[i]}, {b.bx[i], b.by[i]}, {b.cx[i], b.cy[i]}};
      if (Classify(t, Point<float>{b.px[i], b.py[i]}) == Position::kInside) {
        result.bits[i / 8] =
            static_cast<std::uint8_t>(result.bits[i / 8] | 1u << (i % 8));
      }
    }
  };
  const auto found = Hunt<float>(right, 0.1, 1, 5);
  EXPECT_TRUE(found.empty());
  EXPECT_EQ(HuntCsv(right, found),
            "method,scalar,ax,ay,bx,by,cx,cy,px,py,said,truth,distance_ulps\n"
            "uv_projection,f32,,,,,,,,,none_found,,\n");
}

TEST(HuntTest, CsvHoldsHexFloats) {
  const std::vector<WrongInput<float>> found = {
      {{{0, 0}, {1, 0}, {1, 0x1p-13f}},
       {0.75f, 0x1p-15f},
       false,
       Position::kInside,
       512}};
  EXPECT_EQ(
      HuntCsv(UvProjection<float>(), found),
      "method,scalar,ax,ay,bx,by,cx,cy,px,py,said,truth,distance_ulps\n"
      "uv_projection,f32,0x0p+0,0x0p+0,0x1p+0,0x0p+0,0x1p+0,0x1p-13,0x1.8p-1,"
      "0x1p-15,outside,inside,512\n");
}

}  // namespace
}  // namespace pitbench
