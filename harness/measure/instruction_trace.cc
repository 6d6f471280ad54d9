#include "harness/measure/instruction_trace.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <unordered_map>

#if defined(__x86_64__) && defined(__linux__)
#define PITBENCH_CAN_TRACE 1
#include <ucontext.h>
#include <x86intrin.h>

#include <csignal>
#else
#define PITBENCH_CAN_TRACE 0
#endif

namespace pitbench {
namespace {

#if PITBENCH_CAN_TRACE
constexpr std::size_t kMost = std::size_t{1} << 22;
constexpr unsigned long long kTrapFlag = 0x100;

// Where the handler writes; it may not allocate.
Trace* trace = nullptr;
volatile std::sig_atomic_t too_many = 0;

void NoteInstruction(int, siginfo_t*, void* context) {
  if (trace->size() == trace->capacity()) {
    too_many = 1;
    return;
  }
  const auto* state = static_cast<const ucontext_t*>(context);
  trace->push_back(
      static_cast<std::uintptr_t>(state->uc_mcontext.gregs[REG_RIP]));
}

Trace Traced(const std::function<void()>& call) {
  Trace found;
  found.reserve(kMost);
  trace = &found;
  too_many = 0;
  struct sigaction action = {};
  struct sigaction before = {};
  action.sa_sigaction = NoteInstruction;
  action.sa_flags = SA_SIGINFO;
  sigaction(SIGTRAP, &action, &before);
  __writeeflags(__readeflags() | kTrapFlag);
  call();
  __writeeflags(__readeflags() & ~kTrapFlag);
  sigaction(SIGTRAP, &before, nullptr);
  trace = nullptr;
  if (too_many != 0) throw std::runtime_error("too many instructions to trace");
  return found;
}
#endif

std::unordered_map<std::uintptr_t, std::size_t> Occurrences(const Trace& t) {
  std::unordered_map<std::uintptr_t, std::size_t> found;
  for (const std::uintptr_t address : t) ++found[address];
  return found;
}

}  // namespace

#if PITBENCH_CAN_TRACE
Trace TraceOf(const std::function<void()>& call) {
  const std::string reason = CannotTrace();
  if (!reason.empty()) throw std::runtime_error(reason);
  return Traced(call);
}

std::string CannotTrace() {
  static const bool works = !Traced([] {}).empty();
  return works ? ""
               : "the processor's trap flag has no effect in this environment";
}
#else
Trace TraceOf(const std::function<void()>&) {
  throw std::runtime_error(CannotTrace());
}

std::string CannotTrace() {
  return "instructions are traced on x86-64 Linux only";
}
#endif

SteadyLoop FindSteadyLoop(const Trace& once, const Trace& twice, std::size_t n,
                          std::size_t around) {
  const std::size_t more = twice.size() - once.size();
  SteadyLoop loop{
      .per_item = static_cast<double>(more) / static_cast<double>(n),
      .per_call =
          static_cast<double>(once.size()) - static_cast<double>(more + around),
      .items = 0,
      .iteration = {}};
  // How often each instruction runs for the second n items. The one that runs
  // least often is once in every iteration of the outermost loop.
  const auto in_once = Occurrences(once);
  const auto in_twice = Occurrences(twice);
  std::size_t iterations = 0;
  for (const auto& [address, count] : in_twice) {
    const auto before = in_once.find(address);
    const std::size_t extra =
        count - (before == in_once.end() ? 0 : before->second);
    if (extra != 0 && extra <= count && n % extra == 0 &&
        (iterations == 0 || extra < iterations)) {
      iterations = extra;
    }
  }
  if (iterations == 0) return loop;
  for (const std::uintptr_t address : twice) {
    const auto before = in_once.find(address);
    const auto known = before == in_once.end() ? 0 : before->second;
    if (in_twice.at(address) != known + iterations) continue;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < twice.size(); ++i) {
      if (twice[i] == address) places.push_back(i);
    }
    if (places.size() < 2) break;
    const std::size_t middle = (places.size() - 2) / 2;
    const std::size_t from = places[middle];
    const std::size_t to = places[middle + 1];
    // Else the steps are not equal.
    if ((to - from) * iterations == more) {
      loop.items = n / iterations;
      loop.iteration.assign(twice.begin() + static_cast<std::ptrdiff_t>(from),
                            twice.begin() + static_cast<std::ptrdiff_t>(to));
    }
    break;
  }
  return loop;
}

std::size_t InstructionLength(const std::uint8_t* code,
                              const std::uint8_t* next) {
  // A branch may have been taken to anywhere: its own length is in its code.
  std::size_t prefixes = 0;
  while (code[prefixes] == 0xF2 || code[prefixes] == 0xF3 ||
         code[prefixes] == 0x3E || code[prefixes] == 0x66) {
    ++prefixes;
  }
  const std::uint8_t* const opcode = code + prefixes;
  if ((opcode[0] >= 0x70 && opcode[0] <= 0x7F) || opcode[0] == 0xEB ||
      opcode[0] == 0xE3) {
    return prefixes + 2;  // a short jump
  }
  if (opcode[0] == 0xE8 || opcode[0] == 0xE9) return prefixes + 5;
  if (opcode[0] == 0x0F && opcode[1] >= 0x80 && opcode[1] <= 0x8F) {
    return prefixes + 6;
  }
  if (opcode[0] == 0xC3) return prefixes + 1;  // return
  if (opcode[0] == 0xFF && (opcode[1] == 0x25 || opcode[1] == 0x15)) {
    return prefixes + 6;  // by way of a table of addresses
  }
  constexpr std::ptrdiff_t kLongest = 15;
  const std::ptrdiff_t step = next - code;
  if (step > 0 && step <= kLongest) return static_cast<std::size_t>(step);
  return prefixes + 2;  // a jump to what a register holds
}

std::vector<std::string> InstructionBytes(const Trace& iteration) {
  std::vector<std::string> bytes;
  for (std::size_t i = 0; i < iteration.size(); ++i) {
    // NOLINTNEXTLINE(performance-no-int-to-ptr): addresses are what was traced
    const auto* code = reinterpret_cast<const std::uint8_t*>(iteration[i]);
    const std::uintptr_t after = iteration[(i + 1) % iteration.size()];
    const std::size_t length = InstructionLength(
        // NOLINTNEXTLINE(performance-no-int-to-ptr)
        code, reinterpret_cast<const std::uint8_t*>(after));
    std::string hex;
    for (std::size_t k = 0; k < length; ++k) {
      constexpr char kDigits[] = "0123456789abcdef";
      hex.push_back(kDigits[code[k] >> 4]);
      hex.push_back(kDigits[code[k] & 15]);
    }
    bytes.push_back(hex);
  }
  return bytes;
}

}  // namespace pitbench
