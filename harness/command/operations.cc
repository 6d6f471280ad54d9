#include "harness/measure/operations.h"

#include <iostream>
#include <nlohmann/json.hpp>

#include "harness/command/arguments.h"
#include "harness/command/commands.h"
#include "harness/command/output.h"
#include "harness/input/csv.h"
#include "harness/input/name_filter.h"

namespace pitbench {

void AddOperations(CLI::App& app) {
  CLI::App* operations = app.add_subcommand(
      "operations",
      "Counts the operations of every method, a call and an item, in vectors\n"
      "of 64 bytes (the same in all profiles); --filter is matched against\n"
      "loop/method/scalar");
  const std::shared_ptr<Arguments> arguments = AddArguments(*operations);
  operations->callback([a = arguments] {
    FindProfile(a->profile);  // throws if there is none
    const NameFilter filter(a->filter);
    OutputFile out(a->out);
    nlohmann::json file = OperationsOf(filter);
    if (file["rows"].empty()) {
      throw InputError("no kernel fits --filter '" + a->filter +
                       "'; it is matched against loop/method/scalar");
    }
    file["context"] = Context("operations-1", *a);
    file["context"].erase("schema");
    out.Commit(file.dump() + "\n");
    std::cerr << a->out << ": " << file["rows"].size() << " rows\n";
  });
}

}  // namespace pitbench
