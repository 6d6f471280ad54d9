// What harness/limits/isa_probes.cc exports for each ISA.
#ifndef PITBENCH_HARNESS_LIMITS_ISA_PROBES_H_
#define PITBENCH_HARNESS_LIMITS_ISA_PROBES_H_

#include "harness/limits/probes.h"

namespace pitbench {

// A MemoryProbe as constant data.
struct IsaMemoryProbe {
  const char* scalar;  // or "" for all of them
  Access access;
  std::size_t streams;
  void (*run)(std::byte* memory, std::size_t bytes, std::size_t rounds);
};

struct IsaProbes {
  const OperationProbe* operations;
  std::size_t operation_count;
  const IsaMemoryProbe* memory;
  std::size_t memory_count;
};

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_LIMITS_ISA_PROBES_H_
