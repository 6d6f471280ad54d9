#include "harness/measure/accuracy.h"

#include <iostream>
#include <nlohmann/json.hpp>

#include "harness/command/arguments.h"
#include "harness/command/commands.h"
#include "harness/command/output.h"
#include "harness/command/own_scenes.h"
#include "harness/input/name_filter.h"
#include "harness/measure/rays/ray_accuracy.h"

namespace pitbench {
namespace {

using nlohmann::json;

void Accuracy(const Arguments& a) {
  const Profile profile = Asked(a);
  const NameFilter filter(a.filter);
  OutputFile out(a.out);
  json cells = json::array();
  json ray_cells = json::array();
  if (a.triangles.empty()) {
    cells = MeasureAccuracy(profile, filter, a.seed);
    ray_cells = MeasureRayAccuracy(profile, filter, a.seed);
  } else {
    const auto add = [&]<class T>(const std::vector<Scene<T>>& scenes) {
      for (const Scene<T>& scene : scenes) {
        const ProfileScene listed{
            scene.name, {scene.loop}, ScalarOf<T>(), /*weights=*/true};
        for (json& cell :
             MeasureAccuracyOn(scene, KernelsFor(listed, scene.loop, filter))) {
          cells.push_back(std::move(cell));
        }
      }
    };
    add(OwnScenes<float>(a.triangles, a.points));
    add(OwnScenes<double>(a.triangles, a.points));
  }
  if (cells.empty() && ray_cells.empty()) NoCells(a);
  const json file = {{"context", Context("pitbench-accuracy-2", a)},
                     {"cells", cells},
                     {"ray_cells", ray_cells}};
  out.Commit(file.dump() + "\n");
  std::cerr << a.out << ": " << cells.size() + ray_cells.size() << " cells\n";
}

}  // namespace

void AddAccuracy(CLI::App& app) {
  CLI::App* accuracy = app.add_subcommand(
      "accuracy", "Counts the wrong answers of the cells of a profile");
  const std::shared_ptr<Arguments> arguments = AddArguments(*accuracy);
  AddSceneArguments(*accuracy, arguments);
  accuracy->callback([a = arguments] { Accuracy(*a); });
}

}  // namespace pitbench
