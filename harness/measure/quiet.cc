#include "harness/measure/quiet.h"

#include <sched.h>

#include <charconv>
#include <fstream>
#include <string>

#include "harness/measure/threads.h"

namespace pitbench {
namespace {

// With a neighbour a core does a tenth to two thirds less; where it has none,
// glances are within one percent.
constexpr double kAloneShare = 0.97;
// Clocks go in steps of a hundred megahertz or less.
constexpr double kFastClockShare = 0.98;
// Below this share of the best one it is no clock: the CPU was away.
constexpr double kLeastClockShare = 0.75;
// Some milliseconds, which is how long many disturbances last.
constexpr int kLooksBeforeMoving = 300;

std::string FirstLine(int cpu, const std::string& file) {
  std::ifstream in("/sys/devices/system/cpu/cpu" + std::to_string(cpu) + "/" +
                   file);
  std::string line;
  std::getline(in, line);
  return line;
}

// The CPUs that share the last cache with `cpu`; only itself if nobody knows.
std::vector<int> SharesLastCache(int cpu) {
  for (int index = 4; index >= 2; --index) {
    std::vector<int> cpus = CpusOfList(FirstLine(
        cpu, "cache/index" + std::to_string(index) + "/shared_cpu_list"));
    if (!cpus.empty()) return cpus;
  }
  return {cpu};
}

}  // namespace

std::vector<int> CpusOfList(std::string_view list) {
  std::vector<int> cpus;
  const char* at = list.data();
  const char* const end = at + list.size();
  while (at != end) {
    int first = 0;
    auto read = std::from_chars(at, end, first);
    if (read.ec != std::errc()) return {};
    int last = first;
    if (read.ptr != end && *read.ptr == '-') {
      read = std::from_chars(read.ptr + 1, end, last);
      if (read.ec != std::errc()) return {};
    }
    for (int cpu = first; cpu <= last; ++cpu) cpus.push_back(cpu);
    at = read.ptr;
    if (at != end && *at++ != ',') return {};
  }
  return cpus;
}

QuietPlace::QuietPlace() {
  const int home = sched_getcpu();
  const std::string clock = FirstLine(home, "cpufreq/cpuinfo_max_freq");
  cpus_.push_back(home);
  for (const int cpu : SharesLastCache(home)) {
    if (cpu != home && MayUse(cpu) &&
        FirstLine(cpu, "cpufreq/cpuinfo_max_freq") == clock) {
      cpus_.push_back(cpu);
    }
  }
}

Quiet QuietPlace::Look() {
  const Pace pace = GlancePace();
  best_ = Best(best_, pace);
  const double clock = pace.clock_ghz / best_.clock_ghz;
  const bool alone =
      clock >= kLeastClockShare &&
      pace.throughput_gops >= kAloneShare * clock * best_.throughput_gops;
  if (alone && clock >= kFastClockShare) {
    in_vain_ = 0;
    return Quiet::kYes;
  }
  if (++in_vain_ == kLooksBeforeMoving && cpus_.size() > 1) {
    in_vain_ = 0;
    here_ = (here_ + 1) % cpus_.size();
    Pin(cpus_[here_]);
  }
  return alone ? Quiet::kSlower : Quiet::kDisturbed;
}

}  // namespace pitbench
