// The worst known input of every ray method, from `pitbench hunt`: still
// answered as the table says, by every kernel of the method that runs here.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "harness/measure/rays/ray_candidates.h"
#include "harness/measure/rays/ray_hunt.h"
#include "harness/truth/ray_distance.h"
#include "tests/rays/ray_kernel_answers.h"
#include "tests/worst_rows.h"

namespace pitbench {
namespace {

constexpr std::size_t kFirstCoordinate = 2;
constexpr std::size_t kCoordinates = 15;
constexpr std::size_t kSaid = 17;
constexpr std::size_t kTruth = 18;
constexpr std::size_t kDistance = 19;

Rows ReadRows() {
  return ReadWorstRows(PITBENCH_TESTS_DIR "/worst_rays.csv",
                       "method,scalar,ax,ay,az,bx,by,bz,cx,cy,cz,ox,oy,oz,dx,"
                       "dy,dz,said,truth,distance_ulps");
}

template <class T>
RayCandidate<T> CoordinatesOf(const Row& row) {
  RayCandidate<T> c;
  for (std::size_t k = 0; k < kCoordinates; ++k) {
    const double value = std::stod(row[kFirstCoordinate + k]);
    c[k] = static_cast<T>(value);
    EXPECT_EQ(static_cast<double>(c[k]), value);
  }
  return c;
}

// check(row, T()) for every row that has an input.
template <class Check>
void ForEachInput(const Check& check) {
  for (const auto& [key, row] : ReadRows()) {
    SCOPED_TRACE(key.first + " " + key.second);
    if (row[kSaid] == "none_found") continue;
    if (key.second == "f32") {
      check(row, float{});
    } else {
      check(row, double{});
    }
  }
}

bool NeedsARow(const RayKernel& kernel) {
  return kernel.method.warning.empty() &&
         !kernel.method.key.starts_with("exact");
}

// A method without a row: run `pitbench hunt --method … --scalar … --seconds 5`
// and add the first line that it prints.
TEST(RayWorstInputsTest, EveryMethodHasOneRowAScalar) {
  ExpectOneRowAMethod(ReadRows(), AllRayKernels(), NeedsARow);
}

template <class T>
void CheckRow(const Row& row) {
  const RayCandidate<T> c = CoordinatesOf<T>(row);
  EXPECT_TRUE(Admissible(c));
  const Triangle3<T> triangle = TriangleOf(c);
  const Ray<T> ray = RayOf(c);
  const double distance = std::stod(row[kDistance]);
  EXPECT_NEAR(AnswerDistanceInUlps(triangle, ray), distance, 1e-12 * distance);
  ASSERT_TRUE(row[kSaid] == "hit" || row[kSaid] == "miss") << row[kSaid];
  const bool said_hit = row[kSaid] == "hit";
  EXPECT_NE(row[kTruth] == "hit", said_hit);
  EXPECT_NE(ClassifyExactly(triangle, ray), RayPosition::kBoundary);
  for (const RayKernel* kernel : EveryRayKernel()) {
    if (kernel->method.key != row[0] || kernel->scalar != ScalarOf<T>()) {
      continue;
    }
    EXPECT_EQ(Name(ClassifyFor(kernel->method, triangle, ray)), row[kTruth]);
    EXPECT_EQ(Hits(*kernel, triangle, ray), said_hit)
        << Name(kernel->isa) << " " << Name(kernel->loop, kernel->output);
  }
}

TEST(RayWorstInputsTest, EveryKernelStillGivesTheAnswer) {
  ForEachInput([]<class T>(const Row& row, T) { CheckRow<T>(row); });
}

// The inputs on which others are most wrong.
TEST(RayWorstInputsTest, TheExactKernelsAreRightAboutAllOfThem) {
  std::size_t asked = 0;
  ForEachInput([&asked]<class T>(const Row& row, T) {
    const RayCandidate<T> c = CoordinatesOf<T>(row);
    const bool is_hit =
        ClassifyExactly(TriangleOf(c), RayOf(c)) == RayPosition::kHit;
    for (const RayKernel* kernel : EveryRayKernel()) {
      if (NeedsARow(*kernel) || kernel->scalar != ScalarOf<T>()) continue;
      ++asked;
      EXPECT_EQ(Hits(*kernel, TriangleOf(c), RayOf(c)), is_hit)
          << Name(kernel->isa) << " " << Name(kernel->loop, kernel->output);
    }
  });
  EXPECT_GT(asked, 0u);
}

}  // namespace
}  // namespace pitbench
