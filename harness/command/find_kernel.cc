#include "harness/command/find_kernel.h"

#include <algorithm>

#include "harness/input/csv.h"
#include "harness/input/nearest.h"

namespace pitbench {
namespace {

void Require(std::string_view kind, std::string_view name,
             const std::vector<std::string_view>& names) {
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    throw InputError(NoSuch(kind, name, names));
  }
}

}  // namespace

Scalar FloatScalar(const std::string& name) {
  Require("scalar", name, {"f32", "f64"});
  return name == "f32" ? Scalar::kF32 : Scalar::kF64;
}

const Kernel& FindPairsKernel(const std::string& method, Scalar scalar,
                              const std::string& isa,
                              const std::vector<std::string_view>& others) {
  std::vector<std::string_view> methods = others;
  std::vector<std::string_view> isas;
  const Kernel* found = nullptr;
  bool has_scalar = false;
  for (const Kernel& kernel : AllKernels()) {
    methods.push_back(kernel.method.key);
    isas.push_back(Name(kernel.isa));
    if (kernel.method.key != method || kernel.scalar != scalar ||
        kernel.loop != Loop::kPairs || kernel.output != Output::kInside) {
      continue;
    }
    has_scalar = true;
    if (isa.empty() ? RunsHere(kernel.isa) : Name(kernel.isa) == isa) {
      if (found == nullptr || kernel.isa > found->isa) found = &kernel;
    }
  }
  Require("method", method, methods);
  if (!isa.empty()) Require("ISA", isa, isas);
  if (!has_scalar) {
    throw InputError("method '" + method + "' has no kernel for scalar '" +
                     std::string(Name(scalar)) + "': give another --scalar");
  }
  if (found == nullptr && isa.empty()) {
    throw InputError("no kernel of method '" + method +
                     "' runs on this CPU: see pitbench list");
  }
  if (found == nullptr) {
    throw InputError("method '" + method + "' is not compiled for ISA '" + isa +
                     "': see pitbench list");
  }
  if (!RunsHere(found->isa)) {
    throw InputError("ISA '" + isa +
                     "' does not run on this CPU: see pitbench list");
  }
  return *found;
}

}  // namespace pitbench
