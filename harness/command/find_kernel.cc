#include "harness/command/find_kernel.h"

#include <algorithm>
#include <span>

#include "harness/input/csv.h"
#include "harness/input/nearest.h"
#include "harness/measure/measured_kernels.h"

namespace pitbench {
namespace {

void Require(std::string_view kind, std::string_view name,
             const std::vector<std::string_view>& names) {
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    throw InputError(NoSuch(kind, name, names));
  }
}

// One of `kernels` by a method, for a scalar, that fits(kernel): as the header
// has it.
template <class K, class Fits>
const K& FindFitting(std::span<const K> kernels, const Fits& fits,
                     const std::string& method, Scalar scalar,
                     const std::string& isa,
                     std::vector<std::string_view> methods) {
  std::vector<std::string_view> isas;
  const K* found = nullptr;
  bool has_scalar = false;
  for (const K& kernel : kernels) {
    methods.push_back(kernel.method.key);
    isas.push_back(Name(kernel.isa));
    if (kernel.method.key != method || kernel.scalar != scalar ||
        !fits(kernel)) {
      continue;
    }
    has_scalar = true;
    if (isa.empty() ? RunsHere(kernel.isa) : Name(kernel.isa) == isa) {
      // The last of the widest: rows are ordered by loop within an ISA.
      if (found == nullptr || kernel.isa >= found->isa) found = &kernel;
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

}  // namespace

Scalar FloatScalar(const std::string& name) {
  Require("scalar", name, {"f32", "f64"});
  return name == "f32" ? Scalar::kF32 : Scalar::kF64;
}

const Kernel& FindCaseKernel(const std::string& method, Scalar scalar,
                             const std::string& isa,
                             const std::vector<std::string_view>& others) {
  const auto fits = [](const Kernel& kernel) {
    return (kernel.loop == Loop::kPairs || kernel.loop == Loop::kOneTriangle) &&
           kernel.output == Output::kInside;
  };
  return FindFitting(MeasuredKernels(), fits, method, scalar, isa, others);
}

const RayKernel& FindRayPairsKernel(
    const std::string& method, Scalar scalar, const std::string& isa,
    const std::vector<std::string_view>& others) {
  const auto fits = [](const RayKernel& kernel) {
    return kernel.loop == RayLoop::kRayPairs &&
           kernel.output == RayOutput::kHits;
  };
  return FindFitting(AllRayKernels(), fits, method, scalar, isa, others);
}

bool MeansRays(const std::string& method, bool said_so) {
  const auto has = [&method](const auto& kernels) {
    return std::any_of(kernels.begin(), kernels.end(),
                       [&](const auto& k) { return k.method.key == method; });
  };
  return said_so || (has(AllRayKernels()) && !has(MeasuredKernels()));
}

std::vector<std::string_view> RayMethodKeys() {
  std::vector<std::string_view> keys;
  for (const RayKernel& kernel : AllRayKernels()) {
    keys.push_back(kernel.method.key);
  }
  return keys;
}

}  // namespace pitbench
