#include "harness/limits/limits.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "harness/limits/probes.h"
#include "harness/measure/parts.h"
#include "harness/measure/slices.h"
#include "harness/scenes/scene.h"

namespace pitbench {
namespace {

using nlohmann::json;

constexpr std::size_t kMostStreams = 6;

// One row to be: a loop that does `rounds` rounds and returns how much it did.
struct Job {
  json row;
  std::string quantity;  // the unit of what is done, for the row
  std::function<double(std::size_t)> run;
  std::size_t rounds = 1;
  bool warm = true;  // whether a few rounds go ahead of each sample
  std::vector<double> samples = {};
  // Of what is long: times one pass, part by part, and does so much in it.
  std::function<void(std::vector<double>&)> time_parts = nullptr;
  double done_in_parts = 0;
  PartTimes all_passes = {};
};

double SecondsOf(const Job& job, std::size_t rounds, double& done) {
  const auto start = std::chrono::steady_clock::now();
  done = job.run(rounds);
  const std::chrono::duration<double> time =
      std::chrono::steady_clock::now() - start;
  return std::max(time.count(), 1e-9);
}

// As rows are timed whose calls are long: the fastest pass over each part. They
// pass as often again where it is not quiet, as far as their patience goes.
void SampleParts(Job& job, double seconds) {
  const double patient = SliceBudget{.seconds = seconds}.patience * seconds;
  std::vector<double> parts;
  PartTimes own;
  do {
    job.time_parts(parts);
    own.AddPass(parts);
    job.all_passes.AddPass(parts);
  } while (own.Passes() < PassesOfParts(own.Fastest(), patient));
  job.samples.push_back(job.done_in_parts / own.Fastest());
}

// Finds how many rounds last `seconds`.
void Calibrate(Job& job, double seconds) {
  if (job.time_parts) return;
  double done = 0;
  for (;;) {
    const double time = SecondsOf(job, job.rounds, done);
    if (time >= seconds / 2) {
      job.rounds = static_cast<std::size_t>(
          std::ceil(static_cast<double>(job.rounds) * seconds / time));
      return;
    }
    job.rounds *= 2;
  }
}

// The best of slices that together last `seconds`.
void Sample(Job& job, double seconds) {
  if (job.time_parts) {
    SampleParts(job, seconds);
    return;
  }
  double done = 0;
  if (job.warm) SecondsOf(job, job.rounds / 8 + 1, done);
  double best = 0;
  for (double sum = 0; sum < 0.75 * seconds;) {
    const double time = SecondsOf(job, job.rounds, done);
    best = std::max(best, done / time);
    sum += time;
  }
  job.samples.push_back(best);
}

json Finished(Job& job) {
  std::sort(job.samples.begin(), job.samples.end());
  job.row[job.quantity] = job.time_parts
                              ? job.done_in_parts / job.all_passes.Fastest()
                              : job.samples.back();
  job.row["median"] = job.samples[job.samples.size() / 2];
  job.row["lowest"] = job.samples.front();
  return job.row;
}

std::string ProbeName(std::string_view what, std::string_view where,
                      std::string_view isa) {
  std::string name(what);
  name.append("/").append(where).append("/").append(isa);
  return name;
}

std::vector<Job> OperationJobs(const NameFilter& filter) {
  std::vector<Job> jobs;
  for (const OperationProbe& probe : OperationProbes()) {
    if (!RunsHere(probe.isa)) continue;
    if (!filter.Finds(
            ProbeName(Name(probe.operation), probe.scalar, Name(probe.isa)))) {
      continue;
    }
    jobs.push_back({.row = {{"isa", Name(probe.isa)},
                            {"scalar", probe.scalar},
                            {"operation", Name(probe.operation)}},
                    .quantity = "operations_per_second",
                    .run = [run = probe.run](std::size_t rounds) {
                      return static_cast<double>(run(rounds));
                    }});
  }
  return jobs;
}

constexpr std::size_t kWholeStep = kMemoryStep * kMostStreams;
constexpr std::size_t kPart = kBytesOfShortestPart / kWholeStep * kWholeStep;

// Walks over so many bytes in parts no longer than those of any call.
std::function<void(std::vector<double>&)> WalkInParts(const MemoryProbe& probe,
                                                      std::byte* memory,
                                                      std::size_t bytes) {
  return [run = probe.run, memory, bytes](std::vector<double>& seconds) {
    seconds.clear();
    for (std::size_t at = 0; at < bytes; at += kPart) {
      const auto start = std::chrono::steady_clock::now();
      run(memory + at, std::min(kPart, bytes - at), 1);
      const std::chrono::duration<double> time =
          std::chrono::steady_clock::now() - start;
      seconds.push_back(time.count());
    }
  };
}

// Every level is loaded from; only the first is stored to, as the kernels
// write a bit or a few bytes where they read many.
std::vector<Job> MemoryJobs(const NameFilter& filter,
                            const std::vector<MemoryLevel>& levels,
                            Array<std::byte>& memory) {
  std::vector<Job> jobs;
  for (const MemoryProbe& probe : MemoryProbes()) {
    if (!RunsHere(probe.isa)) continue;
    for (const MemoryLevel& level : levels) {
      if (probe.access == Access::kStore && &level != &levels.front()) continue;
      if (!filter.Finds(
              ProbeName(Name(probe.access), level.name, Name(probe.isa)))) {
        continue;
      }
      jobs.push_back({.row = {{"isa", Name(probe.isa)},
                              {"scalars", probe.scalars},
                              {"level", level.name},
                              {"access", Name(probe.access)},
                              {"streams", probe.streams}},
                      .quantity = "bytes_per_second",
                      .run =
                          [run = probe.run, bytes = level.probed,
                           at = memory.data()](std::size_t rounds) {
                            run(at, bytes, rounds);
                            return static_cast<double>(bytes) *
                                   static_cast<double>(rounds);
                          },
                      .warm = level.capacity != 0});
      if (static_cast<double>(level.probed) >= kBytesOfLongCall) {
        jobs.back().time_parts =
            WalkInParts(probe, memory.data(), level.probed);
        jobs.back().done_in_parts = static_cast<double>(level.probed);
      }
    }
  }
  return jobs;
}

}  // namespace

std::vector<MemoryLevel> MemoryLevels(const std::vector<std::size_t>& caches,
                                      std::size_t memory) {
  const auto whole_steps = [](double bytes) {
    return std::max(static_cast<std::size_t>(bytes) / kWholeStep,
                    std::size_t{1}) *
           kWholeStep;
  };
  std::vector<MemoryLevel> levels;
  for (std::size_t k = 0; k < caches.size(); ++k) {
    const auto own = static_cast<double>(caches[k]);
    const bool shared = k >= 2 && k + 1 == caches.size();
    const double probed =
        shared ? std::sqrt(own * static_cast<double>(caches[k - 1])) : own / 2;
    std::string name = "L";
    name += std::to_string(k + 1);
    levels.push_back({name, caches[k], whole_steps(probed)});
  }
  constexpr std::size_t kMebi = std::size_t{1} << 20;
  const std::size_t last = caches.empty() ? 0 : caches.back();
  const std::size_t most = std::min(memory / 4, 256 * kMebi);
  const std::size_t walked =
      std::min(std::max(4 * last, 64 * kMebi), std::max(most, 2 * last));
  levels.push_back({"DRAM", 0, whole_steps(static_cast<double>(walked))});
  return levels;
}

std::vector<std::size_t> DataCaches(const json& caches) {
  std::map<int, std::size_t> sizes;
  for (const json& cache : caches) {
    if (cache.at("type") == "Instruction") continue;
    sizes[cache.at("level").get<int>()] = cache.at("bytes").get<std::size_t>();
  }
  if (sizes.empty()) return {32 << 10, 1 << 20, 16 << 20};
  std::vector<std::size_t> found;
  found.reserve(sizes.size());
  for (const auto& [level, bytes] : sizes) found.push_back(bytes);
  return found;
}

json MeasureLimits(const std::vector<MemoryLevel>& levels,
                   const NameFilter& filter, double seconds, int repetitions) {
  std::size_t most = 0;
  json places = json::array();
  for (const MemoryLevel& level : levels) {
    most = std::max(most, level.probed);
    places.push_back(
        {{"name", level.name},
         {"capacity_bytes",
          level.capacity == 0 ? json(nullptr) : json(level.capacity)},
         {"probed_bytes", level.probed}});
  }
  Array<std::byte> memory(most);
  std::vector<Job> operations = OperationJobs(filter);
  std::vector<Job> walks = MemoryJobs(filter, levels, memory);
  for (std::vector<Job>* jobs : {&operations, &walks}) {
    for (Job& job : *jobs) Calibrate(job, std::min(seconds, kSliceSeconds));
  }
  for (int k = 0; k < repetitions; ++k) {
    for (std::vector<Job>* jobs : {&operations, &walks}) {
      for (Job& job : *jobs) Sample(job, seconds);
    }
  }
  json result = {{"levels", places},
                 {"memory", json::array()},
                 {"operations", json::array()}};
  for (Job& job : walks) result["memory"].push_back(Finished(job));
  for (Job& job : operations) result["operations"].push_back(Finished(job));
  return result;
}

}  // namespace pitbench
