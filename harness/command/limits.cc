#include "harness/limits/limits.h"

#include <iostream>
#include <nlohmann/json.hpp>

#include "harness/command/arguments.h"
#include "harness/command/commands.h"
#include "harness/command/output.h"
#include "harness/input/csv.h"
#include "harness/input/name_filter.h"
#include "harness/measure/clock.h"
#include "harness/measure/machine.h"
#include "harness/measure/speed.h"
#include "harness/measure/threads.h"

namespace pitbench {
namespace {

void Limits(const Arguments& a) {
  const double seconds = FindProfile(a.profile).speed_budget.seconds;
  const NameFilter filter(a.filter);
  OutputFile out(a.out);
  const int cpu = PinToLastCpu();
  const nlohmann::json machine = DescribeMachine(a.seed);
  const std::vector<MemoryLevel> levels =
      MemoryLevels(DataCaches(machine.at("cpu").at("caches")),
                   machine.at("memory_bytes").get<std::size_t>());
  const double clock_before = MeasurePace().clock_ghz;
  nlohmann::json file = MeasureLimits(levels, filter, seconds, kRepetitions);
  const std::size_t count = file["memory"].size() + file["operations"].size();
  if (count == 0) {
    throw InputError("no limit that can be measured here fits --filter '" +
                     a.filter +
                     "'; one is named operation/scalar/isa, e.g. add/f32/avx2, "
                     "or load/level/isa");
  }
  file["context"] = Context("pitbench-limits-1", a);
  file["context"].update({{"cpu", cpu},
                          {"clock_before_ghz", clock_before},
                          {"clock_after_ghz", MeasurePace().clock_ghz},
                          {"seconds_per_sample", seconds},
                          {"repetitions", kRepetitions}});
  out.Commit(file.dump(1) + "\n");
  std::cerr << a.out << ": " << count << " limits\n";
}

}  // namespace

void AddLimits(CLI::App& app) {
  CLI::App* limits = app.add_subcommand(
      "limits",
      "What this machine can do at most: bandwidth of caches and memory, and\n"
      "operations a second, for each instruction set and scalar");
  const std::shared_ptr<Arguments> arguments = AddArguments(*limits);
  limits->callback([a = arguments] { Limits(*a); });
}

}  // namespace pitbench
