#include "harness/measure/emulated_loops.h"

#include <elf.h>
#include <sys/wait.h>

#include <charconv>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace pitbench {
namespace {

constexpr std::size_t kCalls = 4;

// An ISA and the emulated CPU that its kernels run on.
struct Emulated {
  const char* isa;
  const char* cpu;
};
constexpr Emulated kEmulated[] = {
    {"neon", "max,sve=off"},
    {"sve", "max,sve-default-vector-length=32"},  // bytes
    {"sve2", "max,sve-default-vector-length=16"}};

[[noreturn]] void NotUnderstood(std::string_view line) {
  throw std::runtime_error("emulation of arm64: unexpected line '" +
                           std::string(line) + "'");
}

std::uintptr_t AddressIn(std::string_view line) {
  const std::size_t slash = line.find('/', line.find('['));
  std::uintptr_t address = 0;
  constexpr int kHex = 16;
  if (slash == std::string_view::npos ||
      std::from_chars(line.data() + slash + 1, line.data() + line.size(),
                      address, kHex)
              .ec != std::errc()) {
    NotUnderstood(line);
  }
  return address;
}

// A path as one word of a shell.
std::string Quoted(const std::string& path) {
  std::string quoted = "'";
  for (const char c : path) {
    if (c == '\'') {
      quoted += "'\\''";
    } else {
      quoted += c;
    }
  }
  return quoted + "'";
}

// The log of the kernels of one ISA; none if qemu-user is not installed.
std::optional<EmulationLog> Emulate(const std::string& program,
                                    const Emulated& emulated) {
  std::string command = "qemu-aarch64 -cpu ";
  command.append(emulated.cpu).append(" -singlestep -d exec,nochain ");
  command.append(Quoted(program)).append(" ").append(emulated.isa);
  command.append(" 2>&1");
  std::FILE* const pipe =
      popen(command.c_str(), "r");  // NOLINT(cert-env33-c): path is quoted
  if (pipe == nullptr) throw std::runtime_error("cannot start " + command);
  EmulationLog log;
  std::string last;
  std::string error;
  char* line = nullptr;
  std::size_t size = 0;
  for (ssize_t got = 0; (got = getline(&line, &size, pipe)) > 0;) {
    last.assign(line, static_cast<std::size_t>(got));
    while (!last.empty() && last.back() == '\n') last.pop_back();
    if (!error.empty()) continue;  // read on, so that the program can end
    try {
      log.Read(last);
    } catch (const std::runtime_error& e) {
      error = e.what();
    }
  }
  std::free(line);  // NOLINT(cppcoreguidelines-no-malloc): getline's
  const int status = pclose(pipe);
  constexpr int kNotFound = 127;
  if (WIFEXITED(status) && WEXITSTATUS(status) == kNotFound) return {};
  if (!error.empty()) throw std::runtime_error(error);
  if (status != 0) {
    throw std::runtime_error(command + " failed; it ended with: " + last);
  }
  return log;
}

nlohmann::json RowOf(const EmulatedKernel& kernel, std::string_view elf) {
  if (kernel.calls.size() != kCalls) {
    throw std::runtime_error("emulation of arm64: " + kernel.method +
                             " was not called as often as expected");
  }
  const SteadyLoop steady = FindSteadyLoop(kernel.calls[2], kernel.calls[3],
                                           kernel.n, kernel.calls[0].size());
  nlohmann::json iteration = nlohmann::json::array();
  for (const std::uintptr_t address : steady.iteration) {
    iteration.push_back(Arm64InstructionBytes(elf, address));
  }
  return {{"method", kernel.method},
          {"scalar", kernel.scalar},
          {"loop", "one_triangle"},
          {"isa", kernel.isa},
          {"vector_bits", kernel.vector_bits},
          {"per_call", steady.per_call},
          {"per_item", steady.per_item},
          {"items_per_iteration", steady.items},
          {"iteration", iteration}};
}

}  // namespace

void EmulationLog::Read(std::string_view line) {
  if (line.starts_with("Trace ")) {
    if (calling_) kernels_.back().calls.back().push_back(AddressIn(line));
  } else if (line.starts_with("kernel ") && !calling_) {
    EmulatedKernel kernel;
    std::string word;
    std::istringstream words{std::string(line)};
    words >> word >> kernel.method >> kernel.scalar >> kernel.isa >>
        kernel.vector_bits >> kernel.n;
    if (!words || kernel.n == 0) NotUnderstood(line);
    kernels_.push_back(std::move(kernel));
  } else if (line == "call" && !calling_ && !kernels_.empty()) {
    calling_ = true;
    kernels_.back().calls.emplace_back();
  } else if (line == "done" && calling_) {
    calling_ = false;
  } else {
    NotUnderstood(line);
  }
}

std::string Arm64InstructionBytes(std::string_view elf,
                                  std::uintptr_t address) {
  Elf64_Ehdr header;
  if (elf.size() < sizeof header || !elf.starts_with("\x7f\x45LF\x02")) {
    throw std::runtime_error("not a program of 64 bits");
  }
  std::memcpy(&header, elf.data(), sizeof header);
  constexpr std::size_t kBytes = 4;
  for (std::size_t i = 0; i < header.e_phnum; ++i) {
    Elf64_Phdr segment;
    const std::size_t at = header.e_phoff + i * sizeof segment;
    if (at + sizeof segment > elf.size()) break;
    std::memcpy(&segment, elf.data() + at, sizeof segment);
    if (segment.p_type != PT_LOAD || address < segment.p_vaddr ||
        address + kBytes > segment.p_vaddr + segment.p_filesz) {
      continue;
    }
    const std::size_t from = segment.p_offset + (address - segment.p_vaddr);
    if (from + kBytes > elf.size()) break;
    std::string hex;
    for (std::size_t k = 0; k < kBytes; ++k) {
      constexpr char kDigits[] = "0123456789abcdef";
      const auto byte = static_cast<unsigned char>(elf[from + k]);
      hex.push_back(kDigits[byte >> 4]);
      hex.push_back(kDigits[byte & 15]);
    }
    return hex;
  }
  throw std::runtime_error("the program has no code where it ran");
}

EmulatedLoops EmulateLoops(const std::string& program,
                           const NameFilter& filter) {
  EmulatedLoops loops{.rows = nlohmann::json::array(), .reason = ""};
  std::ifstream file(program, std::ios::binary);
  if (!file) {
    loops.reason =
        "the kernels were not cross-compiled for arm64 (needs "
        "aarch64-linux-gnu-g++)";
    return loops;
  }
  const std::string elf{std::istreambuf_iterator<char>(file), {}};
  for (const Emulated& emulated : kEmulated) {
    const std::optional<EmulationLog> log = Emulate(program, emulated);
    if (!log) {
      loops.rows.clear();
      loops.reason =
          "qemu-aarch64, which runs code for arm64, is not installed";
      return loops;
    }
    for (const EmulatedKernel& kernel : log->kernels()) {
      std::string name = "one_triangle/" + kernel.method;
      name.append("/").append(kernel.scalar).append("/").append(kernel.isa);
      if (filter.Finds(name)) {
        loops.rows.push_back(RowOf(kernel, elf));
      }
    }
  }
  return loops;
}

std::string Arm64CallsBesideThis() {
  std::error_code error;
  const auto self = std::filesystem::read_symlink("/proc/self/exe", error);
  return (self.parent_path() / "arm64_calls").string();
}

}  // namespace pitbench
