#include <algorithm>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

#include "harness/command/commands.h"
#include "harness/measure/measured_kernels.h"
#include "harness/scenes/spec.h"
#include "kernels/kernels.h"
#include "kernels/rays/ray_kernels.h"

namespace pitbench {
namespace {

using nlohmann::json;

// What a kernel writes, as kernels.h and ray_kernels.h have it in full.
std::string_view Writes(Loop loop, Output output) {
  if (loop == Loop::kGrid) return "a row of bits for each row of pixels";
  return output == Output::kWeights ? "one bit an answer and three weights"
                                    : "one bit an answer";
}

std::string_view Writes(RayLoop /*loop*/, RayOutput output) {
  switch (output) {
    case RayOutput::kHits:
      break;
    case RayOutput::kTuv:
      return "one bit an answer and t, u and v";
    case RayOutput::kNearest:
      return "the nearest triangle that is hit, and its t";
  }
  return "one bit an answer";
}

// The methods of rays, in the words of those of points.
json RayMethods() {
  json methods = json::array();
  for (const RayKernel& kernel : MeasuredRayKernels()) {
    const RayMethod& method = kernel.method;
    if (!methods.empty() && methods.back()["key"] == method.key) continue;
    const bool known = std::any_of(
        methods.begin(), methods.end(),
        [&](const json& other) { return other["key"] == method.key; });
    if (known) continue;
    methods.push_back({{"key", method.key},
                       {"source", method.source},
                       {"formula", method.formula},
                       {"boundary", Name(method.boundary)},
                       {"fma", method.fma},
                       {"warning", method.warning},
                       {"culls_backface", method.culls_backface}});
  }
  return methods;
}

json Listing() {
  json methods = json::array();
  json isas = json::array();
  json loops = json::array();
  json scalars = json::array();
  json writes = json::object();
  const auto add = [](json& names, std::string_view name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      names.push_back(name);
    }
  };
  for (const Kernel& kernel : MeasuredKernels()) {
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
      if (method.finite_only) (*known)["finite_only"] = true;
    }
    if (kernel.output == Output::kWeights) (*known)["weights"] = true;
    add(loops, Name(kernel.loop, kernel.output));
    writes[std::string(Name(kernel.loop, kernel.output))] =
        Writes(kernel.loop, kernel.output);
    add(scalars, Name(kernel.scalar));
  }
  for (const RayKernel& kernel : MeasuredRayKernels()) {
    const std::string name(Name(kernel.loop, kernel.output));
    add(loops, name);
    writes[name] = Writes(kernel.loop, kernel.output);
  }
  for (int k = 0; k <= static_cast<int>(Isa::kLibrary); ++k) {
    const auto isa = static_cast<Isa>(k);
    const bool compiled =
        std::any_of(MeasuredKernels().begin(), MeasuredKernels().end(),
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
  return {{"methods", methods},
          {"isas", isas},
          {"loops", loops},
          {"scalars", scalars},
          {"scenes", scenes},
          {"kernels", MeasuredKernels().size()},
          {"writes", writes},
          {"ray_methods", RayMethods()},
          {"ray_kernels", MeasuredRayKernels().size()}};
}

void PrintListing(const json& listing) {
  const auto text = [](const json& value) { return value.get<std::string>(); };
  const auto row = [](const std::string& name, const std::string& rest) {
    std::printf("  %-31s %s\n", name.c_str(), rest.c_str());
  };
  const auto print_methods = [&](const char* title, const json& methods) {
    std::puts(title);
    for (const json& method : methods) {
      row(text(method["key"]), text(method["formula"]));
      std::string more = text(method["boundary"]);
      if (method.value("accepts", "triangle") != "triangle") {
        more += ", accepts only the " + text(method["accepts"]);
      }
      if (method["fma"]) more += ", with FMA";
      if (method.value("weights", false)) more += ", weights";
      if (method.value("culls_backface", false)) {
        more += ", only from the front";
      }
      row("", "[" + text(method["source"]) + "; " + more + "]");
      if (method["warning"] != "") {
        row("", "warning: " + text(method["warning"]));
      }
    }
  };
  print_methods("methods", listing["methods"]);
  print_methods("methods of rays", listing["ray_methods"]);
  std::puts("ISAs");
  for (const json& isa : listing["isas"]) {
    row(text(isa["name"]), isa["runs_here"] ? "runs here" : "not on this CPU");
  }
  std::puts("loops");
  for (const json& loop : listing["loops"]) {
    row(text(loop), "writes " + text(listing["writes"][text(loop)]));
  }
  std::puts("scalars");
  for (const json& scalar : listing["scalars"]) row(text(scalar), "");
  std::puts("scenes");
  for (const json& scene : listing["scenes"]) {
    const std::string keys = text(scene["parameters"]);
    row(text(scene["name"]) + (keys.empty() ? "" : ":" + keys),
        text(scene["describes"]));
  }
  std::printf("%zu kernels, %zu of rays\n",
              listing["kernels"].get<std::size_t>(),
              listing["ray_kernels"].get<std::size_t>());
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
