#include "harness/measure/occupancy.h"

#include <sys/resource.h>

namespace pitbench {
namespace {

rusage Usage() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage;
}

double CpuSeconds(const rusage& usage) {
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) +
           1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

}  // namespace

OccupancyMeter::OccupancyMeter() : start_(std::chrono::steady_clock::now()) {
  const rusage usage = Usage();
  cpu_seconds_ = CpuSeconds(usage);
  preemptions_ = usage.ru_nivcsw;
}

Occupancy OccupancyMeter::Read() const {
  const rusage usage = Usage();
  const std::chrono::duration<double> wall =
      std::chrono::steady_clock::now() - start_;
  return {wall.count(), CpuSeconds(usage) - cpu_seconds_,
          usage.ru_nivcsw - preemptions_};
}

}  // namespace pitbench
