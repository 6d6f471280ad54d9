// The worst known inputs of orient2d's filter: were its bound smaller by a
// quarter, or its guard against underflow missing, it would give the wrong
// sign. Random inputs do not come near either.
#include <gtest/gtest.h>

#include "harness/truth/orientation.h"

namespace pitbench {
namespace {

struct Products {
  double left;
  double right;
};

Products RoundedProducts(Point<double> a, Point<double> b, Point<double> c) {
  return {.left = (b.x - a.x) * (c.y - a.y),
          .right = (b.y - a.y) * (c.x - a.x)};
}

// All six roundings go the wrong way by nearly half an ulp each: the
// differences because ax and ay lie near half an ulp of one coordinate and of
// the other, 2^30 times larger one; the products because 2^25 · 2^26 is half
// an ulp, a tie. Exactly the determinant is about +1.4e-24; rounded it is −3
// ulps, 2.9999999 · 2^-53 times the sum of the products. The bound is 4.
TEST(OrientationWorstInputTest, EveryRoundingNearItsWorst) {
  const Point<double> a = {-0x1.fffffff8p-54, -0x1.00000004p-23};
  const Point<double> b = {0x1.0000002p+0, 0x1.0000004000001p+30};
  const Point<double> c = {0x1.fffffc4p-31, 0x1.fffffc8p-1};
  const auto [left, right] = RoundedProducts(a, b, c);
  EXPECT_EQ(left - right, -0x3p-52);
  EXPECT_GT(right - left, 2.999 * 0x1p-53 * (left + right));
  EXPECT_EQ(Orientation(a, b, c), 1);
  EXPECT_EQ(OrientationExactly(a, b, c), 1);
  EXPECT_EQ(Orientation(a, c, b), -1);
}

// In units of 2^-1074 the left product is 2.5 + 2^-63 and rounded to 2; the
// right one is less, about 2.5 + 0.63 · 2^-63, and rounded to 3. For ax is lost
// in the differences, and then the left one is a tie and the right one just
// above it.
TEST(OrientationWorstInputTest, ProductsThatUnderflow) {
  const Point<double> a = {-0x1p-600, 0};
  const Point<double> b = {0x1.4p-536, 0x1.4000005p-538};
  const Point<double> c = {0x1.ffffff8000002p-536, 0x1p-537};
  const auto [left, right] = RoundedProducts(a, b, c);
  EXPECT_EQ(left, 0x2p-1074);
  EXPECT_EQ(right, 0x3p-1074);
  EXPECT_EQ(Orientation(a, b, c), 1);
  EXPECT_EQ(OrientationExactly(a, b, c), 1);
  EXPECT_EQ(Orientation(a, c, b), -1);
}

}  // namespace
}  // namespace pitbench
