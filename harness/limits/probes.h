// Loops that do one thing as fast as the machine can: what they reach is the
// limit that a kernel's time is held against.
//
// A probe must not be folded by the compiler, nor wait for anything but the
// execution units it is about:
//   - every operation passes a value through an empty asm statement, so the
//     compiler knows nothing of its operands and keeps every one;
//   - there are more independent chains than latency × units (12, or 24 where
//     the ISA has 32 registers), so no operation waits for the one before;
//   - operands stay in registers, and are neither subnormal nor infinite.
#ifndef PITBENCH_HARNESS_LIMITS_PROBES_H_
#define PITBENCH_HARNESS_LIMITS_PROBES_H_

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "kernels/kernels.h"

namespace pitbench {

// What is counted as one operation, a lane of a vector each.
enum class Operation {
  kAdd,          // or subtract
  kMultiply,     // of floating-point numbers
  kMultiplyAdd,  // counted as one
  kDivide,
  kMinMax,
  kCompare,          // to a mask
  kIntegerMultiply,  // the low half of the product
  // Of floating-point numbers, several kinds at once: units that do one may or
  // may not be the units that do another.
  kMixed,  // multiply-adds (multiplications where the ISA has none) and as many
           // additions
  kAddMinMaxCompare,     // as many additions as minima and comparisons together
  kMultiplyMultiplyAdd,  // as many of the one as of the other
};

struct OperationProbe {
  Isa isa;
  std::string_view scalar;  // "f32", "f64", "i32", "i16", "u8"
  Operation operation;
  // Returns the number of operations that it did, which grows with `rounds`.
  std::size_t (*run)(std::size_t rounds);
};

enum class Access { kLoad, kStore };

struct MemoryProbe {
  Isa isa;
  // Kernels of these scalars access memory like this. A vector is a vector,
  // whatever its lanes; one-lane code takes as many bytes as a scalar has.
  std::vector<std::string_view> scalars;
  Access access;
  std::size_t streams;  // how many arrays are walked at once
  // Walks over `bytes` bytes from `memory` on, a multiple of kMemoryStep ·
  // streams, `rounds` times.
  void (*run)(std::byte* memory, std::size_t bytes, std::size_t rounds);
};

// No vector that is asked here is longer than a quarter of this.
inline constexpr std::size_t kMemoryStep = 1024;

// The probes of every ISA that was compiled, whether or not it runs here.
std::vector<OperationProbe> OperationProbes();
std::vector<MemoryProbe> MemoryProbes();

std::string_view Name(Operation operation);
std::string_view Name(Access access);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_LIMITS_PROBES_H_
