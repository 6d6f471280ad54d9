// What a ray method says does not depend on what it was compiled for, nor on
// the loop that asks it, to the last bit of t, u and v; and where nothing is
// near a boundary it is right.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "harness/scenes/random.h"
#include "tests/placed_memory.h"
#include "tests/rays/ray_kernel_answers.h"

namespace pitbench {
namespace {

// Triangles about the origin.
template <class T>
std::vector<Triangle3<T>> DrawTriangles(Random& random, std::size_t n) {
  const auto draw = [&] {
    const auto x = static_cast<T>(random.Unit() - 0.5);
    const auto y = static_cast<T>(random.Unit() - 0.5);
    return Point3<T>{x, y, static_cast<T>(random.Unit() - 0.5)};
  };
  std::vector<Triangle3<T>> triangles;
  for (std::size_t i = 0; i < n; ++i) {
    const Point3<T> a = draw();
    const Point3<T> b = draw();
    triangles.push_back({a, b, draw()});
  }
  return triangles;
}

// (1 − u − v)·A + u·B + v·C
template <class T>
Point3<T> PointAt(const Triangle3<T>& t, double u, double v) {
  const auto along = [&](T a, T b, T c) {
    return static_cast<T>((1 - u - v) * a + u * b + v * c);
  };
  return {along(t.a.x, t.b.x, t.c.x), along(t.a.y, t.b.y, t.c.y),
          along(t.a.z, t.b.z, t.c.z)};
}

// From a point twice as far out to `target`.
template <class T>
Ray<T> RayTo(Random& random, const Point3<T>& target) {
  const auto origin = DrawTriangles<T>(random, 1)[0].a;
  const Point3<T> from{4 * origin.x, 4 * origin.y, 4 * origin.z};
  return {from,
          {target.x - from.x, target.y - from.y, target.z - from.z},
          0,
          std::numeric_limits<T>::infinity()};
}

// A ray to an edge of each triangle, or to a vertex, as far as it rounds to
// one: what is hardest to decide.
template <class T>
RayScene<T> HardPairs() {
  Random random(3);
  RayScene<T> scene{.name = "", .loop = RayLoop::kRayPairs};
  scene.t_min = 0;
  scene.t_max = std::numeric_limits<T>::infinity();
  for (const Triangle3<T>& t : DrawTriangles<T>(random, 401)) {
    const double at = random.Unit();
    const std::array<std::array<double, 2>, 4> ends = {
        {{at, 0}, {0, at}, {at, 1 - at}, {0, 0}}};
    const auto [u, v] = ends[random.Below(4)];
    const Ray<T> ray = RayTo(random, PointAt(t, u, v));
    scene.Add(t);
    scene.AddRay(ray.origin, ray.direction);
  }
  scene.calls.push_back({0, 0, scene.a.size()});
  return scene;
}

// The same as a scene for another loop: a call for each of the first few
// triangles or rays.
template <class T>
RayScene<T> ForLoop(RayScene<T> scene, RayLoop loop) {
  scene.loop = loop;
  if (loop != RayLoop::kRayPairs) {
    scene.calls.clear();
    for (std::size_t k = 0; k < 6; ++k) {
      const bool one_ray = loop == RayLoop::kOneRay;
      scene.calls.push_back({one_ray ? 0 : k, one_ray ? k : 0, scene.a.size()});
    }
  }
  return scene;
}

template <class T>
::testing::AssertionResult SameAnswers(
    const std::vector<std::vector<RayAnswer<T>>>& x,
    const std::vector<std::vector<RayAnswer<T>>>& y) {
  for (std::size_t c = 0; c < x.size(); ++c) {
    for (std::size_t i = 0; i < x[c].size(); ++i) {
      bool same = x[c][i].hit == y[c][i].hit;
      for (std::size_t k = 0; k < 3; ++k) {
        same = same && Same(x[c][i].tuv[k], y[c][i].tuv[k]);
      }
      if (!same) {
        return testing::AssertionFailure() << "call " << c << ", answer " << i;
      }
    }
  }
  return testing::AssertionSuccess();
}

using Group = std::vector<const RayKernel*>;

// The kernels of one method, scalar, loop and output, ISA by ISA.
std::vector<Group> Groups() {
  std::map<std::tuple<std::string_view, Scalar, RayLoop, RayOutput>, Group>
      groups;
  for (const RayKernel* kernel : EveryRayKernel()) {
    groups[{kernel->method.key, kernel->scalar, kernel->loop, kernel->output}]
        .push_back(kernel);
  }
  std::vector<Group> found;
  for (const auto& [key, kernels] : groups) found.push_back(kernels);
  return found;
}

std::string GroupName(const testing::TestParamInfo<Group>& group) {
  const RayKernel& kernel = *group.param[0];
  return std::string(kernel.method.key)
      .append("_")
      .append(Name(kernel.scalar))
      .append("_")
      .append(Name(kernel.loop, kernel.output));
}

class RayIsaAgreementTest : public testing::TestWithParam<Group> {};

TEST_P(RayIsaAgreementTest, EveryIsaGivesTheSameBits) {
  WithFloatOf(*GetParam()[0], [&]<class T>(T) {
    const RayScene<T> scene = ForLoop(HardPairs<T>(), GetParam()[0]->loop);
    const auto first = AskRays(*GetParam()[0], scene);
    for (const RayKernel* kernel : GetParam()) {
      EXPECT_TRUE(SameAnswers(first, AskRays(*kernel, scene)))
          << NameOf(*kernel);
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Every, RayIsaAgreementTest,
                         testing::ValuesIn(Groups()), GroupName);

// What is asked of every kernel: the one that tells t, u and v of pairs, of the
// same method, scalar and ISA.
const RayKernel& PairsOf(const RayKernel& kernel) {
  return *RayKernelsWhere([&](const RayKernel& other) {
            return other.method.key == kernel.method.key &&
                   other.scalar == kernel.scalar && other.isa == kernel.isa &&
                   other.loop == RayLoop::kRayPairs &&
                   other.output == RayOutput::kTuv;
          }).at(0);
}

class RayAgreementTest : public testing::TestWithParam<const RayKernel*> {};

TEST_P(RayAgreementTest, EveryLoopSaysWhatPairsSay) {
  WithFloatOf(*GetParam(), [&]<class T>(T) {
    const RayScene<T> scene = ForLoop(HardPairs<T>(), GetParam()->loop);
    const auto answers = AskRays(*GetParam(), scene);
    std::size_t hits = 0;
    for (std::size_t c = 0; c < scene.calls.size(); ++c) {
      const RayCall& call = scene.calls[c];
      RayScene<T> pairs{.name = "", .loop = RayLoop::kRayPairs};
      pairs.t_min = scene.t_min;
      pairs.t_max = scene.t_max;
      for (std::size_t i = 0; i < call.n; ++i) {
        const Ray<T> ray = scene.RayOf(call, i);
        pairs.Add(scene.TriangleOf(call, i));
        pairs.AddRay(ray.origin, ray.direction);
      }
      pairs.calls.push_back({0, 0, call.n});
      auto expected = AskRays(PairsOf(*GetParam()), pairs)[0];
      if (GetParam()->output == RayOutput::kNearest) {
        // Of several that are as near, the first.
        const RayAnswer<T>* nearest = nullptr;
        for (const RayAnswer<T>& answer : expected) {
          if (answer.hit &&
              (nearest == nullptr || answer.tuv[0] < nearest->tuv[0])) {
            nearest = &answer;
          }
        }
        const auto at = static_cast<std::size_t>(nearest - expected.data());
        std::vector<RayAnswer<T>> only(call.n);
        if (nearest != nullptr) only[at] = {true, {nearest->tuv[0]}};
        expected = only;
      } else if (GetParam()->output == RayOutput::kHits) {
        for (RayAnswer<T>& answer : expected) answer.tuv = {};
      }
      for (const RayAnswer<T>& answer : expected) hits += answer.hit ? 1 : 0;
      ASSERT_TRUE(SameAnswers<T>({answers[c]}, {expected})) << c;
    }
    EXPECT_GT(hits, 2u);
  });
}

TEST_P(RayAgreementTest, TheFirstOfSeveralAsNearIsTheNearest) {
  if (GetParam()->output != RayOutput::kNearest) return;
  WithFloatOf(*GetParam(), [&]<class T>(T) {
    const Triangle3<T> far{{0, 0, 3}, {0, 4, 3}, {4, 0, 3}};
    const Triangle3<T> near{{0, 0, 2}, {0, 4, 2}, {4, 0, 2}};
    const Triangle3<T> beside{{9, 0, 1}, {9, 4, 1}, {13, 0, 1}};
    const Ray<T> ray{{1, 1, 0}, {0, 0, 1}, 0, 100};
    for (std::size_t n = 1; n < 36; ++n) {
      for (std::size_t first = 0; first < n; ++first) {
        std::vector<Triangle3<T>> triangles(n, first % 2 == 0 ? far : beside);
        for (std::size_t k = first; k < n; k += 1 + first % 3) {
          triangles[k] = near;
        }
        const auto answers = AskRays(
            *GetParam(), SceneOfAll<T>(GetParam()->loop, triangles, {ray}))[0];
        ASSERT_TRUE(answers[first].hit) << first << " of " << n;
        ASSERT_EQ(answers[first].tuv[0], 2);
      }
    }
  });
}

struct Reference {
  long double t, u, v, det;  // det over the lengths of what it is made of
};
template <class T>
Reference Compute(const Triangle3<T>& t, const Ray<T>& ray) {
  using V = std::array<long double, 3>;
  const auto minus = [](const Point3<T>& p, const Point3<T>& q) {
    return V{static_cast<long double>(p.x) - q.x,
             static_cast<long double>(p.y) - q.y,
             static_cast<long double>(p.z) - q.z};
  };
  const auto cross = [](const V& p, const V& q) {
    return V{p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2],
             p[0] * q[1] - p[1] * q[0]};
  };
  const auto dot = [](const V& p, const V& q) {
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
  };
  const V e1 = minus(t.b, t.a);
  const V e2 = minus(t.c, t.a);
  const V s = minus(ray.origin, t.a);
  const V d = minus(ray.direction, {});
  const long double det = dot(e1, cross(d, e2));
  return {dot(e2, cross(s, e1)) / det, dot(s, cross(d, e2)) / det,
          dot(d, cross(s, e1)) / det,
          det / std::sqrt(dot(e1, e1) * dot(e2, e2) * dot(d, d))};
}

TEST_P(RayAgreementTest, RaysThatAreEasyToDecideAreDecidedRight) {
  WithFloatOf(*GetParam(), [&]<class T>(T) {
    Random random(9);
    std::vector<Triangle3<T>> triangles = DrawTriangles<T>(random, 40);
    std::vector<Ray<T>> rays;
    for (std::size_t i = 0; i < 120; ++i) {
      const double u = random.Unit();
      rays.push_back(
          RayTo(random, PointAt(triangles[i % 40], u / 2, random.Unit() / 2)));
    }
    const T tolerance = sizeof(T) == 4 ? T{2e-4f} : static_cast<T>(1e-12);
    std::size_t hits = 0;
    std::size_t misses = 0;
    ForEachAnswer(
        *GetParam(), SceneOfAll(GetParam()->loop, triangles, rays),
        [&](const auto& t, const auto& ray, const auto& answer) {
          const Reference is = Compute(t, ray);
          const long double inside =
              std::min({is.u, is.v, 1 - is.u - is.v, is.t});
          if (std::abs(is.det) < 0.1L || std::abs(inside) < 1e-3L) return;
          const bool hit =
              inside > 0 && (is.det > 0 || !GetParam()->method.culls_backface);
          if (!hit) {
            ASSERT_FALSE(answer.hit) << t << " " << ray;
            ++misses;
          } else if (answer.hit || GetParam()->output != RayOutput::kNearest) {
            ASSERT_TRUE(answer.hit) << t << " " << ray;
            ++hits;
          }
          if (!answer.hit || GetParam()->output == RayOutput::kHits) return;
          EXPECT_NEAR(answer.tuv[0], static_cast<T>(is.t), tolerance);
          if (GetParam()->output == RayOutput::kNearest) return;
          EXPECT_NEAR(answer.tuv[1], static_cast<T>(is.u), tolerance);
          EXPECT_NEAR(answer.tuv[2], static_cast<T>(is.v), tolerance);
        });
    EXPECT_GT(hits, 10u);
    EXPECT_GT(misses, 500u);
  });
}

INSTANTIATE_TEST_SUITE_P(Every, RayAgreementTest,
                         testing::ValuesIn(EveryRayKernel()), KernelName());

}  // namespace
}  // namespace pitbench
