#include "harness/limits/probes.h"

#include <hwy/highway.h>

#include <string>

#include "harness/limits/isa_probes.h"

namespace pitbench {

namespace scalar {
IsaProbes Probes();
}
#if HWY_ARCH_X86
namespace ssse3 {
IsaProbes Probes();
}
namespace sse4 {
IsaProbes Probes();
}
namespace avx2 {
IsaProbes Probes();
}
namespace avx512 {
IsaProbes Probes();
}
#elif HWY_ARCH_ARM_A64
namespace neon {
IsaProbes Probes();
}
namespace sve {
IsaProbes Probes();
}
namespace sve2 {
IsaProbes Probes();
}
#endif

namespace {

std::vector<IsaProbes> EveryIsa() {
  return {
    scalar::Probes(),
#if HWY_ARCH_X86
        ssse3::Probes(), sse4::Probes(), avx2::Probes(), avx512::Probes(),
#elif HWY_ARCH_ARM_A64
        neon::Probes(), sve::Probes(), sve2::Probes(),
#endif
  };
}

}  // namespace

std::vector<OperationProbe> OperationProbes() {
  std::vector<OperationProbe> all;
  for (const IsaProbes& isa : EveryIsa()) {
    all.insert(all.end(), isa.operations, isa.operations + isa.operation_count);
  }
  return all;
}

std::vector<MemoryProbe> MemoryProbes() {
  std::vector<MemoryProbe> all;
  for (const IsaProbes& isa : EveryIsa()) {
    for (std::size_t i = 0; i < isa.memory_count; ++i) {
      const IsaMemoryProbe& probe = isa.memory[i];
      std::vector<std::string_view> scalars = {probe.scalar};
      if (scalars[0].empty()) scalars = {"f32", "f64", "i32", "i16", "u8"};
      all.push_back({isa.operations[0].isa, scalars, probe.access,
                     probe.streams, probe.run});
    }
  }
  return all;
}

std::string_view Name(Operation operation) {
  switch (operation) {
    case Operation::kAdd:
      return "add";
    case Operation::kMultiply:
      return "multiply";
    case Operation::kMultiplyAdd:
      return "multiply_add";
    case Operation::kDivide:
      return "divide";
    case Operation::kMinMax:
      return "min_max";
    case Operation::kCompare:
      return "compare";
    case Operation::kIntegerMultiply:
      return "integer_multiply";
    case Operation::kMixed:
      return "mixed";
    case Operation::kAddMinMaxCompare:
      return "add_min_max_compare";
    case Operation::kMultiplyMultiplyAdd:
      return "multiply_multiply_add";
  }
  return "?";
}

std::string_view Name(Access access) {
  return access == Access::kLoad ? "load" : "store";
}

}  // namespace pitbench
