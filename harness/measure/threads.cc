#include "harness/measure/threads.h"

#include <sched.h>

namespace pitbench {
namespace {

// The CPUs in descending order. Asked before main, since the process is pinned
// to one of them later.
std::vector<int> Allowed() {
  std::vector<int> cpus;
  cpu_set_t allowed;
  CPU_ZERO(&allowed);
  if (sched_getaffinity(0, sizeof(allowed), &allowed) != 0) return {0};
  for (int cpu = CPU_SETSIZE - 1; cpu >= 0; --cpu) {
    if (CPU_ISSET(cpu, &allowed)) cpus.push_back(cpu);
  }
  return cpus;
}

const std::vector<int> kAllowedCpus = Allowed();  // NOLINT(cert-err58-cpp)

}  // namespace

std::vector<int> ThreadCounts() {
  const int all = static_cast<int>(kAllowedCpus.size());
  std::vector<int> counts;
  for (int count = 1; count < all; count *= 2) counts.push_back(count);
  counts.push_back(all);
  return counts;
}

void PinThread(int index) {
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(kAllowedCpus[static_cast<std::size_t>(index)], &one);
  sched_setaffinity(0, sizeof(one), &one);
}

Call PartOf(const Call& call, std::size_t index, std::size_t count) {
  constexpr std::size_t kStep = 64;
  const auto begin = [&](std::size_t k) {
    return k == count ? call.n : call.n * k / count / kStep * kStep;
  };
  const std::size_t first = begin(index);
  return {call.triangle, call.point + first, begin(index + 1) - first};
}

}  // namespace pitbench
