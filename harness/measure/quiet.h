// Where and when nobody else uses the core.
//
// A neighbour on the other thread of a core takes ports and caches from us, and
// no clock, counter of the scheduler or steal time says so. But work that keeps
// all ports full gets less done in a cycle, so it is held against the best that
// was seen. That the clock itself goes up and down is seen as well.
//
// Where one CPU has a neighbour that stays, another may have none. So whoever
// has looked in vain for a while is moved on to the next CPU, of those that do
// the same: that share the last cache with the one this process is pinned to,
// and have the same highest clock.
#ifndef PITBENCH_HARNESS_MEASURE_QUIET_H_
#define PITBENCH_HARNESS_MEASURE_QUIET_H_

#include <string_view>
#include <vector>

#include "harness/measure/clock.h"

namespace pitbench {

enum class Quiet {
  kDisturbed,
  kSlower,  // alone, but the clock was faster once
  kYes
};

class QuietPlace {
 public:
  // Among the CPUs that are like the one that this process is pinned to.
  QuietPlace();

  // How quiet it is here and now; takes some 5 µs. May move to another CPU if
  // it is not.
  Quiet Look();

 private:
  std::vector<int> cpus_;
  std::size_t here_ = 0;
  int in_vain_ = 0;
  Pace best_;
};

// The numbers of a list as the kernel writes them: "0-3,8" is 0 1 2 3 8. Empty
// if it is none.
std::vector<int> CpusOfList(std::string_view list);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_QUIET_H_
