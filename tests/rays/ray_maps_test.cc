// The pictures of leaks: each ray crosses the sphere once, and the maps say
// what the methods say of it.
#include "harness/measure/rays/ray_maps.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "harness/input/name_filter.h"
#include "harness/measure/answers.h"
#include "harness/measure/map_entries.h"

namespace pitbench {
namespace {

using nlohmann::json;

constexpr std::size_t kRays = kRayMapSide * kRayMapSide;

template <class T>
class RayMapWindow : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(RayMapWindow, Scalars);

TYPED_TEST(RayMapWindow, EveryRayCrossesOneTriangleOrTheirCommonEdge) {
  const auto scene = RayMapScene<TypeParam>();
  ASSERT_EQ(scene.Triangles(), 6u);
  ASSERT_EQ(scene.Probes(), kRays);
  std::size_t on_edge = 0;
  for (std::size_t i = 0; i < kRays; ++i) {
    std::size_t hit = 0;
    std::size_t boundary = 0;
    for (std::size_t k = 0; k < 6; ++k) {
      const auto triangle = scene.TriangleAt(k);
      const RayPosition position = ClassifyExactly(triangle, scene.RayAt(i));
      hit += position == RayPosition::kHit ? 1 : 0;
      boundary += position == RayPosition::kBoundary ? 1 : 0;
      EXPECT_TRUE(IsFrontFacing(triangle, scene.RayAt(i)));
    }
    on_edge += boundary == 0 ? 0 : 1;
    ASSERT_TRUE((hit == 1 && boundary == 0) || (hit == 0 && boundary >= 2))
        << i << ": " << hit << " and " << boundary;
  }
  EXPECT_GE(on_edge, 1u);          // the ray to the vertex
  EXPECT_LE(on_edge, kRays / 10);  // the others are beside the edges
}

TYPED_TEST(RayMapWindow, DirectionsAreNeighbours) {
  const auto scene = RayMapScene<TypeParam>();
  const double step = std::numeric_limits<TypeParam>::epsilon() / 2;
  const auto differences = [&](std::size_t i, std::size_t j) {
    const auto from = scene.RayAt(i).direction;
    const auto to = scene.RayAt(j).direction;
    std::multiset<double> found;
    for (const auto& [x, y] :
         {std::pair{from.x, to.x}, {from.y, to.y}, {from.z, to.z}}) {
      // Exact: the two are within a factor of 2 or the step is a power of 2.
      found.insert((static_cast<double>(y) - static_cast<double>(x)) / step);
    }
    return found;
  };
  const std::multiset<double> one_step = {0, 0, 1};
  for (std::size_t i = 0; i + 1 < kRays; i += 37) {
    if (i % kRayMapSide + 1 == kRayMapSide) continue;
    EXPECT_EQ(differences(i, i + 1), one_step) << i;
  }
  for (std::size_t i = 0; i + kRayMapSide < kRays; i += 37) {
    EXPECT_EQ(differences(i, i + kRayMapSide), one_step) << i;
  }
}

json OnlyMap(const std::string& method) {
  const json file = MakeRayMaps(NameFilter("/ray_map/" + method + "/f32/"));
  EXPECT_EQ(file.at("ray_maps").size(), 1u);
  EXPECT_EQ(file.at("ray_windows").size(), 1u);
  EXPECT_EQ(file.at("ray_cases").size(), 0u);
  return file.at("ray_maps").at(0);
}

// Möller and Trumbore's test, written anew; not contracted.
bool Hits(const Triangle3<float>& t, const Ray<float>& ray) {
  using P = Point3<float>;
  const auto minus = [](P a, P b) {
    return P{a.x - b.x, a.y - b.y, a.z - b.z};
  };
  const auto cross = [](P a, P b) {
    return P{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z,
             a.x * b.y - a.y * b.x};
  };
  const auto dot = [](P a, P b) { return a.x * b.x + a.y * b.y + a.z * b.z; };
  const P e1 = minus(t.b, t.a);
  const P e2 = minus(t.c, t.a);
  const P p = cross(ray.direction, e2);
  const float inverse = 1 / dot(e1, p);
  const P s = minus(ray.origin, t.a);
  const float u = dot(s, p) * inverse;
  const float v = dot(ray.direction, cross(s, e1)) * inverse;
  return u >= 0 && v >= 0 && u + v <= 1;
}

TEST(RayMaps, MollerTrumboreLeaksWhereItsFormulaDoes) {
  const RayScene<float> scene = RayMapScene<float>();
  Bits claimed(BitBytes(kRays));
  Bits twice(BitBytes(kRays));
  std::size_t holes = 0;
  std::size_t double_hits = 0;
  for (std::size_t i = 0; i < kRays; ++i) {
    std::size_t claims = 0;
    for (std::size_t k = 0; k < scene.Triangles(); ++k) {
      claims += Hits(scene.TriangleAt(k), scene.RayAt(i)) ? 1 : 0;
    }
    if (claims >= 1) SetBit(claimed, i);
    if (claims >= 2) SetBit(twice, i);
    holes += claims == 0 ? 1 : 0;
    double_hits += claims >= 2 ? 1 : 0;
  }
  EXPECT_GT(holes, 0u);
  EXPECT_GT(double_hits, 0u);
  const json map = OnlyMap("moller_trumbore");
  EXPECT_EQ(map.at("counts").at("holes"), holes);
  EXPECT_EQ(map.at("counts").at("double_hits"), double_hits);
  EXPECT_EQ(map.at("claimed"), Base64(claimed));
  EXPECT_EQ(map.at("claimed_twice"), Base64(twice));
}

TEST(RayMaps, ExactMethodsClaimEachRayAsTheirRuleSays) {
  for (const char* scalar : {"f32", "f64"}) {
    const json file = MakeRayMaps(
        NameFilter("/ray_map/exact(_perturbed)?/" + std::string(scalar)));
    ASSERT_EQ(file.at("ray_maps").size(), 2u);
    for (const json& map : file.at("ray_maps")) {
      const json& counts = map.at("counts");
      EXPECT_EQ(counts.at("false_inside"), 0);
      EXPECT_EQ(counts.at("false_outside"), 0);
      EXPECT_EQ(counts.at("holes"), 0);
      // A closed triangle shares its edges, a perturbed one does not.
      if (map.at("method") == "exact") {
        EXPECT_EQ(map.at("claimed_twice"),
                  file.at("ray_windows").at(0).at("on_edge"));
      } else {
        EXPECT_EQ(counts.at("double_hits"), 0);
      }
    }
  }
}

TEST(RayMaps, TheContractedSquareIsMissedByContractionAlone) {
  const json file = MakeRayMaps(
      NameFilter("^ray_pairs/rays_corpus/(plane_project(_fma)?|exact)/f32/"));
  EXPECT_EQ(file.at("ray_maps").size(), 0u);
  std::size_t found = 0;
  for (const json& one : file.at("ray_cases")) {
    if (!one.at("id").get<std::string>().starts_with("oblikovati_2146")) {
      continue;
    }
    ++found;
    EXPECT_EQ(one.at("truth"), "boundary");
    ASSERT_EQ(one.at("answers").size(), 3u);
    for (const json& answer : one.at("answers")) {
      EXPECT_EQ(answer.at("hit"), answer.at("method") != "plane_project_fma")
          << one.at("id") << answer.at("method");
    }
  }
  EXPECT_EQ(found, 2u);
}

}  // namespace
}  // namespace pitbench
