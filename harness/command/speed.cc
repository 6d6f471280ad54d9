#include "harness/measure/speed.h"

#include <array>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>

#include "harness/command/arguments.h"
#include "harness/command/commands.h"
#include "harness/command/output.h"
#include "harness/command/own_scenes.h"
#include "harness/input/name_filter.h"
#include "harness/measure/clock.h"
#include "harness/measure/threads.h"

namespace pitbench {
namespace {

using nlohmann::json;

void Speed(const Arguments& a) {
  const Profile profile = Asked(a);
  const NameFilter filter(a.filter);
  OutputFile out(a.out);
  const int cpu = PinToLastCpu();
  const double steal_before = StealSeconds();
  const auto start = std::chrono::steady_clock::now();
  SpeedRun run = a.triangles.empty()
                     ? MeasureSpeed(profile, filter, a.seed)
                     : MeasureSpeedOn(OwnScenes<float>(a.triangles, a.points),
                                      OwnScenes<double>(a.triangles, a.points),
                                      filter, profile.speed_budget);
  if (run.cells == 0) NoCells(a);
  const std::chrono::duration<double> time =
      std::chrono::steady_clock::now() - start;
  std::array<double, 1> load{};
  getloadavg(load.data(), 1);
  json context = Context("pitbench-speed-1", a);
  context.update(
      {{"cpu", cpu},
       {"clock_before_ghz", run.pace[0].clock_ghz},
       {"clock_after_ghz", run.pace[1].clock_ghz},
       {"throughput_before_gops", run.pace[0].throughput_gops},
       {"throughput_after_gops", run.pace[1].throughput_gops},
       {"quiet_share", run.quiet_share},
       {"steal_percent", 100 * (StealSeconds() - steal_before) / time.count()},
       {"load_average", load[0]},
       {"wall_seconds", run.occupancy.wall_seconds},
       {"cpu_seconds", run.occupancy.cpu_seconds},
       {"preemptions", run.occupancy.preemptions}});
  run.file["context"]["pitbench"] = context;
  out.Commit(run.file.dump() + "\n");
  std::cerr << a.out << ": " << run.cells << " cells";
  if (run.refused != 0) std::cerr << ", " << run.refused << " refused";
  std::cerr << '\n';
}

}  // namespace

void AddSpeed(CLI::App& app) {
  CLI::App* speed = app.add_subcommand(
      "speed", "Times the cells of a profile, or your own scene");
  const std::shared_ptr<Arguments> arguments = AddArguments(*speed);
  AddSceneArguments(*speed, arguments);
  speed->callback([a = arguments] { Speed(*a); });
}

}  // namespace pitbench
