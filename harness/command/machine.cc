#include "harness/measure/machine.h"

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "harness/command/commands.h"
#include "harness/command/output.h"
#include "harness/measure/cells.h"

namespace pitbench {

void AddMachine(CLI::App& app) {
  const auto machine_out = std::make_shared<std::string>();
  CLI::App* machine =
      app.add_subcommand("machine", "Describes this machine and this build");
  machine->add_option("--out", *machine_out, "the JSON file to write")
      ->required();
  machine->callback([machine_out] {
    OutputFile(*machine_out)
        .Commit(DescribeMachine(kDefaultSeed).dump(1) + "\n");
  });
}

void AddShards(CLI::App& app) {
  const auto profile = std::make_shared<std::string>("quick");
  CLI::App* shards = app.add_subcommand(
      "shards",
      "The shards of a profile, one a line: name, command, its arguments");
  shards->add_option("--profile", *profile, "tiny, quick or full")
      ->capture_default_str();
  shards->callback([profile] {
    for (const Shard& shard : Shards(FindProfile(*profile))) {
      std::cout << shard.name << '\t' << shard.kind << "\t--profile "
                << *profile << " --filter " << shard.filter << '\n';
    }
  });
}

}  // namespace pitbench
