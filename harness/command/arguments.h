// What the measuring commands share: their arguments, and the context that
// each file begins with.
#ifndef PITBENCH_HARNESS_COMMAND_ARGUMENTS_H_
#define PITBENCH_HARNESS_COMMAND_ARGUMENTS_H_

#include <CLI/CLI.hpp>
#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "harness/measure/cells.h"

namespace pitbench {

struct Arguments {
  std::string profile = "quick";
  std::string filter;
  std::string out;
  std::string triangles;
  std::string points;
  std::vector<std::string> scenes;
  std::uint64_t seed = kDefaultSeed;
};

// Adds --profile, --filter and --out.
std::shared_ptr<Arguments> AddArguments(CLI::App& command);

// Adds --scene, --triangles, --points and --seed.
void AddSceneArguments(CLI::App& command, const std::shared_ptr<Arguments>& a);

// These throw InputError for what the caller got wrong.
// The profile that was asked for, with the scenes that were asked for.
Profile Asked(const Arguments& a);
[[noreturn]] void NoCells(const Arguments& a);

nlohmann::json Context(const char* schema, const Arguments& a);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_COMMAND_ARGUMENTS_H_
