// The loops of kernels for arm64, on a machine that cannot run them.
//
// The program arm64_calls (harness/arm64) is cross-compiled beside pitbench and
// run by qemu-user, which emulates one instruction at a time and logs where it
// is. So the loops come from the instructions that run, as on x86-64, and not
// from guesses at a disassembly; nothing of it is timed.
#ifndef PITBENCH_HARNESS_MEASURE_EMULATED_LOOPS_H_
#define PITBENCH_HARNESS_MEASURE_EMULATED_LOOPS_H_

#include <array>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/input/name_filter.h"
#include "harness/measure/instruction_trace.h"

namespace pitbench {

// What the log says of one kernel.
struct EmulatedKernel {
  std::string method;
  std::string scalar;
  std::string isa;
  int vector_bits = 0;
  std::size_t n = 0;
  // Nothing, n points twice (the second is what counts), 2n points.
  std::vector<Trace> calls;
};

// Reads the log line by line: what arm64_calls writes, and qemu's lines
//   Trace 0: 0x7f… [<base>/<address>/<flags>/<flags>] <symbol>
// for what ran in between. Throws std::runtime_error at any other line.
class EmulationLog {
 public:
  void Read(std::string_view line);
  const std::vector<EmulatedKernel>& kernels() const { return kernels_; }

 private:
  std::vector<EmulatedKernel> kernels_;
  bool calling_ = false;
};

// The instruction at `address` of a program (its file's bytes: ELF, 64 bits,
// not relocated), as hex in the order of the bytes. Throws std::runtime_error
// if there is none.
std::string Arm64InstructionBytes(std::string_view elf, std::uintptr_t address);

struct EmulatedLoops {
  nlohmann::json rows;  // as in instructions.json, with vector_bits
  std::string reason;   // why there are none; empty where there are
};

// Runs `program` for neon, for sve with vectors of 256 bits and for sve2 with
// vectors of 128, the lengths of the CPUs that are modelled; keeps the kernels
// whose `loop/method/scalar/isa` the filter finds. Throws std::runtime_error if
// the program is there and qemu-user too, but they do not do as they should.
EmulatedLoops EmulateLoops(const std::string& program,
                           const NameFilter& filter);

// Where arm64_calls is expected: beside the program that runs.
std::string Arm64CallsBesideThis();

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_EMULATED_LOOPS_H_
