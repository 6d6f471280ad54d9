// The worst known input of every method, from `pitbench hunt`: still answered
// as the table says, by every kernel of the method that runs here.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "harness/truth/weights.h"
#include "tests/kernel_answers.h"
#include "tests/worst_rows.h"

namespace pitbench {
namespace {

constexpr std::size_t kFirstCoordinate = 2;
constexpr std::size_t kSaid = 10;
constexpr std::size_t kTruth = 11;
constexpr std::size_t kDistance = 12;
constexpr std::size_t kFields = 13;

Rows ReadRows() {
  return ReadWorstRows(
      PITBENCH_TESTS_DIR "/worst_inputs.csv",
      "method,scalar,ax,ay,bx,by,cx,cy,px,py,said,truth,distance_ulps");
}

// Rows kept as a warning need none: what they get wrong is no secret.
bool NeedsARow(const Kernel& kernel) {
  return IsFloat(kernel.scalar) && kernel.method.warning.empty() &&
         !IsExact(kernel);
}

// A method without a row: run `pitbench hunt --method … --scalar … --seconds 5`
// and add the first line that it prints.
TEST(WorstInputsTest, EveryMethodHasOneRowAScalar) {
  ExpectOneRowAMethod(ReadRows(), AllKernels(), NeedsARow);
}

template <class T>
void CheckRow(const Row& row) {
  std::array<T, 8> x{};
  for (std::size_t k = 0; k < 8; ++k) {
    const double value = std::stod(row[kFirstCoordinate + k]);
    x[k] = static_cast<T>(value);
    EXPECT_EQ(static_cast<double>(x[k]), value);
    EXPECT_LE(std::abs(value), 1);
    EXPECT_TRUE(value == 0 || std::abs(value) >= 0x1p-30) << value;
  }
  EXPECT_GE(std::max(std::abs(x[6]), std::abs(x[7])), 0.5);
  const Triangle<T> triangle{{x[0], x[1]}, {x[2], x[3]}, {x[4], x[5]}};
  const Point<T> p{x[6], x[7]};
  const Position truth = ClassifyExactly(triangle, p);
  EXPECT_EQ(Name(truth), row[kTruth]);
  EXPECT_NE(truth, Position::kBoundary);
  const double distance = std::stod(row[kDistance]);
  EXPECT_NEAR(BoundaryDistanceInUlps(triangle, p), distance, 1e-12 * distance);
  ASSERT_TRUE(row[kSaid] == "inside" || row[kSaid] == "outside") << row[kSaid];
  const bool said_inside = row[kSaid] == "inside";
  EXPECT_NE(said_inside, truth == Position::kInside);
  for (const Kernel* kernel : FloatInsideKernels()) {
    if (kernel->method.key != row[0] || kernel->scalar != ScalarOf<T>()) {
      continue;
    }
    EXPECT_EQ(AskAll<T>(*kernel, {triangle}, {p}).Inside(0, 0), said_inside)
        << NameOf(*kernel);
  }
}

TEST(WorstInputsTest, EveryKernelStillGivesTheAnswer) {
  for (const auto& [key, row] : ReadRows()) {
    SCOPED_TRACE(key.first + " " + key.second);
    if (row[kSaid] == "none_found") {
      for (std::size_t k = kFirstCoordinate; k < kFields; ++k) {
        if (k != kSaid) {
          EXPECT_EQ(row[k], "");
        }
      }
    } else if (key.second == "f32") {
      CheckRow<float>(row);
    } else {
      CheckRow<double>(row);
    }
  }
}

// A reader of the method's file sees its worst f32 input there.
TEST(WorstInputsTest, TheMethodFilesQuoteTheirs) {
  std::string text;
  for (const auto& file : std::filesystem::directory_iterator(
           PITBENCH_TESTS_DIR "/../kernels/methods")) {
    std::ostringstream all;
    all << std::ifstream(file.path()).rdbuf();
    text += all.str();
  }
  for (const auto& [key, row] : ReadRows()) {
    if (key.second != "f32") continue;
    if (row[kSaid] == "none_found") {
      EXPECT_NE(text.find("//   " + key.first + ": none found"),
                std::string::npos)
          << key.first;
      continue;
    }
    const auto point = [&row](std::size_t k) {
      return "(" + row[kFirstCoordinate + k] + ", " +
             row[kFirstCoordinate + k + 1] + ")";
    };
    const std::string quoted = ":\n//     " + point(0) + " " + point(2) +
                               "\n//     " + point(4) + " " + point(6) + "\n";
    const std::size_t title =
        text.find("//   " + key.first + ", said " + row[kSaid]);
    ASSERT_NE(title, std::string::npos) << key.first;
    const std::size_t end = text.find(":\n", title);
    EXPECT_EQ(text.substr(end, quoted.size()), quoted) << key.first;
  }
}

}  // namespace
}  // namespace pitbench
