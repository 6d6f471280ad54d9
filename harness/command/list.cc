#include <algorithm>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

#include "harness/command/commands.h"
#include "harness/scenes/spec.h"
#include "kernels/kernels.h"

namespace pitbench {
namespace {

using nlohmann::json;

json Listing() {
  json methods = json::array();
  json isas = json::array();
  json loops = json::array();
  json scalars = json::array();
  const auto add = [](json& names, std::string_view name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      names.push_back(name);
    }
  };
  for (const Kernel& kernel : AllKernels()) {
    const Method& method = kernel.method;
    auto known = std::find_if(
        methods.begin(), methods.end(),
        [&](const json& other) { return other["key"] == method.key; });
    if (known == methods.end()) {
      methods.push_back({{"key", method.key},
                         {"source", method.source},
                         {"formula", method.formula},
                         {"boundary", Name(method.boundary)},
                         {"accepts", Name(method.accepts)},
                         {"fma", method.fma},
                         {"warning", method.warning},
                         {"weights", false}});
      known = methods.end() - 1;
    }
    if (kernel.output == Output::kWeights) (*known)["weights"] = true;
    add(loops, Name(kernel.loop, kernel.output));
    add(scalars, Name(kernel.scalar));
  }
  for (int k = 0; k <= static_cast<int>(Isa::kSve2); ++k) {
    const auto isa = static_cast<Isa>(k);
    const bool compiled =
        std::any_of(AllKernels().begin(), AllKernels().end(),
                    [isa](const Kernel& kernel) { return kernel.isa == isa; });
    if (compiled) {
      isas.push_back({{"name", Name(isa)}, {"runs_here", RunsHere(isa)}});
    }
  }
  json scenes = json::array();
  for (const FamilyInfo& family : Families()) {
    scenes.push_back({{"name", family.name},
                      {"parameters", family.parameters},
                      {"describes", family.describes}});
  }
  return {{"methods", methods}, {"isas", isas},
          {"loops", loops},     {"scalars", scalars},
          {"scenes", scenes},   {"kernels", AllKernels().size()}};
}

void PrintListing(const json& listing) {
  const auto text = [](const json& value) { return value.get<std::string>(); };
  const auto row = [](const std::string& name, const std::string& rest) {
    std::printf("  %-31s %s\n", name.c_str(), rest.c_str());
  };
  std::puts("methods");
  for (const json& method : listing["methods"]) {
    row(text(method["key"]), text(method["formula"]));
    std::string more = text(method["boundary"]);
    if (method["accepts"] != "triangle") {
      more += ", accepts only the " + text(method["accepts"]);
    }
    if (method["fma"]) more += ", with FMA";
    if (method["weights"]) more += ", weights";
    row("", "[" + text(method["source"]) + "; " + more + "]");
    if (method["warning"] != "") row("", "warning: " + text(method["warning"]));
  }
  std::puts("ISAs");
  for (const json& isa : listing["isas"]) {
    row(text(isa["name"]), isa["runs_here"] ? "runs here" : "not on this CPU");
  }
  std::puts("loops");
  for (const json& loop : listing["loops"]) row(text(loop), "");
  std::puts("scalars");
  for (const json& scalar : listing["scalars"]) row(text(scalar), "");
  std::puts("scenes");
  for (const json& scene : listing["scenes"]) {
    const std::string keys = text(scene["parameters"]);
    row(text(scene["name"]) + (keys.empty() ? "" : ":" + keys),
        text(scene["describes"]));
  }
  std::printf("%zu kernels\n", listing["kernels"].get<std::size_t>());
}

}  // namespace

void AddList(CLI::App& app) {
  CLI::App* list = app.add_subcommand(
      "list", "Methods, scalars, ISAs (and which run here), loops, scenes");
  const auto as_json = std::make_shared<bool>(false);
  list->add_flag("--json", *as_json, "as JSON");
  list->callback([as_json] {
    const json listing = Listing();
    if (*as_json) {
      std::cout << listing.dump(1) << '\n';
    } else {
      PrintListing(listing);
    }
  });
}

}  // namespace pitbench
