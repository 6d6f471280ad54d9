#include "harness/measure/clock.h"

#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <fstream>
#include <string>

namespace pitbench {
namespace {

// 64 additions, each waiting for the one before. Of two registers: additions
// of a constant are folded away by the renamers of recent Intel cores, several
// a cycle.
inline std::uint64_t Chain(std::uint64_t x) {
#if defined(__x86_64__)
  asm volatile(".rept 64\n\tadd %0, %0\n\t.endr" : "+r"(x)::"cc");
#elif defined(__aarch64__)
  asm volatile(".rept 64\n\tadd %0, %0, %0\n\t.endr" : "+r"(x)::"cc");
#else
#error "no dependent chain for this architecture"
#endif
  return x;
}

}  // namespace

double ClockGhz() {
  constexpr int kRounds = 20000;
  std::array<double, 15> samples{};
  std::uint64_t x = 0;
  for (double& sample : samples) {
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < kRounds; ++i) x = Chain(x);
    const std::chrono::duration<double, std::nano> time =
        std::chrono::steady_clock::now() - start;
    sample = 64.0 * kRounds / time.count();
  }
  std::sort(samples.begin(), samples.end());
  return samples[samples.size() / 2];
}

double StealSeconds() {
  std::ifstream stat("/proc/stat");
  std::string cpu;
  double user = 0, nice = 0, system = 0, idle = 0, wait = 0, irq = 0, soft = 0;
  double steal = 0;
  stat >> cpu >> user >> nice >> system >> idle >> wait >> irq >> soft >> steal;
  return stat ? steal / static_cast<double>(sysconf(_SC_CLK_TCK)) : 0;
}

int PinToLastCpu() {
  cpu_set_t allowed;
  CPU_ZERO(&allowed);
  if (sched_getaffinity(0, sizeof(allowed), &allowed) != 0) return -1;
  for (int cpu = CPU_SETSIZE - 1; cpu >= 0; --cpu) {
    if (!CPU_ISSET(cpu, &allowed)) continue;
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(cpu, &one);
    return sched_setaffinity(0, sizeof(one), &one) == 0 ? cpu : -1;
  }
  return -1;
}

}  // namespace pitbench
