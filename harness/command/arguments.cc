#include "harness/command/arguments.h"

#include <nlohmann/json.hpp>

#include "harness/input/csv.h"
#include "harness/measure/machine.h"

namespace pitbench {

std::shared_ptr<Arguments> AddArguments(CLI::App& command) {
  auto a = std::make_shared<Arguments>();
  command.add_option("--profile", a->profile, "tiny, quick or full")
      ->capture_default_str();
  command.add_option("--filter", a->filter,
                     "only cells (loop/scene/method/scalar/isa) in which this "
                     "regular expression is found");
  command.add_option("--out", a->out, "the JSON file to write")->required();
  return a;
}

void AddSceneArguments(CLI::App& command, const std::shared_ptr<Arguments>& a) {
  command
      .add_option("--scene", a->scenes,
                  "this scene (again for more) instead of the profile's, e.g. "
                  "near_edge:ulps=3; see pitbench list")
      ->allow_extra_args(false);
  command.add_option("--triangles", a->triangles,
                     "your own scene: CSV with the header ax,ay,bx,by,cx,cy");
  command.add_option("--points", a->points,
                     "its points: CSV with the header px,py");
  command.add_option("--seed", a->seed, "of the generated scenes")
      ->capture_default_str();
}

Profile Asked(const Arguments& a) {
  if (a.triangles.empty() != a.points.empty()) {
    throw InputError("--triangles and --points go together: give both files");
  }
  if (!a.triangles.empty() && !a.scenes.empty()) {
    throw InputError("--scene and --triangles exclude each other: give one");
  }
  const Profile& profile = FindProfile(a.profile);
  return a.scenes.empty() ? profile : WithScenes(profile, a.scenes);
}

void NoCells(const Arguments& a) {
  throw InputError("no cell of profile '" + a.profile +
                   "' that runs here fits --filter '" + a.filter +
                   "'; a cell is named loop/scene/method/scalar/isa");
}

nlohmann::json Context(const char* schema, const Arguments& a) {
  return {{"schema", schema},
          {"profile",
           a.triangles.empty() && a.scenes.empty() ? a.profile : "custom"},
          {"filter", a.filter},
          {"revision", Revision()},
          {"dirty", Dirty()},
          {"seed", a.seed}};
}

}  // namespace pitbench
