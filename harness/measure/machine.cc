#include "harness/measure/machine.h"

#include <gmp.h>
#include <hwy/highway.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <utility>

#include "harness/measure/measured_kernels.h"
#include "kernels/kernels.h"

namespace pitbench {
namespace {

using nlohmann::json;

struct KernelFlags {
  const char* file;
  const char* set;
  const char* flags;
};
#include "build_info.inc"

const std::filesystem::path kCpus = "/sys/devices/system/cpu";

// The first line of a file, or nothing.
std::optional<std::string> Line(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line)) return std::nullopt;
  return line;
}

json OrNull(const std::optional<std::string>& text) {
  return text ? json(*text) : json(nullptr);
}

// The value of the first `key : value` line of /proc/cpuinfo.
std::optional<std::string> CpuInfo(const std::string& key) {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(':');
    if (colon == std::string::npos) continue;
    const std::size_t end = line.find_last_not_of(" \t", colon - 1) + 1;
    if (line.compare(0, end, key) != 0) continue;
    const std::size_t value = line.find_first_not_of(" \t", colon + 1);
    if (value != std::string::npos) return line.substr(value);
  }
  return std::nullopt;
}

// How many CPUs a list such as "0-3,8" names.
int CountCpus(const std::string& list) {
  int count = 0;
  std::stringstream ranges(list);
  for (std::string range; std::getline(ranges, range, ',');) {
    const std::size_t dash = range.find('-');
    const int first = std::stoi(range);
    const int last =
        dash == std::string::npos ? first : std::stoi(range.substr(dash + 1));
    count += last - first + 1;
  }
  return count;
}

json Caches() {
  json caches = json::array();
  for (int k = 0;; ++k) {
    const auto index = kCpus / "cpu0/cache" / ("index" + std::to_string(k));
    const auto size = Line(index / "size");
    const auto level = Line(index / "level");
    if (!size || !level) return caches;
    const std::int64_t unit = size->back() == 'K'   ? 1 << 10
                              : size->back() == 'M' ? 1 << 20
                                                    : 1;
    caches.push_back(
        {{"level", std::stoi(*level)},
         {"type", Line(index / "type").value_or("Unified")},
         {"bytes", std::stoll(*size) * unit},
         {"shared_by",
          CountCpus(Line(index / "shared_cpu_list").value_or("0"))}});
  }
}

// The number of different (package, core) pairs among the CPUs.
int Cores() {
  std::set<std::pair<std::string, std::string>> cores;
  for (int cpu = 0;; ++cpu) {
    const auto topology = kCpus / ("cpu" + std::to_string(cpu)) / "topology";
    const auto core = Line(topology / "core_id");
    if (!core) break;
    cores.emplace(Line(topology / "physical_package_id").value_or("0"), *core);
  }
  return std::max(1, static_cast<int>(cores.size()));
}

// The numbers by which the CPU identifies itself: names do not tell CPUs of
// different designs apart, least of all those of virtual machines.
json Identity() {
#if defined(__aarch64__)
  const auto vendor = CpuInfo("CPU implementer");
  const std::array keys = {"CPU architecture", "CPU part", "CPU revision"};
#else
  const auto vendor = CpuInfo("vendor_id");
  const std::array keys = {"cpu family", "model", "stepping"};
#endif
  std::array<std::int64_t, 3> numbers{};
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const auto text = CpuInfo(keys[k]);
    if (!vendor || !text) return nullptr;
    try {
      numbers[k] = std::stoll(*text, nullptr, 0);
    } catch (const std::exception&) {
      return nullptr;  // "unknown"
    }
  }
  return {{"vendor", *vendor},
          {"family", numbers[0]},
          {"model", numbers[1]},
          {"stepping", numbers[2]}};
}

json Cpu() {
  const std::string flags = CpuInfo("flags").value_or("");
  const bool is_virtual =
      (" " + flags + " ").find(" hypervisor ") != std::string::npos;
  const auto smt = Line(kCpus / "smt/active");
  json isas = json::array();
  for (int k = 0; k <= static_cast<int>(Isa::kSve2); ++k) {
    const auto isa = static_cast<Isa>(k);
    if (RunsHere(isa)) isas.push_back(Name(isa));
  }
  return {
      {"model",
       CpuInfo("model name").value_or(CpuInfo("CPU part").value_or("unknown"))},
      {"identity", Identity()},
      {"microcode", CpuInfo("microcode").value_or("unknown")},
      {"cores", Cores()},
      {"threads", std::max<long>(1, sysconf(_SC_NPROCESSORS_ONLN))},
      {"smt", smt ? json(*smt == "1") : json(nullptr)},
      {"governor", OrNull(Line(kCpus / "cpu0/cpufreq/scaling_governor"))},
      {"virtual", is_virtual},
      {"hypervisor", OrNull(Line("/sys/class/dmi/id/sys_vendor"))},
      {"caches", Caches()},
      {"isas", isas}};
}

json System() {
  utsname name{};
  uname(&name);
  std::string distribution = "unknown";
  std::ifstream file("/etc/os-release");
  for (std::string line; std::getline(file, line);) {
    constexpr std::string_view kKey = "PRETTY_NAME=\"";
    if (line.starts_with(kKey) && line.ends_with('"')) {
      distribution = line.substr(kKey.size(), line.size() - kKey.size() - 1);
    }
  }
  return {{"kernel", std::string(name.sysname) + " " + name.release},
          {"distribution", distribution}};
}

json Flags() {
  json flags = json::object();
  for (const KernelFlags& one : kFlags) flags[one.file][one.set] = one.flags;
  return flags;
}

}  // namespace

std::string_view Revision() { return kRevision; }
bool Dirty() { return kDirty; }
std::string_view KernelHash() { return kKernelHash; }

json DescribeMachine(std::uint64_t seed) {
  const std::string highway = std::to_string(HWY_MAJOR) + "." +
                              std::to_string(HWY_MINOR) + "." +
                              std::to_string(HWY_PATCH);
  json libraries = {{"highway", highway},
                    {"eigen", PITBENCH_EIGEN_VERSION},
                    {"gmp", gmp_version}};
  libraries.update(PeerVersions());
  return {
      {"schema", "pitbench-machine-1"},
      {"cpu", Cpu()},
      {"os", System()},
      {"compiler",
       {{"id", PITBENCH_COMPILER},
        {"version", PITBENCH_COMPILER_VERSION},
        {"flags", Flags()}}},
      {"libraries", libraries},
      {"revision", Revision()},
      {"dirty", Dirty()},
      {"kernel_hash", KernelHash()},
      {"seed", seed},
      {"memory_bytes", static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) *
                           static_cast<std::uint64_t>(sysconf(_SC_PAGE_SIZE))}};
}

}  // namespace pitbench
