#include <array>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <regex>
#include <string>

#include "harness/command/commands.h"
#include "harness/command/output.h"
#include "harness/input/csv.h"
#include "harness/measure/accuracy.h"
#include "harness/measure/cells.h"
#include "harness/measure/clock.h"
#include "harness/measure/machine.h"
#include "harness/measure/speed.h"

namespace pitbench {
namespace {

using nlohmann::json;

struct Arguments {
  std::string profile = "quick";
  std::string filter;
  std::string out;
  std::string triangles;
  std::string points;
  std::vector<std::string> scenes;
  std::uint64_t seed = kDefaultSeed;
};

std::regex Filter(const std::string& text) {
  try {
    return std::regex(text);
  } catch (const std::regex_error& error) {
    throw InputError("--filter '" + text +
                     "' is not a regular expression: " + error.what());
  }
}

json Context(const char* schema, const Arguments& a) {
  return {{"schema", schema},
          {"profile",
           a.triangles.empty() && a.scenes.empty() ? a.profile : "custom"},
          {"filter", a.filter},
          {"revision", Revision()},
          {"dirty", Dirty()},
          {"seed", a.seed}};
}

// Your own triangles and points, for every loop that they fit.
template <class T>
std::vector<Scene<T>> OwnScenes(const Arguments& a) {
  constexpr std::array<std::string_view, 6> kTriangles = {"ax", "ay", "bx",
                                                          "by", "cx", "cy"};
  constexpr std::array<std::string_view, 2> kPoints = {"px", "py"};
  const Table<T> triangles = ReadCsv<T>(a.triangles, kTriangles);
  const Table<T> points = ReadCsv<T>(a.points, kPoints);
  if (triangles.rows == 0) throw InputError(a.triangles + ": no triangles");
  if (points.rows == 0) throw InputError(a.points + ": no points");
  Scene<T> all{.name = "own", .loop = Loop::kOneTriangle};
  const auto& t = triangles.columns;
  for (std::size_t i = 0; i < triangles.rows; ++i) {
    all.Add(Triangle<T>{
        {t[0][i], t[1][i]}, {t[2][i], t[3][i]}, {t[4][i], t[5][i]}});
    all.calls.push_back({i, 0, points.rows});
  }
  for (std::size_t i = 0; i < points.rows; ++i) {
    all.Add(Point<T>{points.columns[0][i], points.columns[1][i]});
  }
  std::vector<Scene<T>> scenes = {all};
  Scene<T> one_point = all;
  one_point.loop = Loop::kOnePoint;
  one_point.calls.clear();
  for (std::size_t i = 0; i < points.rows; ++i) {
    one_point.calls.push_back({0, i, triangles.rows});
  }
  scenes.push_back(one_point);
  if (triangles.rows == points.rows) {
    Scene<T> pairs = all;
    pairs.loop = Loop::kPairs;
    pairs.calls = {{0, 0, points.rows}};
    scenes.push_back(pairs);
  }
  return scenes;
}

// The profile that was asked for, with the scenes that were asked for.
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

[[noreturn]] void NoCells(const Arguments& a) {
  throw InputError("no cell of profile '" + a.profile +
                   "' that runs here fits --filter '" + a.filter +
                   "'; a cell is named loop/scene/method/scalar/isa");
}

void Accuracy(const Arguments& a) {
  const Profile profile = Asked(a);
  const std::regex filter = Filter(a.filter);
  OutputFile out(a.out);
  json cells = json::array();
  if (a.triangles.empty()) {
    cells = MeasureAccuracy(profile, filter, a.seed);
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
    add(OwnScenes<float>(a));
    add(OwnScenes<double>(a));
  }
  if (cells.empty()) NoCells(a);
  const json file = {{"context", Context("pitbench-accuracy-1", a)},
                     {"cells", cells}};
  out.Commit(file.dump() + "\n");
  std::cerr << a.out << ": " << cells.size() << " cells\n";
}

void Speed(const Arguments& a) {
  const Profile profile = Asked(a);
  const std::regex filter = Filter(a.filter);
  OutputFile out(a.out);
  const int cpu = PinToLastCpu();
  const double clock_before = ClockGhz();
  const double steal_before = StealSeconds();
  const auto start = std::chrono::steady_clock::now();
  SpeedRun run = a.triangles.empty()
                     ? MeasureSpeed(profile, filter, a.seed)
                     : MeasureSpeedOn(OwnScenes<float>(a), OwnScenes<double>(a),
                                      filter, profile.seconds_per_sample);
  if (run.cells == 0) NoCells(a);
  const std::chrono::duration<double> time =
      std::chrono::steady_clock::now() - start;
  const double clock_after = ClockGhz();
  std::array<double, 1> load{};
  getloadavg(load.data(), 1);
  json context = Context("pitbench-speed-1", a);
  context.update(
      {{"cpu", cpu},
       {"clock_before_ghz", clock_before},
       {"clock_after_ghz", clock_after},
       {"steal_percent", 100 * (StealSeconds() - steal_before) / time.count()},
       {"load_average", load[0]}});
  run.file["context"]["pitbench"] = context;
  out.Commit(run.file.dump() + "\n");
  std::cerr << a.out << ": " << run.cells << " cells";
  if (run.refused != 0) std::cerr << ", " << run.refused << " refused";
  std::cerr << '\n';
}

std::shared_ptr<Arguments> AddMeasurement(CLI::App& command) {
  auto a = std::make_shared<Arguments>();
  command.add_option("--profile", a->profile, "tiny, quick or full")
      ->capture_default_str();
  command.add_option("--filter", a->filter,
                     "only cells (loop/scene/method/scalar/isa) in which this "
                     "regular expression is found");
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
  command.add_option("--out", a->out, "the JSON file to write")->required();
  return a;
}

}  // namespace

void AddMeasure(CLI::App& app) {
  CLI::App* speed = app.add_subcommand(
      "speed", "Times the cells of a profile, or your own scene");
  const auto speed_arguments = AddMeasurement(*speed);
  speed->callback([a = speed_arguments] { Speed(*a); });

  CLI::App* accuracy = app.add_subcommand(
      "accuracy", "Counts the wrong answers of the cells of a profile");
  const auto accuracy_arguments = AddMeasurement(*accuracy);
  accuracy->callback([a = accuracy_arguments] { Accuracy(*a); });

  const auto machine_out = std::make_shared<std::string>();
  CLI::App* machine =
      app.add_subcommand("machine", "Describes this machine and this build");
  machine->add_option("--out", *machine_out, "the JSON file to write")
      ->required();
  machine->callback([machine_out] {
    OutputFile(*machine_out)
        .Commit(DescribeMachine(kDefaultSeed).dump(1) + "\n");
  });

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
