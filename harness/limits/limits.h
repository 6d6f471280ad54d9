// What this machine can do at most: bandwidth of each cache level and of
// memory, and arithmetic operations a second, for each ISA and scalar.
//
// Four things mislead.
//   - A limit is what the machine can do, so it is the best of the repetitions
//     and not their median: whatever disturbs makes a sample slower, nothing
//     makes it faster. The median is kept as well, to show how far apart.
//   - A disturbance lasts longer than a sample. A repetition is therefore cut
//     into slices, of which the best counts, and the repetitions of a probe are
//     spread over the whole measurement: all probes once, then all of them
//     again.
//   - How many arrays are read at once changes what the prefetchers deliver;
//     loads are measured with one, two and six, as the loops of the kernels
//     read them. The limit is the largest.
//   - Calls so long that a disturbance always falls into them are timed in
//     parts, and the fastest pass over each adds up to less than any pass took.
//     Sets as large are walked in such parts too, so that no row beats its
//     bound by the way in which it was timed; the limit is of the fastest pass
//     over each part in all repetitions.
#ifndef PITBENCH_HARNESS_LIMITS_LIMITS_H_
#define PITBENCH_HARNESS_LIMITS_LIMITS_H_

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "harness/input/name_filter.h"

namespace pitbench {

// A place where a working set may lie.
struct MemoryLevel {
  std::string name;      // "L1", "L2", …, "DRAM"
  std::size_t capacity;  // in bytes; 0: DRAM, which holds everything
  std::size_t probed;    // size of the set that is walked to measure it; whole
                         // steps (kMemoryStep) in each of kMostStreams arrays
};

// The levels of a machine by the sizes of its data caches, smallest first, and
// of its memory. Half of a cache is walked, but of the last level the geometric
// mean of its size and the one before, since of a cache that cores (or virtual
// machines) share nobody knows one's share; of memory four times the last
// level, within reason.
std::vector<MemoryLevel> MemoryLevels(const std::vector<std::size_t>& caches,
                                      std::size_t memory);

// The sizes of the data caches in machine.json's `cpu.caches`, in the order of
// their levels; those of common CPUs where the system does not tell.
std::vector<std::size_t> DataCaches(const nlohmann::json& caches);

// Measures the probes that run here and whose name (`add/f32/avx2`,
// `load/L1/avx2`) the filter finds. A repetition lasts about `seconds`. Returns
// the members `levels`, `memory` and `operations` of limits.json
// (harness/schema/limits.schema.json).
nlohmann::json MeasureLimits(const std::vector<MemoryLevel>& levels,
                             const NameFilter& filter, double seconds,
                             int repetitions);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_LIMITS_LIMITS_H_
