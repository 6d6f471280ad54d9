// Surfaces that rays are asked of: closed where they say so, and every query
// crosses once.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "harness/truth/ray_truth.h"
#include "tests/rays/made_ray_scene.h"

namespace pitbench {
namespace {

// What is asked about one query, by exact arithmetic.
struct Crossings {
  std::size_t asked = 0;
  std::size_t hit = 0;       // through the inside
  std::size_t boundary = 0;  // through an edge or a vertex
};

template <class T>
std::vector<Crossings> CrossingsOf(const RayScene<T>& scene) {
  std::vector<Crossings> crossings;
  std::size_t i = 0;
  ForEachRay(scene, [&](const Triangle3<T>& t, const Ray<T>& ray) {
    const std::size_t query = scene.query.at(i++);
    if (query >= crossings.size()) crossings.resize(query + 1);
    Crossings& own = crossings[query];
    ++own.asked;
    const RayPosition position = Classify(t, ray);
    EXPECT_NE(position, RayPosition::kDegenerate);
    EXPECT_NE(position, RayPosition::kCoplanar);
    EXPECT_TRUE(IsFrontFacing(t, ray));
    own.hit += position == RayPosition::kHit ? 1 : 0;
    own.boundary += position == RayPosition::kBoundary ? 1 : 0;
  });
  EXPECT_EQ(i, scene.query.size());
  return crossings;
}

template <class T>
class RayScenesMeshTest : public testing::Test {};
using Floats = testing::Types<float, double>;
TYPED_TEST_SUITE(RayScenesMeshTest, Floats);

// A leak or a second hit in here would be the scene's and not a kernel's: also
// where the surface is not asked in full.
TYPED_TEST(RayScenesMeshTest, EveryQueryCrossesOnce) {
  for (const std::string family : {"rays_icosphere", "rays_tiled_plane"}) {
    for (const int ulps : {0, 1, 16, 65536}) {
      for (const RayLoop loop : kRayLoops) {
        const std::string name = family + ":ulps=" + std::to_string(ulps);
        const auto scene = MakeRays<TypeParam>(name, loop);
        std::size_t answers = 0;
        for (const Crossings& c : CrossingsOf(scene)) {
          // Inside one triangle; or on an edge of two; or on a vertex of all.
          EXPECT_EQ(c.hit, c.boundary == 0 ? 1u : 0u) << name;
          EXPECT_NE(c.boundary, 1u) << name;
          answers += c.asked;
        }
        const std::size_t wanted = kRaySize.groups * kRaySize.size;
        EXPECT_GE(answers, wanted) << name;
        EXPECT_LE(answers, wanted + 20) << name;
      }
    }
  }
}

TYPED_TEST(RayScenesMeshTest, EdgesAndVerticesAreMetExactlyWhereNotMoved) {
  for (const std::string name :
       {"rays_icosphere:ulps=0", "rays_tiled_plane:ulps=0"}) {
    std::size_t edges = 0;
    std::size_t vertices = 0;
    std::size_t inside = 0;
    const auto crossings =
        CrossingsOf(MakeRays<TypeParam>(name, RayLoop::kRayPairs));
    for (const Crossings& c : crossings) {
      if (c.boundary == 2) ++edges;
      if (c.boundary > 3) ++vertices;
      if (c.hit == 1) ++inside;
    }
    EXPECT_GT(edges, crossings.size() / 6) << name;
    EXPECT_GT(vertices, crossings.size() / 16) << name;
    EXPECT_GT(inside, crossings.size() / 6) << name;
  }
}

template <class T>
using Vertex = std::array<T, 3>;

// Which triangles there are, as sets of three vertices.
template <class T>
std::set<std::set<Vertex<T>>> TrianglesOf(const std::string& name) {
  const RayScene<T> scene =
      MakeRayScene<T>(ParseScene(name), RayLoop::kOneTriangleRays,
                      {.groups = 1, .size = 200'000}, kDefaultSeed);
  std::set<std::set<Vertex<T>>> triangles;
  for (std::size_t k = 0; k < scene.Triangles(); ++k) {
    const auto& [a, b, c] = scene.TriangleAt(k);
    triangles.insert({Vertex<T>{a.x, a.y, a.z}, Vertex<T>{b.x, b.y, b.z},
                      Vertex<T>{c.x, c.y, c.z}});
  }
  EXPECT_EQ(triangles.size(), scene.Triangles()) << "one call a triangle";
  return triangles;
}

template <class T>
std::map<std::set<Vertex<T>>, int> TrianglesAtEdges(
    const std::set<std::set<Vertex<T>>>& triangles) {
  std::map<std::set<Vertex<T>>, int> at;
  for (const auto& t : triangles) {
    EXPECT_EQ(t.size(), 3u);
    for (const Vertex<T>& left_out : t) {
      auto edge = t;
      edge.erase(left_out);
      ++at[edge];
    }
  }
  return at;
}

// 1280 triangles, each edge of two: Euler's number of a sphere is 2.
TYPED_TEST(RayScenesMeshTest, IcosphereIsClosed) {
  const auto triangles = TrianglesOf<TypeParam>("rays_icosphere:ulps=0");
  EXPECT_EQ(triangles.size(), 1280u);
  const auto at = TrianglesAtEdges(triangles);
  EXPECT_EQ(at.size(), 1920u);
  for (const auto& [edge, count] : at) EXPECT_EQ(count, 2);
  std::set<Vertex<TypeParam>> vertices;
  for (const auto& t : triangles) vertices.insert(t.begin(), t.end());
  EXPECT_EQ(vertices.size(), 642u);
}

TYPED_TEST(RayScenesMeshTest, TiledPlaneIsWholeAndFlat) {
  const auto triangles = TrianglesOf<TypeParam>("rays_tiled_plane:ulps=0");
  // All but those next to the rim.
  EXPECT_LE(triangles.size(), 2u * 24 * 24);
  EXPECT_GE(triangles.size(), 2u * 20 * 20);
  for (const auto& [edge, count] : TrianglesAtEdges(triangles)) {
    EXPECT_LE(count, 2);
  }
  // A ray from a vertex of the first triangle to any other vertex lies in its
  // plane, as far as that direction is exact: differences of numbers on a grid.
  using T = TypeParam;
  const auto point = [](const Vertex<T>& v) -> Point3<T> {
    return {v[0], v[1], v[2]};
  };
  auto first = triangles.begin()->begin();
  const Point3<T> a = point(*first++);
  const Point3<T> b = point(*first++);
  const Point3<T> c = point(*first);
  for (const auto& t : triangles) {
    for (const Vertex<T>& v : t) {
      const Point3<T> along = {v[0] - a.x, v[1] - a.y, v[2] - a.z};
      if (along.x == 0 && along.y == 0 && along.z == 0) continue;
      EXPECT_EQ(Classify<T>({a, b, c}, {a, along, 0, 1}),
                RayPosition::kCoplanar);
    }
  }
}

// Each vertex comes first in a third of the triangles.
TYPED_TEST(RayScenesMeshTest, TrianglesBeginWithAnyVertex) {
  const auto one = MakeRayScene<TypeParam>(
      ParseScene("rays_icosphere:ulps=0"), RayLoop::kOneTriangleRays,
      {.groups = 1, .size = 200'000}, kDefaultSeed);
  std::size_t least = 0;
  for (std::size_t k = 0; k < one.Triangles(); ++k) {
    const auto t = one.TriangleAt(k);
    least += t.a.x <= t.b.x && t.a.x <= t.c.x ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(least), 1280.0 / 3, 5 * 16.9);  // 5 σ
}

}  // namespace
}  // namespace pitbench
