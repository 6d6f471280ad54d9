// The exact ray kernels of every ISA: that they are right wherever it is hard,
// and that of a closed surface a ray hits one triangle where it crosses it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <vector>

#include "kernels/rays/exact/ray_contains.h"
#include "tests/rays/hard_rays.h"
#include "tests/rays/ray_kernel_answers.h"

namespace pitbench {
namespace {

#if PITBENCH_SLOW
constexpr std::size_t kItems = 3'000;
constexpr std::size_t kRaysOfSurface = 3'000;
#else
constexpr std::size_t kItems = 30'000;
constexpr std::size_t kRaysOfSurface = 50'000;
#endif

bool IsExact(const RayKernel& kernel) {
  return kernel.method.key.starts_with("exact");
}

template <class T>
bool ExactlyHits(Boundary boundary, const Triangle3<T>& t, const Ray<T>& ray) {
  const RayAndTriangle both{
      {t.a.x, t.a.y, t.a.z},
      {t.b.x, t.b.y, t.b.z},
      {t.c.x, t.c.y, t.c.z},
      {ray.origin.x, ray.origin.y, ray.origin.z},
      {ray.direction.x, ray.direction.y, ray.direction.z}};
  return RayExactlyHits(boundary, both, ray.t_min, ray.t_max);
}

class ExactRayKernelsTest : public testing::TestWithParam<const RayKernel*> {
 protected:
  // Calls test(triangle, ray, answer) for hard items, a few that share what the
  // loop does not batch; rays of a scene have one range of t.
  template <class T, class Test>
  static void ForHardItems(const Test& test) {
    HardRays<T> draw(5);
    const bool pairs = GetParam()->loop == RayLoop::kRayPairs;
    const std::size_t others = 40;
    for (std::size_t i = 0; i < kItems; i += others) {
      const auto first = draw.Draw();
      RayScene<T> scene{.name = "", .loop = GetParam()->loop};
      scene.t_min = first.ray.t_min;
      scene.t_max = first.ray.t_max;
      scene.Add(first.triangle);
      scene.AddRay(first.ray.origin, first.ray.direction);
      for (std::size_t k = 1; k < others; ++k) {
        const auto item = pairs ? draw.Draw()
                          : GetParam()->loop == RayLoop::kOneRay
                              ? draw.DrawTriangleFor(first.ray)
                              : draw.DrawRayFor(first.triangle);
        scene.Add(item.triangle);
        scene.AddRay(item.ray.origin, item.ray.direction);
      }
      scene.calls.push_back({0, 0, others});
      const auto answers = AskRays(*GetParam(), scene);
      for (std::size_t k = 0; k < others; ++k) {
        test(scene, k, answers[0]);
      }
    }
  }
};

TEST_P(ExactRayKernelsTest, HitsAreExact) {
  if (GetParam()->output == RayOutput::kNearest) return;
  WithFloatOf(*GetParam(), [&]<class T>(T) {
    std::size_t hits = 0;
    ForHardItems<T>([&](const RayScene<T>& scene, std::size_t k,
                        const std::vector<RayAnswer<T>>& answers) {
      const auto triangle = scene.TriangleOf(scene.calls[0], k);
      const auto ray = scene.RayOf(scene.calls[0], k);
      const bool hit = ExactlyHits(GetParam()->method.boundary, triangle, ray);
      ASSERT_EQ(answers[k].hit, hit) << triangle << " " << ray;
      hits += hit ? 1 : 0;
    });
    EXPECT_GT(hits, kItems / 20);
    EXPECT_LT(hits, kItems * 19 / 20);
  });
}

// Within 2^-32 of t, or of 1 for u and v, and what rounding to T adds.
template <class T>
bool IsNear(T is, const mpq_class& exact, const mpq_class& size) {
  constexpr T kInfinity = std::numeric_limits<T>::infinity();
  const mpq_class large(static_cast<double>(std::numeric_limits<T>::max()));
  if (std::isinf(is)) return (is > 0 ? exact : mpq_class(-exact)) >= large;
  const mpq_class rounded(static_cast<double>(is));
  const T next = std::nextafter(std::abs(is), kInfinity);
  const mpq_class ulp =
      std::isinf(next)
          ? mpq_class(large - mpq_class(static_cast<double>(std::nextafter(
                                  std::numeric_limits<T>::max(), T{0}))))
          : mpq_class(mpq_class(static_cast<double>(next)) - abs(rounded));
  return abs(mpq_class(rounded - exact)) <= size * mpq_class(0x1p-32) + ulp / 2;
}

TEST_P(ExactRayKernelsTest, TuvAreWithinTheirBound) {
  if (GetParam()->output != RayOutput::kTuv) return;
  WithFloatOf(*GetParam(), [&]<class T>(T) {
    ForHardItems<T>([&](const RayScene<T>& scene, std::size_t k,
                        const std::vector<RayAnswer<T>>& answers) {
      const auto triangle = scene.TriangleOf(scene.calls[0], k);
      const auto ray = scene.RayOf(scene.calls[0], k);
      if (!answers[k].hit) return;
      const RationalCrossing at = CrossingOf(triangle, ray);
      const auto [t, u, v] = answers[k].tuv;
      ASSERT_TRUE(IsNear(t, at.t, abs(at.t))) << triangle << " " << ray;
      ASSERT_TRUE(IsNear(u, at.u, 1)) << triangle << " " << ray;
      ASSERT_TRUE(IsNear(v, at.v, 1)) << triangle << " " << ray;
    });
  });
}

TEST_P(ExactRayKernelsTest, NearestIsOfTheLeastExactT) {
  if (GetParam()->output != RayOutput::kNearest) return;
  WithFloatOf(*GetParam(), [&]<class T>(T) {
    std::size_t found = 0;
    ForHardItems<T>([&](const RayScene<T>& scene, std::size_t k,
                        const std::vector<RayAnswer<T>>& answers) {
      if (k != 0) return;
      const auto ray = scene.RayOf(scene.calls[0], 0);
      std::size_t nearest = kNoTriangle;
      mpq_class least;
      for (std::size_t i = 0; i < answers.size(); ++i) {
        const auto triangle = scene.TriangleOf(scene.calls[0], i);
        if (!ExactlyHits(GetParam()->method.boundary, triangle, ray)) continue;
        const mpq_class t = CrossingOf(triangle, ray).t;
        if (nearest == kNoTriangle || t < least) {
          nearest = i;
          least = t;
        }
      }
      for (std::size_t i = 0; i < answers.size(); ++i) {
        ASSERT_EQ(answers[i].hit, i == nearest) << ray;
      }
      if (nearest == kNoTriangle) return;
      ++found;
      ASSERT_TRUE(IsNear(answers[nearest].tuv[0], least, abs(least))) << ray;
    });
    EXPECT_GT(found, kItems / 40 / 4);
  });
}

// Vertices of an octahedron and of an icosahedron, rounded, and their faces.
template <class T>
std::vector<Triangle3<T>> Faces(const std::vector<Point3<T>>& vertices,
                                double edge) {
  const auto distance = [](const Point3<T>& p, const Point3<T>& q) {
    return std::hypot(p.x - q.x, p.y - q.y, p.z - q.z);
  };
  const auto are_joined = [&](const Point3<T>& p, const Point3<T>& q) {
    return std::abs(distance(p, q) - edge) < 0.01;
  };
  std::vector<Triangle3<T>> faces;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    for (std::size_t j = i + 1; j < vertices.size(); ++j) {
      for (std::size_t k = j + 1; k < vertices.size(); ++k) {
        if (are_joined(vertices[i], vertices[j]) &&
            are_joined(vertices[j], vertices[k]) &&
            are_joined(vertices[k], vertices[i])) {
          faces.push_back({vertices[i], vertices[j], vertices[k]});
        }
      }
    }
  }
  return faces;
}
template <class T>
std::vector<Triangle3<T>> Octahedron() {
  return Faces<T>(
      {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
      std::sqrt(2.0));
}
template <class T>
std::vector<Triangle3<T>> Icosahedron() {
  const T phi = static_cast<T>((1 + std::sqrt(5.0)) / 2);
  std::vector<Point3<T>> vertices;
  for (const T s : {T{1}, T{-1}}) {
    for (const T p : {phi, -phi}) {
      vertices.push_back({0, s, p});
      vertices.push_back({s, p, 0});
      vertices.push_back({p, 0, s});
    }
  }
  return Faces(vertices, 2);
}

// Rays from inside a surface around the origin to its vertices, to points of
// its edges, and anywhere; those from the centre, and to a vertex of a surface
// whose coordinates are whole, meet what they are aimed at exactly.
template <class T>
std::vector<Ray<T>> RaysFromInside(const std::vector<Triangle3<T>>& faces,
                                   std::size_t n) {
  Random random(6);
  std::vector<Ray<T>> rays;
  const auto draw = [&] { return static_cast<T>(random.In(-0.25, 0.25)); };
  for (std::size_t i = 0; i < n; ++i) {
    const Triangle3<T>& face = faces[random.Below(faces.size())];
    Point3<T> origin{0, 0, 0};
    if (random.Below(2) == 0) {
      const T x = draw();
      const T y = draw();
      origin = {x, y, draw()};
    } else if (random.Below(2) == 0) {
      const auto whole = [&] {
        return static_cast<T>(static_cast<int>(random.Below(3)) - 1) / 4;
      };
      const T x = whole();
      const T y = whole();
      origin = {x, y, whole()};
    }
    const T along = static_cast<T>(
        random.Below(2) == 0 ? random.Unit()
                             : 0.25 * static_cast<double>(random.Below(5)));
    Point3<T> target = face.a;
    switch (random.Below(3)) {
      case 0:
        break;
      case 1:
        target = {face.a.x + along * (face.b.x - face.a.x),
                  face.a.y + along * (face.b.y - face.a.y),
                  face.a.z + along * (face.b.z - face.a.z)};
        break;
      default:
        target = {draw(), draw(), draw()};
        target.x += target.x == origin.x ? 1 : 0;
    }
    rays.push_back(
        {origin,
         {target.x - origin.x, target.y - origin.y, target.z - origin.z},
         0,
         std::numeric_limits<T>::infinity()});
  }
  return rays;
}

TEST_P(ExactRayKernelsTest, ARayLeavesAClosedSurfaceOnce) {
  if (GetParam()->output == RayOutput::kNearest) return;
  WithFloatOf(*GetParam(), [&]<class T>(T) {
    for (const auto& faces : {Octahedron<T>(), Icosahedron<T>()}) {
      ASSERT_EQ(faces.size() % 12, 8u);  // 8 or 20
      // Pairs hold every face once a ray.
      const bool pairs = GetParam()->loop == RayLoop::kRayPairs;
      const std::vector<Ray<T>> rays =
          RaysFromInside(faces, kRaysOfSurface / (pairs ? 20 : 1));
      const auto answers =
          AskRays(*GetParam(), SceneOfAll<T>(GetParam()->loop, faces, rays));
      std::size_t several = 0;
      for (std::size_t r = 0; r < rays.size(); ++r) {
        std::size_t hits = 0;
        for (std::size_t f = 0; f < faces.size(); ++f) {
          const auto& answer =
              pairs ? answers[0][f * rays.size() + r] : answers[f][r];
          hits += answer.hit ? 1 : 0;
        }
        ASSERT_GE(hits, 1u) << rays[r];
        several += hits > 1 ? 1 : 0;
      }
      if (GetParam()->method.boundary == Boundary::kPerturbed) {
        EXPECT_EQ(several, 0u);
      } else {
        EXPECT_GT(several, rays.size() / 10);
      }
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Every, ExactRayKernelsTest,
                         testing::ValuesIn(RayKernelsWhere(IsExact)),
                         KernelName());

}  // namespace
}  // namespace pitbench
