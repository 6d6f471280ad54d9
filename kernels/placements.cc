#include "kernels/placements.h"

#include <hwy/targets.h>

#include <vector>

namespace pitbench {

#if defined(PITBENCH_FEWER_KERNELS)
std::span<const Placement> Placements() { return {}; }
#else

// What CMake compiles for each shift: the namespaces of the ISAs in one of the
// placement.
#define PITBENCH_PLACED_ISA(isa)           \
  namespace isa {                          \
  std::span<const Kernel> cross_product(); \
  std::span<const Kernel> edge_function(); \
  }
#if HWY_ARCH_X86
#define PITBENCH_PLACED_ISAS \
  PITBENCH_PLACED_ISA(avx2)  \
  PITBENCH_PLACED_ISA(avx512)
#elif HWY_ARCH_ARM_A64
#define PITBENCH_PLACED_ISAS PITBENCH_PLACED_ISA(neon)
#endif

namespace placed_0 {
PITBENCH_PLACED_ISAS
}
namespace placed_16 {
PITBENCH_PLACED_ISAS
}
namespace placed_32 {
PITBENCH_PLACED_ISAS
}
namespace placed_48 {
PITBENCH_PLACED_ISAS
}

namespace {

std::vector<Placement> JoinPlacements() {
  std::vector<Placement> all;
  const auto add = [&all](std::size_t shift, std::span<const Kernel> rows) {
    for (const Kernel& kernel : rows) all.push_back({shift, kernel});
  };
#define PITBENCH_ADD(shift, isa)                    \
  add(shift, placed_##shift::isa::cross_product()); \
  add(shift, placed_##shift::isa::edge_function());
#if HWY_ARCH_X86
#define PITBENCH_ADD_SHIFT(shift) \
  PITBENCH_ADD(shift, avx2)       \
  PITBENCH_ADD(shift, avx512)
#elif HWY_ARCH_ARM_A64
#define PITBENCH_ADD_SHIFT(shift) PITBENCH_ADD(shift, neon)
#endif
  PITBENCH_ADD_SHIFT(0)
  PITBENCH_ADD_SHIFT(16)
  PITBENCH_ADD_SHIFT(32)
  PITBENCH_ADD_SHIFT(48)
  return all;
}

}  // namespace

std::span<const Placement> Placements() {
  static const std::vector<Placement> all = JoinPlacements();
  return all;
}

#endif  // PITBENCH_FEWER_KERNELS

}  // namespace pitbench
