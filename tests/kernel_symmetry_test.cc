// What must not matter does not: the order of the vertices, the winding, the
// sign of zero. And a degenerate triangle contains nothing, not even its own
// vertices, as far as its area is 0 in the kernel's arithmetic.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "harness/scenes/random.h"
#include "harness/truth/expected.h"
#include "harness/truth/truth.h"
#include "kernels/kernels.h"
#include "tests/kernel_answers.h"

namespace pitbench {
namespace {

class KernelSymmetryTest : public testing::TestWithParam<const Kernel*> {
 protected:
  template <class T>
  void ExpectEmpty(const std::vector<Triangle<T>>& triangles) {
    std::vector<Point<T>> points;
    for (const Triangle<T>& t : triangles) {
      ASSERT_EQ(Classify(t, t.a), Position::kDegenerate) << t;
      for (const Point<T>& p :
           {t.a, t.b, t.c,
            Point<T>{t.a.x / 2 + t.b.x / 2, t.a.y / 2 + t.b.y / 2},
            Point<T>{t.a.x / 2 + t.c.x / 2, t.a.y / 2 + t.c.y / 2}}) {
        points.push_back(p);
      }
    }
    const AnswerTable<T> table = AskAll(*GetParam(), triangles, points);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      for (std::size_t p = 0; p < points.size(); ++p) {
        ASSERT_FALSE(table.Inside(t, p)) << points[p] << " in " << triangles[t];
      }
    }
  }
};

// Whole coordinates of 10 bits: products of differences are exact in f32. Not
// on the boundary where the method rounds there, or has a rule for it that
// names the edges.
TEST_P(KernelSymmetryTest, OrderOfTheVerticesDoesNotMatter) {
  const Kernel& kernel = *GetParam();
  const bool third = kernel.method.accepts == Accepts::kThirdNearVertexA;
  const bool boundary =
      kernel.method.boundary != Boundary::kHalfOpen && !DividesByArea(kernel);
  WithFloatOf(kernel, [&]<class T>(T) {
    Random random(3);
    const auto whole = [&](std::uint64_t n) {
      return static_cast<T>(random.Below(n));
    };
    std::vector<Point<T>> points;
    for (int k = 0; k < 67; ++k) {
      const T x = 16 * whole(64);
      points.push_back({x, 16 * whole(64)});
    }
    std::size_t inside = 0;
    std::size_t on_boundary = 0;
    for (int k = 0; k < 30; ++k) {
      // Every other triangle from the points, so that its vertices and points
      // of its edges are asked for.
      const auto vertex = [&]() -> Point<T> {
        if (k % 2 == 0) return points[random.Below(points.size())];
        const T x = whole(1024);
        return {x, whole(1024)};
      };
      const Point<T> a = vertex();
      const Point<T> b = vertex();
      const Point<T> c = vertex();
      // The third near A knows A from B and C.
      std::vector<Triangle<T>> orders = {{a, b, c}, {a, c, b}};
      if (!third) {
        orders.insert(orders.end(),
                      {{b, a, c}, {b, c, a}, {c, a, b}, {c, b, a}});
      }
      const AnswerTable<T> table = AskAll(kernel, orders, points);
      for (std::size_t p = 0; p < points.size(); ++p) {
        const Position position = Classify(orders[0], points[p]);
        if (position == Position::kBoundary && !boundary) continue;
        on_boundary += position == Position::kBoundary ? 1u : 0u;
        inside += table.Inside(0, p) ? 1u : 0u;
        for (std::size_t t = 1; t < orders.size(); ++t) {
          ASSERT_EQ(table.Inside(t, p), table.Inside(0, p))
              << points[p] << " in " << orders[t] << " and " << orders[0];
        }
      }
    }
    EXPECT_GT(inside, 50u);
    EXPECT_EQ(on_boundary > 10, boundary);
  });
}

// Collinear, doubled and single vertices; whole coordinates times a power of
// two up to where products overflow and down to where they underflow.
TEST_P(KernelSymmetryTest, DegenerateTriangleOfAnyScaleContainsNothing) {
  WithFloatOf(*GetParam(), [&]<class T>(T) {
    std::vector<Triangle<T>> degenerate = WholeTriangles<T>(2);
    std::erase_if(degenerate, [](const Triangle<T>& t) {
      return Classify(t, t.a) != Position::kDegenerate;
    });
    ASSERT_GT(degenerate.size(), 200u);
    using Limits = std::numeric_limits<T>;
    for (const int exponent :
         {0, 1 - Limits::digits + Limits::min_exponent, Limits::min_exponent,
          Limits::min_exponent / 2, Limits::min_exponent / 4, -10, 10,
          Limits::max_exponent / 4, Limits::max_exponent / 2,
          Limits::max_exponent - 2}) {
      std::vector<Triangle<T>> scaled;
      for (std::size_t k = static_cast<std::size_t>(std::abs(exponent)) % 13;
           k < degenerate.size(); k += 13) {
        Triangle<T> t = degenerate[k];
        for (Point<T>* p : {&t.a, &t.b, &t.c}) {
          *p = {std::ldexp(p->x, exponent), std::ldexp(p->y, exponent)};
        }
        scaled.push_back(t);
      }
      ExpectEmpty(scaled);
    }
  });
}

// No arithmetic but of the same numbers: rounding is no excuse.
TEST_P(KernelSymmetryTest, DoubledVertexOfAnyCoordinatesContainsNothing) {
  WithFloatOf(*GetParam(), [&]<class T>(T) {
    Random random(5);
    const auto draw = [&]() -> Point<T> {
      const auto x = static_cast<T>(random.In(-1, 1));
      return {x, static_cast<T>(random.In(-1, 1))};
    };
    std::vector<Triangle<T>> triangles;
    for (int k = 0; k < 15; ++k) {
      const Point<T> p = draw();
      const Point<T> q = draw();
      triangles.insert(triangles.end(),
                       {{p, p, q}, {p, q, p}, {q, p, p}, {p, p, p}});
    }
    ExpectEmpty(triangles);
  });
}

// Three points whose differences are exact, in the ratio of small integers.
TEST_P(KernelSymmetryTest, CollinearMultiplesContainNothing) {
  WithFloatOf(*GetParam(), [&]<class T>(T) {
    Random random(6);
    std::vector<Triangle<T>> triangles;
    const double last = std::ldexp(1.0, std::numeric_limits<T>::digits - 3);
    for (int k = 0; k < 25; ++k) {
      const auto x = static_cast<T>(std::floor(random.In(-last, last)));
      const auto y = static_cast<T>(std::floor(random.In(-last, last)));
      triangles.push_back({{x, y}, {3 * x, 3 * y}, {0, 0}});
      triangles.push_back({{-x, -y}, {2 * x, 2 * y}, {x, y}});
    }
    ExpectEmpty(triangles);
  });
}

// The edge from (−1, 0) to (1, 0) is −0 at (0, 0): a test of the sign bit
// would reject it, ≥ 0 does not.
TEST_P(KernelSymmetryTest, MinusZeroIsZero) {
  const Kernel& kernel = *GetParam();
  WithFloatOf(kernel, [&]<class T>(T) {
    for (const T zero : {T{0}, -T{0}}) {
      for (const T other : {T{0}, -T{0}}) {
        for (const Triangle<T>& t :
             {Triangle<T>{{-1, zero}, {1, other}, {zero, 1}},
              Triangle<T>{{-1, zero}, {1, other}, {zero, -1}},
              Triangle<T>{{zero, 1}, {-1, other}, {1, zero}}}) {
          for (const Point<T>& p :
               {Point<T>{zero, zero}, Point<T>{zero, other},
                Point<T>{other, zero}, Point<T>{-zero, -other}}) {
            EXPECT_EQ(Says(kernel, t, p), Expected(kernel.method, t, p))
                << p << " in " << t;
          }
        }
      }
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Every, KernelSymmetryTest,
                         testing::ValuesIn(FloatInsideKernels()), KernelName());

}  // namespace
}  // namespace pitbench
