#include "harness/measure/instructions.h"

#include <iostream>
#include <nlohmann/json.hpp>
#include <utility>

#include "harness/command/arguments.h"
#include "harness/command/commands.h"
#include "harness/command/output.h"
#include "harness/input/csv.h"
#include "harness/input/name_filter.h"
#include "harness/measure/emulated_loops.h"

namespace pitbench {

void AddInstructions(CLI::App& app) {
  CLI::App* instructions = app.add_subcommand(
      "instructions",
      "Counts the instructions that kernels execute, a call and an item, and\n"
      "writes those of their loops (x86-64 Linux), and for the arm64 kernels "
      "of\n"
      "one_triangle where arm64_calls lies beside and qemu-user is installed;\n"
      "--filter is matched against loop/method/scalar/isa");
  const std::shared_ptr<Arguments> arguments = AddArguments(*instructions);
  instructions->callback([a = arguments] {
    FindProfile(a->profile);  // throws if there is none
    const NameFilter filter(a->filter);
    OutputFile out(a->out);
    nlohmann::json file = InstructionsOf(filter);
    const auto reason = file["reason"].get<std::string>();
    EmulatedLoops emulated = EmulateLoops(Arm64CallsBesideThis(), filter);
    file["not_emulated"] = emulated.reason;
    for (auto& row : emulated.rows) file["rows"].push_back(std::move(row));
    if (file["rows"].empty() && reason.empty()) {
      throw InputError("no kernel that runs here fits --filter '" + a->filter +
                       "'; it is matched against loop/method/scalar/isa");
    }
    file["context"] = Context("instructions-1", *a);
    file["context"].erase("schema");
    out.Commit(file.dump() + "\n");
    std::cerr << a->out << ": " << file["rows"].size() << " rows"
              << (reason.empty() ? "" : "; " + reason)
              << (emulated.reason.empty() ? "" : "; " + emulated.reason)
              << '\n';
  });
}

}  // namespace pitbench
