// Which instructions a call executes, one after another.
//
// The processor's trap flag makes it stop after every instruction, and the
// handler of the signal that follows notes where. That takes ten thousand
// times as long as the instruction, and needs no right and no other process.
#ifndef PITBENCH_HARNESS_MEASURE_INSTRUCTION_TRACE_H_
#define PITBENCH_HARNESS_MEASURE_INSTRUCTION_TRACE_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pitbench {

using Trace = std::vector<std::uintptr_t>;  // addresses, in order

// The instructions that `call` executes, and a few around it, the same number
// every time. Not for several threads at once. Throws std::runtime_error where
// instructions cannot be traced (see CannotTrace), or are more than a few
// millions.
Trace TraceOf(const std::function<void()>& call);

// Why TraceOf cannot work here; empty if it can.
std::string CannotTrace();

// What repeats in the trace of a loop.
struct SteadyLoop {
  double per_item;    // instructions
  double per_call;    // those that do not grow with the items
  std::size_t items;  // of one iteration; 0 where none repeats exactly
  Trace iteration;    // its instructions; empty where `items` is 0
};

// From the traces of a call on n items and of one on 2n: what the second n
// took is per item, the rest per call, but for `around` instructions of every
// trace. The iteration is the longest stretch that comes again and again at
// equal steps; where a branch depends on the items there is none.
SteadyLoop FindSteadyLoop(const Trace& once, const Trace& twice, std::size_t n,
                          std::size_t around);

// The bytes of each instruction of an iteration, in hex. Precondition: the
// addresses are of code of this process.
std::vector<std::string> InstructionBytes(const Trace& iteration);

// The length of the instruction at `code`, which was followed by the one at
// `next`.
std::size_t InstructionLength(const std::uint8_t* code,
                              const std::uint8_t* next);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_INSTRUCTION_TRACE_H_
