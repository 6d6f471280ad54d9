// Mesh scenes: every query is asked of all triangles that could hold it.
#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "harness/truth/expected.h"
#include "harness/truth/orientation.h"
#include "tests/made_scene.h"

namespace pitbench {
namespace {

// What is asked about one query, by exact arithmetic.
struct Claims {
  std::size_t asked = 0;
  std::size_t closed = 0;    // triangles that hold it, their boundary included
  std::size_t top_left = 0;  // under the rule that gives every edge one owner
  std::size_t vertex = 0;    // of which it is a vertex
};

template <class T>
std::vector<Claims> ClaimsOf(const Scene<T>& scene) {
  std::vector<Claims> claims;
  std::size_t i = 0;
  ForEachAnswer(scene, [&](const Triangle<T>& t, const Point<T>& p) {
    const std::size_t query = scene.query.at(i++);
    if (query >= claims.size()) claims.resize(query + 1);
    Claims& own = claims[query];
    ++own.asked;
    const Position position = Classify(t, p);
    EXPECT_NE(position, Position::kDegenerate);
    if (position == Position::kInside || position == Position::kBoundary) {
      ++own.closed;
      if (position == Position::kInside ||
          BoundaryCounts(Boundary::kTopLeft, t, p)) {
        ++own.top_left;
      }
    }
    for (const Point<T>& v : {t.a, t.b, t.c}) {
      own.vertex += v.x == p.x && v.y == p.y ? 1u : 0u;
    }
  });
  EXPECT_EQ(i, scene.query.size());
  return claims;
}

template <class T>
class ScenesMeshTest : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(ScenesMeshTest, Scalars);

// A hole or a second owner in here would be the scene's and not a kernel's:
// also where the mesh is not asked in full.
TYPED_TEST(ScenesMeshTest, EveryQueryHasExactlyOneOwnerUnderTopLeft) {
  for (const std::string family :
       {"mesh_pair", "mesh_fan", "mesh_triangulation"}) {
    for (const int ulps : {0, 1, 16, 65536}) {
      for (const Loop loop : kLoops) {
        const std::string name = family + ":ulps=" + std::to_string(ulps);
        const Scene<TypeParam> scene = Make<TypeParam>(name, loop);
        std::size_t answers = 0;
        for (const Claims& claims : ClaimsOf(scene)) {
          EXPECT_GE(claims.closed, 1u) << name << " " << Name(loop);
          EXPECT_EQ(claims.top_left, 1u) << name << " " << Name(loop);
          answers += claims.asked;
        }
        const std::size_t wanted = kSize.groups * kSize.size;
        EXPECT_GE(answers, wanted * 8 / 10) << name << " " << Name(loop);
        EXPECT_LE(answers, wanted * 12 / 10) << name << " " << Name(loop);
      }
    }
  }
}

TYPED_TEST(ScenesMeshTest, SmallMeshesAskAllTheirTriangles) {
  for (const Loop loop : kLoops) {
    for (const Claims& c :
         ClaimsOf(Make<TypeParam>("mesh_pair:ulps=1", loop))) {
      EXPECT_EQ(c.asked, 2u);
    }
    for (const Claims& c : ClaimsOf(Make<TypeParam>("mesh_fan:ulps=1", loop))) {
      EXPECT_EQ(c.asked, 8u);
    }
  }
}

TYPED_TEST(ScenesMeshTest, PointsOnEdgesAndVerticesAreAmongTheQueries) {
  for (const std::string name : {"mesh_pair:ulps=0", "mesh_fan:ulps=0"}) {
    std::size_t on_edge = 0;
    const auto claims = ClaimsOf(Make<TypeParam>(name, Loop::kPairs));
    for (const Claims& c : claims) on_edge += c.closed == 2 ? 1u : 0u;
    EXPECT_GT(on_edge, claims.size() / 5) << name;
    EXPECT_LT(on_edge, claims.size() * 4 / 5) << name;
  }
  std::size_t in_fan = 0;
  for (const Claims& c :
       ClaimsOf(Make<TypeParam>("mesh_fan:ulps=0", Loop::kOnePoint))) {
    if (c.vertex == 8 && c.closed == 8) ++in_fan;
  }
  EXPECT_GT(in_fan, 10u);
  std::size_t on_vertex = 0;
  std::size_t between = 0;
  std::size_t alone = 0;
  const auto claims =
      ClaimsOf(Make<TypeParam>("mesh_triangulation:ulps=0", Loop::kOnePoint));
  for (const Claims& c : claims) {
    if (c.vertex != 0) {
      ++on_vertex;
      // All of the vertex's triangles, of which a grid has 4 to 8.
      EXPECT_EQ(c.closed, c.vertex);
      EXPECT_GE(c.closed, 4u);
      EXPECT_LE(c.closed, 8u);
    } else if (c.asked > 1) {
      ++between;
      EXPECT_GE(c.asked, 6u) << "the triangles around both ends";
    } else {
      ++alone;
    }
  }
  EXPECT_GT(on_vertex, claims.size() / 6);
  EXPECT_GT(between, claims.size() / 3);
  EXPECT_GT(alone, claims.size() / 6);
}

// Asked densely, the triangulation shows all of its triangles but those of the
// border.
TYPED_TEST(ScenesMeshTest, TriangulationHasTenThousandTriangles) {
  const Scene<TypeParam> scene =
      MakeScene<TypeParam>(ParseScene("mesh_triangulation:ulps=0"),
                           Loop::kOneTriangle, {1, 400000}, kDefaultSeed);
  using P = std::pair<TypeParam, TypeParam>;
  std::set<std::set<P>> different;
  std::size_t counter_clockwise = 0;
  for (std::size_t k = 0; k < scene.ax.size(); ++k) {
    const auto t = scene.TriangleAt(k);
    different.insert(
        std::set<P>{P{t.a.x, t.a.y}, P{t.b.x, t.b.y}, P{t.c.x, t.c.y}});
    const int winding = Orientation(t.a, t.b, t.c);
    EXPECT_NE(winding, 0);
    if (winding > 0) ++counter_clockwise;
  }
  EXPECT_EQ(different.size(), scene.ax.size()) << "one call a triangle";
  EXPECT_LE(different.size(), 10000u);
  EXPECT_GT(different.size(), 98u * 48 * 2);
  EXPECT_NEAR(static_cast<double>(counter_clockwise),
              static_cast<double>(different.size()) / 2, 5 * 50);  // 5 σ
  // Euler: no edge has more than two triangles, and those on the border one.
  std::map<std::set<P>, int> triangles_of;
  for (const std::set<P>& t : different) {
    for (const P& left_out : t) {
      std::set<P> edge = t;
      edge.erase(left_out);
      ++triangles_of[edge];
    }
  }
  for (const auto& [edge, triangles] : triangles_of) EXPECT_LE(triangles, 2);
}

}  // namespace
}  // namespace pitbench
