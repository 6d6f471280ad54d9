// What every ray kernel must miss: numbers that are NaN or infinite, triangles
// without an area, rays without a direction or along the plane, and what lies
// outside of the range of t. The methods get there by arithmetic, each with its
// own reasoning (the method files), so all axes and combinations are tried.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "harness/scenes/random.h"
#include "tests/rays/ray_kernel_answers.h"

namespace pitbench {
namespace {

// Where programs run slowly, fewer are drawn.
constexpr int kShare = PITBENCH_SLOW ? 4 : 1;

// Points with whole coordinates from `least` to `most`, drawn.
class WholePoints {
 public:
  template <class T>
  Point3<T> Draw(int least, int most) {
    const auto draw = [&] {
      const auto range = static_cast<std::uint64_t>(most - least + 1);
      return static_cast<T>(least + static_cast<int>(random_.Below(range)));
    };
    const T x = draw();
    const T y = draw();
    return {x, y, draw()};
  }
  template <class T>
  Triangle3<T> DrawTriangle() {
    const auto a = Draw<T>(0, 2);
    const auto b = Draw<T>(0, 2);
    return {a, b, Draw<T>(0, 2)};
  }
  template <class T>
  Ray<T> DrawRay() {
    const auto origin = Draw<T>(-1, 3);
    return {origin, Draw<T>(-1, 1), -100, 100};
  }

