// A hunt for rays finds wrong answers, and what it reports of them is true; and
// the distance that it goes by is that of geometry.
#include "harness/measure/rays/ray_hunt.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "harness/measure/rays/ray_candidates.h"
#include "harness/truth/ray_distance.h"
#include "harness/truth/vector3.h"
#include "tests/rays/ray_kernel_answers.h"

namespace pitbench {
namespace {

const RayKernel& Pairs(std::string_view method, Scalar scalar) {
  return *RayKernelsWhere([&](const RayKernel& k) {
            return k.method.key == method && k.scalar == scalar &&
                   k.loop == RayLoop::kRayPairs && k.output == RayOutput::kHits;
          }).front();
}

template <class T>
void EveryFindIsWrong(std::string_view method) {
  const RayKernel& kernel = Pairs(method, ScalarOf<T>());
  const std::vector<WrongRay<T>> found = HuntRays<T>(kernel, 0.2, 1, 5);
  ASSERT_FALSE(found.empty());
  EXPECT_LE(found.size(), 5u);
  for (const WrongRay<T>& input : found) {
    const auto& [a, b, c] = input.triangle;
    EXPECT_EQ(Hits(kernel, input.triangle, input.ray), input.said_hit);
    const RayPosition truth = ClassifyExactly(input.triangle, input.ray);
    EXPECT_NE(truth, RayPosition::kBoundary);
    const bool is_hit = truth == RayPosition::kHit &&
                        (!kernel.method.culls_backface ||
                         IsFrontFacing(input.triangle, input.ray));
    EXPECT_NE(is_hit, input.said_hit);
    EXPECT_EQ(input.truth == RayPosition::kHit, is_hit);
    EXPECT_EQ(input.distance_ulps,
              AnswerDistanceInUlps(input.triangle, input.ray));
    T largest = 0;
    const auto expect_confined = [&](const Point3<T>& p) {
      for (const T x : {p.x, p.y, p.z}) {
        EXPECT_LE(std::abs(x), 1);
        EXPECT_TRUE(x == 0 || std::abs(x) >= static_cast<T>(0x1p-30));
        largest = std::max(largest, std::abs(x));
      }
    };
    for (const Point3<T>& p : {a, b, c, input.ray.origin}) expect_confined(p);
    EXPECT_GE(largest, 0.5);
    largest = 0;
    expect_confined(input.ray.direction);
    EXPECT_GE(largest, 0.5);
  }
  EXPECT_TRUE(std::is_sorted(found.begin(), found.end(),
                             [](const auto& one, const auto& other) {
                               return one.distance_ulps > other.distance_ulps;
                             }));
}

TEST(RayHuntTest, EveryFindIsWrongF32) {
  EveryFindIsWrong<float>("moller_trumbore");
}
TEST(RayHuntTest, EveryFindIsWrongF64) {
  EveryFindIsWrong<double>("moller_trumbore");
}
TEST(RayHuntTest, EveryFindIsWrongWhereBackFacesAreMissed) {
  EveryFindIsWrong<float>("moller_trumbore_culled");
}

TEST(RayHuntTest, FindsNothingWhereNothingIsWrong) {
  const RayKernel& exact = Pairs("exact", Scalar::kF32);
  const auto found = HuntRays<float>(exact, 0.1, 1, 5);
  EXPECT_TRUE(found.empty());
  EXPECT_EQ(HuntRaysCsv(exact, found),
            "method,scalar,ax,ay,az,bx,by,bz,cx,cy,cz,ox,oy,oz,dx,dy,dz,said,"
            "truth,distance_ulps\n"
            "exact,f32,,,,,,,,,,,,,,,,none_found,,\n");
}

TEST(RayHuntTest, ClimbsFarFromTheBoundary) {
  const auto found =
      HuntRays<float>(Pairs("plane_gram", Scalar::kF32), 0.2, 1, 1);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_GT(found[0].distance_ulps, 1e4);
}

TEST(RayHuntTest, CsvHoldsHexFloats) {
  const std::vector<WrongRay<float>> found = {
      {{{0, 0, 0}, {1, 0, 0}, {0, 0.5f, 0}},
       {{0.25f, 0.125f, 1}, {0, 0, -1}, 0, 1},
       false,
       RayPosition::kHit,
       512}};
  EXPECT_EQ(HuntRaysCsv(Pairs("watertight", Scalar::kF32), found),
            "method,scalar,ax,ay,az,bx,by,bz,cx,cy,cz,ox,oy,oz,dx,dy,dz,said,"
            "truth,distance_ulps\n"
            "watertight,f32,0x0p+0,0x0p+0,0x0p+0,0x1p+0,0x0p+0,0x0p+0,0x0p+0,"
            "0x1p-1,0x0p+0,0x1p-2,0x1p-3,0x1p+0,0x0p+0,0x0p+0,-0x1p+0,miss,hit,"
            "512\n");
}

// --- the distance -----------------------------------------------------------

constexpr double kUlp = 0x1p-52;  // of 1, in f64

double Distance(const Triangle3<double>& t, const Vector3& origin,
                const Vector3& direction) {
  return kUlp * AnswerDistanceInUlps(t, RayAlong(origin, direction));
}

// In the plane z = 0, with coordinates whose largest is 1.
constexpr Triangle3<double> kFlat{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

TEST(RayDistanceTest, IsThatFromTheNearestEdge) {
  EXPECT_DOUBLE_EQ(Distance(kFlat, {0.25, 0.125, 0.5}, {0, 0, -1}), 0.125);
  EXPECT_DOUBLE_EQ(Distance(kFlat, {0.25, -0.5, 0.5}, {0, 0, -1}), 0.5);
  // Beyond the ends of the edges it is that from the vertex.
  EXPECT_DOUBLE_EQ(Distance(kFlat, {-0.75, -1, 0.5}, {0, 0, -1}), 1.25);
  EXPECT_DOUBLE_EQ(Distance(kFlat, {0.5, 0.5, 0.5}, {0, 0, -1}), 0);
}

TEST(RayDistanceTest, IsThatOfTheOriginFromThePlaneWhereThatIsLess) {
  EXPECT_DOUBLE_EQ(Distance(kFlat, {0.25, 0.25, 0x1p-6}, {0, 0, -1}), 0x1p-6);
  EXPECT_DOUBLE_EQ(Distance(kFlat, {0.25, 0.25, -0x1p-6}, {0, 0, -1}), 0x1p-6);
  // Not where the line misses: then the origin may be in the plane.
  EXPECT_DOUBLE_EQ(Distance(kFlat, {0.25, -0.5, 0}, {0, 0, -1}), 0.5);
}

// The ray meets the plane 1/2 from the nearest edge, but passes it at half an
// angle's distance.
TEST(RayDistanceTest, IsMeasuredAcrossTheRay) {
  const double slope = 0x1p-10;
  EXPECT_NEAR(Distance(kFlat, {-0.5, 0.25, slope}, {1, 0, -slope}), slope / 4,
              1e-3 * slope);
}

TEST(RayDistanceTest, IsThatOfASegmentWhereTheTriangleHasNoArea) {
  const Triangle3<double> flat{{0, 0, 0}, {1, 0, 0}, {0.5, 0, 0}};
  EXPECT_DOUBLE_EQ(Distance(flat, {0.5, 0.25, 0.5}, {0, 0, -1}), 0.25);
}

TEST(RayDistanceTest, IsTheSameForAnyLengthOfTheDirection) {
  const Ray<double> ray = RayAlong<double>({0.25, 0.1, 0.5}, {0.3, 0.1, -0.7});
  const Ray<double> longer = RayAlong<double>({0.25, 0.1, 0.5}, {3, 1, -7});
  EXPECT_NEAR(
      AnswerDistanceInUlps(kFlat, ray) / AnswerDistanceInUlps(kFlat, longer), 1,
      1e-14);
}

// Moving a ray that misses by less than its distance never makes it hit, and
// one that hits never miss: tried in 26 directions.
TEST(RayDistanceTest, NoShorterMoveChangesTheAnswer) {
  RayCandidateSource<float> source(3);
  std::size_t tried = 0;
  while (tried < 2000) {
    const RayCandidate<float> c = source.Draw();
    if (!Admissible(c)) continue;
    const Triangle3<double> t = Widened(TriangleOf(c));
    const Ray<float> r = RayOf(c);
    const Vector3 o = Widened(r.origin);
    const Ray<double> ray = RayAlong(o, Widened(r.direction));
    const RayPosition truth = Classify(t, ray);
    if (truth != RayPosition::kHit && truth != RayPosition::kMiss) continue;
    ++tried;
    double largest = 0;
    for (std::size_t k = 0; k < 12; ++k) {
      largest = std::max(largest, std::abs(static_cast<double>(c[k])));
    }
    const double distance = AnswerDistanceInUlps(t, ray) *
                            std::ldexp(1.0, std::ilogb(largest) - 52);
    for (int way = 0; way < 27; ++way) {
      if (way == 13) continue;
      const Vector3 along = Unit({static_cast<double>(way % 3 - 1),
                                  static_cast<double>(way / 3 % 3 - 1),
                                  static_cast<double>(way / 9 - 1)});
      const Ray<double> moved =
          RayAlong(o + 0.999 * distance * along, ray.direction);
      // What rounds away is no more than some 2^-53.
      if (distance < 1e-12) continue;
      EXPECT_EQ(Classify(t, moved), truth);
    }
  }
}

TEST(RayDistanceTest, TheEstimateIsWithinATwentiethOfAnUlpAndAThousandth) {
  RayCandidateSource<float> source(4);
  for (int k = 0; k < 20000; ++k) {
    const RayCandidate<float> c = source.Draw();
    if (!Admissible(c)) continue;
    const double exact = AnswerDistanceInUlps(TriangleOf(c), RayOf(c));
    EXPECT_NEAR(AnswerDistanceEstimate(TriangleOf(c), RayOf(c)), exact,
                0.05 + 0.001 * exact);
  }
}

}  // namespace
}  // namespace pitbench
