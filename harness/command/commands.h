// The subcommands of pitbench. Each adds itself to the command line and throws
// InputError or SceneError for what its caller got wrong.
#ifndef PITBENCH_HARNESS_COMMAND_COMMANDS_H_
#define PITBENCH_HARNESS_COMMAND_COMMANDS_H_

#include <CLI/CLI.hpp>

namespace pitbench {

void AddList(CLI::App& app);          // list
void AddClassify(CLI::App& app);      // classify
void AddSpeed(CLI::App& app);         // speed
void AddAccuracy(CLI::App& app);      // accuracy
void AddLimits(CLI::App& app);        // limits
void AddMaps(CLI::App& app);          // maps
void AddOperations(CLI::App& app);    // operations
void AddHunt(CLI::App& app);          // hunt
void AddVerify(CLI::App& app);        // verify
void AddMachine(CLI::App& app);       // machine
void AddInstructions(CLI::App& app);  // instructions
void AddShards(CLI::App& app);        // shards

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_COMMAND_COMMANDS_H_
