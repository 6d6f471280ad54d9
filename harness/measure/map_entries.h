// What the maps of points and those of rays are written with.
#ifndef PITBENCH_HARNESS_MEASURE_MAP_ENTRIES_H_
#define PITBENCH_HARNESS_MEASURE_MAP_ENTRIES_H_

#include <cstddef>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "harness/measure/answers.h"
#include "kernels/kernels.h"

namespace pitbench {

// RFC 4648.
inline std::string Base64(const Bits& bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t n = std::min<std::size_t>(bytes.size() - i, 3);
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8 | (k < n ? bytes[i + k] : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text.push_back(k <= n ? kDigits[group >> (18 - 6 * k) & 63] : '=');
    }
  }
  return text;
}

// Of every method and scalar the kernel on the widest ISA that runs here.
template <class KernelType, class LoopOf, class OutputOf>
std::vector<const KernelType*> WidestKernels(
    std::span<const KernelType> kernels, LoopOf loop, OutputOf output) {
  std::map<std::pair<std::string_view, Scalar>, std::size_t> place;
  std::vector<const KernelType*> widest;
  for (const KernelType& kernel : kernels) {
    if (kernel.loop != loop || kernel.output != output ||
        !RunsHere(kernel.isa)) {
      continue;
    }
    const auto [at, is_new] = place.emplace(
        std::pair{kernel.method.key, kernel.scalar}, widest.size());
    if (is_new) widest.push_back(&kernel);
    if (kernel.isa > widest[at->second]->isa) widest[at->second] = &kernel;
  }
  return widest;
}

// What every map begins with.
template <class KernelType>
nlohmann::json Named(const KernelType& kernel) {
  return {{"method", kernel.method.key},
          {"scalar", Name(kernel.scalar)},
          {"isa", Name(kernel.isa)}};
}

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_MAP_ENTRIES_H_
