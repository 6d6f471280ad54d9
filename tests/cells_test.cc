// Every cell of a profile is measured once: by one shard, under one name.
#include "harness/measure/cells.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <vector>

#include "harness/input/name_filter.h"
#include "harness/input/nearest.h"

namespace pitbench {
namespace {

template <class Scenes>
void AddCellNames(const Scenes& scenes, const NameFilter& wanted,
                  std::vector<std::string>& names) {
  for (const auto& scene : scenes) {
    for (const auto loop : scene.loops) {
      for (const auto* kernel : KernelsFor(scene, loop, wanted)) {
        names.push_back(CellName(*kernel, scene));
      }
    }
  }
}

// Those of points and those of rays.
std::vector<std::string> SpeedNames(const Profile& profile,
                                    const std::string& filter = "") {
  std::vector<std::string> names;
  AddCellNames(profile.speed, NameFilter(filter), names);
  AddCellNames(profile.ray_speed, NameFilter(filter), names);
  return names;
}
std::vector<std::string> AccuracyNames(const Profile& profile,
                                       const std::string& filter = "") {
  std::vector<std::string> names;
  AddCellNames(profile.accuracy, NameFilter(filter), names);
  AddCellNames(profile.ray_accuracy, NameFilter(filter), names);
  return names;
}

class ProfileTest : public testing::TestWithParam<const char*> {
 protected:
  const Profile& profile_ = FindProfile(GetParam());
};

TEST_P(ProfileTest, EveryCellHasANameOfItsOwn) {
  for (const auto& names : {SpeedNames(profile_), AccuracyNames(profile_)}) {
    EXPECT_GT(names.size(), 50u);
    EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(),
              names.size());
  }
}

TEST_P(ProfileTest, EveryCellBelongsToExactlyOneShard) {
  std::map<std::string, std::size_t> cells_of;  // by name of shard
  // One ISA: no filter looks at it.
  const std::string one = "/scalar(/threads)?$";
  for (const auto& [kind, names] :
       {std::pair{"speed", SpeedNames(profile_, one)},
        {"accuracy", AccuracyNames(profile_, one)}}) {
    std::vector<std::pair<std::string, NameFilter>> filters;
    for (const Shard& shard : Shards(profile_)) {
      if (shard.kind != kind) continue;
      filters.emplace_back(shard.name, NameFilter(shard.filter));
      cells_of.emplace(shard.name, 0);
    }
    for (const std::string& name : names) {
      std::size_t shards = 0;
      for (const auto& [shard, filter] : filters) {
        if (!filter.Finds(name)) continue;
        ++shards;
        ++cells_of[shard];
      }
      ASSERT_EQ(shards, 1u) << kind << " " << name;
    }
  }
  EXPECT_EQ(cells_of.size() + 5, Shards(profile_).size())
      << "names repeat, or there are other shards without cells than limits, "
         "twice, maps, operations and instructions";
  for (const auto& [shard, cells] : cells_of) EXPECT_GT(cells, 0u) << shard;
}

TEST_P(ProfileTest, MapsAreOneShard) {
  const std::vector<Shard> shards = Shards(profile_);
  EXPECT_EQ(shards.back().name, "maps");
  EXPECT_EQ(shards.back().kind, "maps");
  EXPECT_TRUE(NameFilter(shards.back().filter).Finds("any name"));
}

TEST_P(ProfileTest, LimitsAreMeasuredBeforeAllSpeedAndAfterIt) {
  std::vector<std::string> order;
  for (const Shard& shard : Shards(profile_)) {
    if (shard.kind == "limits") {
      order.push_back(shard.name);
      EXPECT_TRUE(NameFilter(shard.filter).Finds("load/L1/avx2"));
    } else if (shard.kind == "speed" &&
               (order.empty() || order.back() != "speed")) {
      order.emplace_back("speed");
    }
  }
  EXPECT_EQ(order,
            (std::vector<std::string>{"limits", "speed", "limits_after"}));
}

TEST_P(ProfileTest, EverySceneOfAccuracyCanBeMade) {
  for (const ProfileScene& scene : profile_.accuracy) {
    for (const Loop loop : scene.loops) {
      const SceneSpec spec = ParseScene(scene.name);
      const auto made = [&]<class T>(T) {
        return MakeScene<T>(spec, loop, {2, 3}, kDefaultSeed).calls.size();
      };
      EXPECT_GT(scene.scalar == Scalar::kF32   ? made(float{})
                : scene.scalar == Scalar::kF64 ? made(double{})
                : scene.scalar == Scalar::kI16 ? made(std::int16_t{})
                : scene.scalar == Scalar::kU8  ? made(std::uint8_t{})
                                               : made(std::int32_t{}),
                0u)
          << scene.name;
    }
  }
}

TEST_P(ProfileTest, EveryFamilyIsJudged) {
  std::set<std::string> families;
  for (const auto& scenes : {profile_.speed, profile_.accuracy}) {
    for (const ProfileScene& scene : scenes) {
      families.insert(ParseScene(scene.name).family);
    }
  }
  for (const auto& scenes : {profile_.ray_speed, profile_.ray_accuracy}) {
    for (const RayProfileScene& scene : scenes) {
      families.insert(ParseScene(scene.name).family);
    }
  }
  for (const FamilyInfo& family : Families()) {
    EXPECT_EQ(families.contains(std::string(family.name)), family.name != "own")
        << family.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Every, ProfileTest,
                         testing::Values("tiny", "quick", "full"));

// quick is what a newcomer runs: it has every kernel that runs here.
TEST(CellsTest, QuickTimesAndJudgesEveryKernel) {
  const Profile& quick = FindProfile("quick");
  for (const auto& scenes : {quick.speed, quick.accuracy}) {
    std::set<const Kernel*> met;
    for (const ProfileScene& scene : scenes) {
      for (const Loop loop : scene.loops) {
        for (const Kernel* kernel : KernelsFor(scene, loop, NameFilter(""))) {
          met.insert(kernel);
        }
      }
    }
    for (const Kernel& kernel : AllKernels()) {
      EXPECT_EQ(met.contains(&kernel), RunsHere(kernel.isa))
          << CellName(kernel, "*");
    }
  }
}

TEST(CellsTest, QuickTimesAndJudgesEveryKernelOfRays) {
  const Profile& quick = FindProfile("quick");
  for (const auto* scenes : {&quick.ray_speed, &quick.ray_accuracy}) {
    std::set<const RayKernel*> met;
    for (const RayProfileScene& scene : *scenes) {
      for (const RayLoop loop : scene.loops) {
        for (const RayKernel* kernel :
             KernelsFor(scene, loop, NameFilter(""))) {
          met.insert(kernel);
        }
      }
    }
    // t, u and v beside the bit take little time: quick judges them alone.
    const bool timed = scenes == &quick.ray_speed;
    for (const RayKernel& kernel : AllRayKernels()) {
      if (timed && kernel.output == RayOutput::kTuv) continue;
      EXPECT_EQ(met.contains(&kernel), RunsHere(kernel.isa))
          << CellName(kernel, "*");
    }
  }
}

TEST(CellsTest, MistypedProfileSuggestsTheNearest) {
  try {
    FindProfile("quik");
    ADD_FAILURE() << "no error";
  } catch (const SceneError& error) {
    EXPECT_STREQ(error.what(), "no profile 'quik': did you mean 'quick'?");
  }
}

TEST(NearestTest, IsTheSmallestLevenshteinDistance) {
  const std::vector<std::string_view> names = {"kitten", "edge_function",
                                               "cross_product"};
  EXPECT_EQ(Nearest("sitting", names), "kitten");
  EXPECT_EQ(Nearest("edge_funtcion", names), "edge_function");
  EXPECT_EQ(Nearest("", names), "kitten");
  EXPECT_EQ(NoSuch("method", "crossproduct", names),
            "no method 'crossproduct': did you mean 'cross_product'?");
}

TEST(NearestTest, InsertingAndDeletingCostAsMuchAsReplacing) {
  EXPECT_EQ(Nearest("ac", {"xy", "abc"}), "abc");
  EXPECT_EQ(Nearest("abc", {"xyc", "ac"}), "ac");
}

TEST(NearestTest, TheFirstOfEquallyNearNames) {
  EXPECT_EQ(Nearest("f48", {"f32", "f64", "f44"}), "f44");
  EXPECT_EQ(Nearest("x", {"a", "b"}), "a");
}

}  // namespace
}  // namespace pitbench