 private:
  Random random_{11};
};

template <class T>
T& Coordinate(Point3<T>& p, std::size_t axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

struct Whole {
  std::int64_t x, y, z;
};
template <class T>
Whole Minus(const Point3<T>& p, const Point3<T>& q) {
  return {static_cast<std::int64_t>(p.x - q.x),
          static_cast<std::int64_t>(p.y - q.y),
          static_cast<std::int64_t>(p.z - q.z)};
}
Whole Cross(const Whole& p, const Whole& q) {
  return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}
std::int64_t Dot(const Whole& p, const Whole& q) {
  return p.x * q.x + p.y * q.y + p.z * q.z;
}

enum class Meets { kHit, kBoundary, kMiss, kParallel };

// Of whole numbers in whole numbers.
template <class T>
Meets MeetsExactly(const Triangle3<T>& t, const Ray<T>& ray, bool front_only) {
  const Whole e1 = Minus(t.b, t.a);
  const Whole e2 = Minus(t.c, t.a);
  const Whole s = Minus(ray.origin, t.a);
  const Whole d = Minus(ray.direction, {});
  const std::int64_t det = Dot(e1, Cross(d, e2));
  if (det == 0) return Meets::kParallel;
  if (front_only && det < 0) return Meets::kMiss;
  const std::int64_t sign = det > 0 ? 1 : -1;
  const std::int64_t u = sign * Dot(s, Cross(d, e2));
  const std::int64_t v = sign * Dot(d, Cross(s, e1));
  const std::int64_t w = sign * det - u - v;
  if (u < 0 || v < 0 || w < 0) return Meets::kMiss;
  return u > 0 && v > 0 && w > 0 ? Meets::kHit : Meets::kBoundary;
}

// Whether the method divides the normal by one of its coordinates, which rounds
// even where all are whole: it may then see a direction along the plane as one
// that is not.
bool DividesNormal(const RayKernel& kernel) {
  return kernel.method.key.starts_with("baldwin_weber");
}

class RayMissesTest : public testing::TestWithParam<const RayKernel*> {
 protected:
  template <class T>
  void ExpectNoHit(const RayScene<T>& scene) {
    ForEachAnswer(*GetParam(), scene,
                  [&](const auto& t, const auto& ray, const auto& answer) {
                    ASSERT_FALSE(answer.hit) << t << " " << ray;
                  });
  }
};

TEST_P(RayMissesTest, WholeNumbersAreRightButForTheBoundary) {
  WithFloatOf(*GetParam(), [&]<class T>(T) {
    WholePoints points;
    std::vector<Triangle3<T>> triangles;
    std::vector<Ray<T>> rays;
    for (int i = 0; i < 300 / kShare; ++i)
      triangles.push_back(points.DrawTriangle<T>());
    for (int i = 0; i < 120; ++i) rays.push_back(points.DrawRay<T>());
    std::array<std::size_t, 4> seen = {};
    // The nearest triangle tells of the others only that it is nearest.
    const bool all = GetParam()->output != RayOutput::kNearest;
    ForEachAnswer(
        *GetParam(), SceneOfAll(GetParam()->loop, triangles, rays),
        [&](const auto& t, const auto& ray, const auto& answer) {
          const Meets meets =
              MeetsExactly(t, ray, GetParam()->method.culls_backface);
          ++seen[static_cast<std::size_t>(meets)];
          if (meets == Meets::kMiss ||
              (meets == Meets::kParallel && !DividesNormal(*GetParam()))) {
            ASSERT_FALSE(answer.hit) << t << " " << ray;
          } else if (meets == Meets::kHit && all) {
            ASSERT_TRUE(answer.hit) << t << " " << ray;
          }
        });
    for (const std::size_t count : seen) EXPECT_GT(count, 50u / kShare);
  });
}

TEST_P(RayMissesTest, NanOrInfinityInARay) {
  WithFloatOf(*GetParam(), [&]<class T>(T) {
    WholePoints points;
    std::vector<Triangle3<T>> triangles;
    std::vector<Ray<T>> rays;
    for (int i = 0; i < 60 / kShare; ++i)
      triangles.push_back(points.DrawTriangle<T>());
    for (int i = 0; i < 10; ++i) {
      for (const T x : kNotFinite<T>) {
        for (std::size_t k = 0; k < 6; ++k) {
          Ray<T> ray = points.DrawRay<T>();
          Coordinate(k < 3 ? ray.origin : ray.direction, k % 3) = x;
          rays.push_back(ray);
          for (std::size_t j = 0; j < k; ++j) {
            Ray<T> worse = ray;
            Coordinate(j < 3 ? worse.origin : worse.direction, j % 3) =
                kNotFinite<T>[static_cast<std::size_t>(i) % 3];
            rays.push_back(worse);
          }
        }
      }
    }
    ExpectNoHit(SceneOfAll(GetParam()->loop, triangles, rays));
  });
}

TEST_P(RayMissesTest, NanOrInfinityInATriangle) {
  WithFloatOf(*GetParam(), [&]<class T>(T) {
    WholePoints points;
    std::vector<Triangle3<T>> triangles;
    std::vector<Ray<T>> rays;
    for (int i = 0; i < 40 / kShare; ++i) rays.push_back(points.DrawRay<T>());
    for (int i = 0; i < 6; ++i) {
      for (const T x : kNotFinite<T>) {
        for (std::size_t k = 0; k < 9; ++k) {
          Triangle3<T> t = points.DrawTriangle<T>();
          const auto vertex = [](Triangle3<T>& of,
                                 std::size_t which) -> Point3<T>& {
            return which == 0 ? of.a : which == 1 ? of.b : of.c;
          };
          Coordinate(vertex(t, k / 3), k % 3) = x;
          triangles.push_back(t);
          for (std::size_t j = 0; j < k; ++j) {
            Triangle3<T> worse = t;
            Coordinate(vertex(worse, j / 3), j % 3) =
                kNotFinite<T>[static_cast<std::size_t>(i) % 3];
            triangles.push_back(worse);
          }
        }
      }
    }
    ExpectNoHit(SceneOfAll(GetParam()->loop, triangles, rays));
  });
}

// The differences from A are exact; their products are not.
TEST_P(RayMissesTest, TrianglesWithoutAnArea) {
  WithFloatOf(*GetParam(), [&]<class T>(T) {
    Random random(5);
    const auto draw = [&] { return static_cast<T>(random.Unit()); };
    std::vector<Triangle3<T>> triangles;
    for (int i = 0; i < 60 / kShare; ++i) {
      const T x = draw();
      const T y = draw();
      const Point3<T> p{x, y, draw()};
      const Point3<T> zero{0, 0, 0};
      const Point3<T> half{p.x / 2, p.y / 2, p.z / 2};
      const Point3<T> minus{-p.x, -p.y, -p.z};
      triangles.push_back({zero, p, half});
      triangles.push_back({zero, half, p});
      triangles.push_back({zero, p, minus});
      triangles.push_back({zero, p, p});
      triangles.push_back({p, p, zero});
      triangles.push_back({p, zero, p});
      triangles.push_back({p, p, p});
    }
    std::vector<Ray<T>> rays;
    for (int i = 0; i < 30; ++i) {
      const T x = draw() - T{0.5};
      const T y = draw() - T{0.5};
      const Point3<T> d{x, y, draw() - T{0.5}};
      rays.push_back({{0, 0, 0}, d, -100, 100});
      rays.push_back({{-d.x, -d.y, -d.z}, d, -100, 100});
    }
    ExpectNoHit(SceneOfAll(GetParam()->loop, triangles, rays));
  });
}

TEST_P(RayMissesTest, DirectionsOfLengthZero) {
  WithFloatOf(*GetParam(), [&]<class T>(T) {
    WholePoints points;
    std::vector<Triangle3<T>> triangles;
    std::vector<Ray<T>> rays;
    for (int i = 0; i < 200 / kShare; ++i)
      triangles.push_back(points.DrawTriangle<T>());
    for (int i = 0; i < 100; ++i) {
      const T zero = i % 2 == 0 ? T{0} : T{-0.0};
      rays.push_back({points.Draw<T>(0, 2), {zero, 0, zero}, -100, 100});
    }
    ExpectNoHit(SceneOfAll(GetParam()->loop, triangles, rays));
  });
}

// Products overflow on the way to them: there is nothing to be known then, and
// nothing is claimed.
TEST_P(RayMissesTest, TrianglesTooLargeAreNotHitFromBeside) {
  WithFloatOf(*GetParam(), [&]<class T>(T) {
    for (const int part : {2, 3, 4, 6}) {
      T large = 1;
      for (int e = 0; e < std::numeric_limits<T>::max_exponent / part; ++e) {
        large *= 2;
      }
      WholePoints points;
      std::vector<Triangle3<T>> triangles;
      std::vector<Ray<T>> rays;
      const auto scaled = [&](Point3<T> p) {
        return Point3<T>{p.x * large, p.y * large, p.z * large};
      };
      for (int i = 0; i < 100 / kShare; ++i) {
        const auto [a, b, c] = points.DrawTriangle<T>();
        triangles.push_back({scaled(a), scaled(b), scaled(c)});
        const Ray<T> ray = points.DrawRay<T>();
        rays.push_back({scaled(ray.origin), scaled(ray.direction), -100, 100});
      }
      ForEachAnswer(
          *GetParam(), SceneOfAll(GetParam()->loop, triangles, rays),
          [&](const auto& t, const auto& ray, const auto& answer) {
            const T small = 1 / large;
            const auto down = [&](const Point3<T>& p) {
              return Point3<T>{p.x * small, p.y * small, p.z * small};
            };
            const Meets meets = MeetsExactly<T>(
                {down(t.a), down(t.b), down(t.c)},
                {down(ray.origin), down(ray.direction), ray.t_min, ray.t_max},
                GetParam()->method.culls_backface);
            if (meets == Meets::kMiss ||
                (meets == Meets::kParallel && !DividesNormal(*GetParam()))) {
              ASSERT_FALSE(answer.hit) << t << " " << ray;
            }
          });
    }
  });
}

TEST_P(RayMissesTest, RangesOfTCountTheirEndsAndNothingElse) {
  WithFloatOf(*GetParam(), [&]<class T>(T) {
    constexpr T kInfinity = std::numeric_limits<T>::infinity();
    constexpr T kNan = std::numeric_limits<T>::quiet_NaN();
    // Front-facing; met at t = 2, inside.
    const Triangle3<T> t{{0, 0, 2}, {0, 4, 2}, {4, 0, 2}};
    const auto hits = [&](T t_min, T t_max) {
      return Hits<T>(*GetParam(), t, {{1, 1, 0}, {0, 0, 1}, t_min, t_max});
    };
    EXPECT_TRUE(hits(0, 2));
    EXPECT_TRUE(hits(2, 2));
    EXPECT_TRUE(hits(2, 3));
    EXPECT_TRUE(hits(0, kInfinity));
    EXPECT_TRUE(hits(std::numeric_limits<T>::lowest(), kInfinity));
    EXPECT_FALSE(hits(0, T{1.9375}));
    EXPECT_FALSE(hits(T{2.0625}, kInfinity));
    EXPECT_FALSE(hits(3, 1));
    EXPECT_FALSE(hits(kNan, kInfinity));
    EXPECT_FALSE(hits(0, kNan));
    EXPECT_FALSE(hits(-kInfinity, kInfinity));
    EXPECT_FALSE(hits(kInfinity, kInfinity));
    EXPECT_FALSE(hits(0, -kInfinity));
    // From behind.
    EXPECT_NE(Hits<T>(*GetParam(), t, {{1, 1, 4}, {0, 0, -1}, 0, 3}),
              GetParam()->method.culls_backface);
  });
}

INSTANTIATE_TEST_SUITE_P(Every, RayMissesTest,
                         testing::ValuesIn(EveryRayKernel()), KernelName());

}  // namespace
}  // namespace pitbench
