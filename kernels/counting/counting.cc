#include "kernels/counting/counting.h"

namespace pitbench {

// Written by CMake from methods.inc.
#define PITBENCH_METHOD(key) std::span<const Kernel> key();
namespace counting {
#include "counted_methods.inc"
}
#undef PITBENCH_METHOD

std::span<const Kernel> CountingKernels() {
  static const std::vector<Kernel> all = [] {
    std::vector<Kernel> joined;
    const auto add = [&joined](std::span<const Kernel> rows) {
      joined.insert(joined.end(), rows.begin(), rows.end());
    };
#define PITBENCH_METHOD(key) add(counting::key());
#include "counted_methods.inc"
#undef PITBENCH_METHOD
    return joined;
  }();
  return all;
}

}  // namespace pitbench
