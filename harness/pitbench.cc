// The command line of pitbench.
//
// Exit codes: 0 done, 1 a check did not hold, 2 the input or the call was
// wrong.
#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "harness/command/commands.h"
#include "harness/input/csv.h"
#include "harness/input/nearest.h"
#include "harness/scenes/spec.h"

namespace {

constexpr char kExamples[] = R"(Examples:
  pitbench list
  echo 'ax,ay,bx,by,cx,cy,px,py
  0,0,4,0,0,4,2,1' | pitbench classify --method cross_product -
  pitbench classify --method truth --scalar f32 cases.csv
  pitbench speed --filter 'one_triangle/.*/edge_function/f32/' --out speed.json
  pitbench accuracy --filter '/near_edge:.*/uv_projection/' --out accuracy.json
  pitbench accuracy --scene needle:aspect=14 --out needle.json
  pitbench speed --triangles T.csv --points P.csv --out own.json
  pitbench limits --filter '^(multiply_add|load)/' --out limits.json
  pitbench hunt --method uv_projection --scalar f32 --seconds 5
  pitbench shards --profile full
Exit codes: 0 done, 1 a check did not hold, 2 the input or the call was wrong.)";

// A mistyped subcommand, with the nearest one suggested; nothing otherwise.
std::string Suggestion(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return "";
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) {
    if (command->get_name() == argv[1]) return "";
    names.push_back(command->get_name());
  }
  return pitbench::NoSuch("command", argv[1], {names.begin(), names.end()});
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "pitbench: is this point inside this triangle, how fast, and "
      "how right?");
  app.footer(kExamples);
  app.require_subcommand(1);
  pitbench::AddList(app);
  pitbench::AddClassify(app);
  pitbench::AddSpeed(app);
  pitbench::AddAccuracy(app);
  pitbench::AddLimits(app);
  pitbench::AddMaps(app);
  pitbench::AddOperations(app);
  pitbench::AddInstructions(app);
  pitbench::AddHunt(app);
  pitbench::AddVerify(app);
  pitbench::AddMachine(app);
  pitbench::AddShards(app);
  const std::string suggestion = Suggestion(app, argc, argv);
  if (!suggestion.empty()) {
    std::cerr << "pitbench: " << suggestion << '\n';
    return 2;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const pitbench::InputError& error) {
    std::cerr << "pitbench: " << error.what() << '\n';
    return 2;
  } catch (const pitbench::SceneError& error) {
    std::cerr << "pitbench: " << error.what() << '\n';
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "pitbench: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
