// The scenes of the profiles that show what the input does to speed: how many
// points are inside, how many there are, and how many CPUs share them. Few
// kernels meet them: those that differ there.
#ifndef PITBENCH_HARNESS_MEASURE_INPUT_SCENES_H_
#define PITBENCH_HARNESS_MEASURE_INPUT_SCENES_H_

#include <initializer_list>
#include <string>
#include <vector>

#include "harness/measure/cells.h"

namespace pitbench {

// Hit rates, in percent, for the kernels with and without a way out after each
// edge: whether branches pay. `sets`: fresh, fixed, or both.
void AddHitRates(std::vector<ProfileScene>& scenes, Scalar scalar,
                 std::initializer_list<int> percents,
                 std::initializer_list<const char*> sets);

// Calls of this many points: from where on a set-up pays.
void AddSizes(std::vector<ProfileScene>& scenes, Scalar scalar,
              const std::vector<std::int64_t>& sizes, const char* sets);

// Points with x and y side by side: the scenes named, which other cells of the
// profile ask of loop one_triangle.
void AddSideBySide(std::vector<ProfileScene>& scenes, Scalar scalar,
                   const std::vector<std::string>& names);

// Calls that read so many bytes, more than the caches hold, by 1 to all CPUs.
void AddThreads(std::vector<ProfileScene>& scenes, Scalar scalar,
                const char* bytes);

// 2^first, 2^(first + step), …, 2^last.
std::vector<std::int64_t> PointCounts(int first, int last, int step);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_INPUT_SCENES_H_
