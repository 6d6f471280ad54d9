// A coordinate that is NaN or infinite, of a point or of a triangle, makes the
// answer outside, in every kernel. The methods get there by arithmetic and not
// by a test, each with its own reasoning (method-inl.h and the method files),
// so all directions of edges and all combinations are tried.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "kernels/kernels.h"
#include "tests/kernel_answers.h"

namespace pitbench {
namespace {

// Triangles with whole vertices from 0 to 2: all combinations of the signs of
// the edges' coordinates, zeros included. And some large and small enough that
// differences or products overflow or underflow.
template <class T>
std::vector<Triangle<T>> FiniteTriangles() {
  std::vector<Triangle<T>> triangles = WholeTriangles<T>(2);
  const std::vector<Triangle<T>> whole = triangles;
  using Limits = std::numeric_limits<T>;
  for (const T scale :
       {Limits::denorm_min(), Limits::min(), std::sqrt(Limits::min()),
        std::sqrt(Limits::max()), Limits::max() / 2}) {
    for (std::size_t k = 0; k < whole.size(); k += 11) {
      const auto& [a, b, c] = whole[k];
      triangles.push_back({{(a.x - 1) * scale, (a.y - 1) * scale},
                           {(b.x - 1) * scale, (b.y - 1) * scale},
                           {(c.x - 1) * scale, (c.y - 1) * scale}});
    }
  }
  return triangles;
}

class KernelNonfiniteTest : public testing::TestWithParam<const Kernel*> {
 protected:
  template <class T>
  void ExpectAllOutside(const std::vector<Triangle<T>>& triangles,
                        const std::vector<Point<T>>& points) {
    const AnswerTable<T> table = AskAll(*GetParam(), triangles, points);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      for (std::size_t p = 0; p < points.size(); ++p) {
        ASSERT_FALSE(table.Inside(t, p)) << points[p] << " in " << triangles[t];
      }
    }
  }
};

TEST_P(KernelNonfiniteTest, PointWithNanOrInfinityIsOutside) {
  WithFloatOf(*GetParam(), [&]<class T>(T) {
    std::vector<Point<T>> points;
    for (const T x : kNotFinite<T>) {
      for (const T y : kNotFinite<T>) points.push_back({x, y});
      // Those of the vertices, what lies between and beside them, and −0.
      for (const double finite : {0.0, 1.0, 2.0, 0.5, -1.0, -0.0}) {
        points.push_back({x, static_cast<T>(finite)});
        points.push_back({static_cast<T>(finite), x});
      }
      // So large that products overflow, which looks infinite too.
      for (const T large :
           {std::numeric_limits<T>::max(), -std::numeric_limits<T>::max()}) {
        points.push_back({x, large});
        points.push_back({large, x});
      }
    }
    ExpectAllOutside(FiniteTriangles<T>(), points);
  });
}

// Among so many finite points that a loop answers many together: what tells
// whether all of them are decided must not pass over one that is not a number,
// whichever sign its NaN has.
TEST_P(KernelNonfiniteTest, OnePointAmongManyIsOutside) {
  WithFloatOf(*GetParam(), [&]<class T>(T) {
    constexpr std::size_t kMany = 2500;
    constexpr std::size_t kApart = 311;
    const std::vector<Triangle<T>> triangles = {
        {{0, 0}, {4, 1}, {1, 4}},   // two edges below, one above
        {{0, 1}, {3, 0}, {4, 4}},   // one below, two above
        {{1, 4}, {4, 1}, {0, 0}},   // clockwise
        {{0, 0}, {4, 0}, {0, 4}},   // with a vertical edge
        {{0, 0}, {4, 4}, {4, 5}}};  // on the right
    std::vector<T> values(std::begin(kNotFinite<T>), std::end(kNotFinite<T>));
    values.push_back(-std::numeric_limits<T>::quiet_NaN());
    std::vector<Point<T>> points(kMany, {1.5, 1.5});
    std::vector<std::size_t> places;
    for (const T value : values) {
      for (const Point<T> point : {Point<T>{value, 1.5}, Point<T>{1.5, value},
                                   Point<T>{value, value}}) {
        places.push_back(places.size() * kApart % kMany);
        points[places.back()] = point;
      }
    }
    const AnswerTable<T> table = AskAll(*GetParam(), triangles, points);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      for (const std::size_t p : places) {
        ASSERT_FALSE(table.Inside(t, p)) << points[p] << " in " << triangles[t];
      }
    }
  });
}

// One coordinate of every fifth triangle, and every pair of the coordinates of
// every third of the smallest ones.
TEST_P(KernelNonfiniteTest, TriangleWithNanOrInfinityContainsNothing) {
  WithFloatOf(*GetParam(), [&]<class T>(T) {
    const auto replaced = [](const Triangle<T>& t, int k, T value) {
      Triangle<T> changed = t;
      Point<T>& vertex = k < 2 ? changed.a : k < 4 ? changed.b : changed.c;
      (k % 2 == 0 ? vertex.x : vertex.y) = value;
      return changed;
    };
    std::vector<Triangle<T>> triangles;
    const std::vector<Triangle<T>> whole = WholeTriangles<T>(2);
    for (std::size_t i = 0; i < whole.size(); i += 5) {
      const Triangle<T>& t = whole[i];
      for (int k = 0; k < 6; ++k) {
        for (const T x : kNotFinite<T>) triangles.push_back(replaced(t, k, x));
      }
    }
    const std::vector<Triangle<T>> smallest = WholeTriangles<T>(1);
    for (std::size_t i = 0; i < smallest.size(); i += 3) {
      const Triangle<T>& t = smallest[i];
      for (int k = 0; k < 6; ++k) {
        for (int j = 0; j < k; ++j) {
          for (const T x : kNotFinite<T>) {
            for (const T y : kNotFinite<T>) {
              triangles.push_back(replaced(replaced(t, k, x), j, y));
            }
          }
        }
      }
    }
    ExpectAllOutside(triangles, WholePoints<T>(1));
    const T infinity = std::numeric_limits<T>::infinity();
    ExpectAllOutside<T>({{{infinity, infinity}, {1, 0}, {0, 1}},
                         {{-infinity, -infinity}, {infinity, 0}, {0, infinity}},
                         {{0, 0}, {infinity, 0}, {0, infinity}}},
                        {{infinity, infinity}, {infinity, 0}, {0.25, 0.25}});
  });
}

INSTANTIATE_TEST_SUITE_P(Every, KernelNonfiniteTest,
                         testing::ValuesIn(FloatInsideKernels()), KernelName());

}  // namespace
}  // namespace pitbench
