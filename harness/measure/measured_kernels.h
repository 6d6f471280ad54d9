// All that a build measures: the kernels, and with PITBENCH_PEERS=ON the calls
// into other libraries behind them.
#ifndef PITBENCH_HARNESS_MEASURE_MEASURED_KERNELS_H_
#define PITBENCH_HARNESS_MEASURE_MEASURED_KERNELS_H_

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <span>

#include "kernels/kernels.h"
#include "kernels/rays/ray_kernels.h"

namespace pitbench {

// AllKernels() and behind them the rows of the peers, if any.
std::span<const Kernel> MeasuredKernels();

// AllRayKernels() and behind them the rows of the peers, if any.
std::span<const RayKernel> MeasuredRayKernels();

// Whether a kernel may be timed as well as judged: not a peer that would build
// an index for every item.
bool MayBeTimed(const RayKernel& kernel);

// While one lives, a peer builds an index of triangles at its first call on
// them and keeps it: call it once on all that it is timed on. At most one.
class KeptIndexes {
 public:
  KeptIndexes();
  ~KeptIndexes();
  KeptIndexes(const KeptIndexes&) = delete;
  KeptIndexes& operator=(const KeptIndexes&) = delete;

 private:
  struct OfPeers;
  std::unique_ptr<OfPeers> of_peers_;
};

// Library → version of the peers; empty where there are none.
nlohmann::json PeerVersions();

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_MEASURED_KERNELS_H_
