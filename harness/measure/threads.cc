#include "harness/measure/threads.h"

#include <sched.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

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

bool MayUse(int cpu) {
  return std::find(kAllowedCpus.begin(), kAllowedCpus.end(), cpu) !=
         kAllowedCpus.end();
}

bool Pin(int cpu) {
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(cpu, &one);
  return sched_setaffinity(0, sizeof(one), &one) == 0;
}

int PinToLastCpu() {
  const int last = kAllowedCpus.front();
  return Pin(last) ? last : -1;
}

double SecondsOfThreads(std::size_t threads,
                        const std::function<void(std::size_t)>& work) {
  using Time = std::chrono::steady_clock::time_point;
  std::vector<Time> starts(threads);
  std::vector<Time> ends(threads);
  std::atomic<std::size_t> missing = threads;
  const auto run = [&](std::size_t thread) {
    Pin(kAllowedCpus[thread]);
    // Waits awake: to be woken would take longer than short work.
    missing.fetch_sub(1);
    while (missing.load() != 0) {
    }
    starts[thread] = std::chrono::steady_clock::now();
    work(thread);
    ends[thread] = std::chrono::steady_clock::now();
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t k = 1; k < threads; ++k) others.emplace_back(run, k);
    run(0);
  }
  const std::chrono::duration<double> time =
      *std::max_element(ends.begin(), ends.end()) -
      *std::min_element(starts.begin(), starts.end());
  return time.count();
}

Call PartOf(const Call& call, Loop loop, std::size_t index, std::size_t count) {
  constexpr std::size_t kStep = 64;
  const auto begin = [&](std::size_t k) {
    return k == count ? call.n : call.n * k / count / kStep * kStep;
  };
  const std::size_t first = begin(index);
  const bool triangles = loop == Loop::kOnePoint || loop == Loop::kPairs;
  return {call.triangle + (triangles ? first : 0),
          call.point + (loop == Loop::kOnePoint ? 0 : first),
          begin(index + 1) - first};
}

}  // namespace pitbench
