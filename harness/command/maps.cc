#include "harness/measure/maps.h"

#include <iostream>
#include <nlohmann/json.hpp>

#include "harness/command/arguments.h"
#include "harness/command/commands.h"
#include "harness/command/output.h"
#include "harness/input/name_filter.h"
#include "harness/measure/rays/ray_maps.h"
#include "harness/measure/two_truths.h"

namespace pitbench {

void AddMaps(CLI::App& app) {
  CLI::App* maps = app.add_subcommand(
      "maps",
      "What every method says of points an ulp apart, and its weights over a\n"
      "triangle near the origin and far from it; of rays a step apart beside "
      "a\n"
      "vertex of a sphere, and of published ones (the same in all profiles)");
  const std::shared_ptr<Arguments> arguments = AddArguments(*maps);
  maps->callback([a = arguments] {
    FindProfile(a->profile);  // throws if there is none
    const NameFilter filter(a->filter);
    OutputFile out(a->out);
    nlohmann::json file = MakeMaps(filter);
    file.update(MakeRayMaps(filter));
    const std::size_t count =
        file["ulp_maps"].size() + file["gradients"].size() +
        file["ray_maps"].size() + file["ray_cases"].size();
    if (count == 0) NoCells(*a);
    file["two_truths"] = TwoTruths();
    file["context"] = Context("pitbench-maps-1", *a);
    out.Commit(file.dump() + "\n");
    std::cerr << a->out << ": " << count << " maps\n";
  });
}

}  // namespace pitbench
