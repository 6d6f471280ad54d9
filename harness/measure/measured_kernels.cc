#include "harness/measure/measured_kernels.h"

#include <nlohmann/json.hpp>
#include <vector>

#ifdef PITBENCH_PEERS
#include "peers/peers.h"
#endif

namespace pitbench {

#ifdef PITBENCH_PEERS
namespace {

template <class KernelType>
std::vector<KernelType> Joined(std::span<const KernelType> own,
                               std::span<const KernelType> peers) {
  std::vector<KernelType> joined(own.begin(), own.end());
  joined.insert(joined.end(), peers.begin(), peers.end());
  return joined;
}

}  // namespace

struct KeptIndexes::OfPeers {
  KeptScenes scenes;
};

KeptIndexes::KeptIndexes() : of_peers_(std::make_unique<OfPeers>()) {}

std::span<const Kernel> MeasuredKernels() {
  static const auto all = Joined(AllKernels(), PeerKernels());
  return all;
}

std::span<const RayKernel> MeasuredRayKernels() {
  static const auto all = Joined(AllRayKernels(), PeerRayKernels());
  return all;
}

bool MayBeTimed(const RayKernel& kernel) {
  return kernel.loop != RayLoop::kRayPairs || !BuildsScenes(kernel);
}
#else
struct KeptIndexes::OfPeers {};

KeptIndexes::KeptIndexes() = default;

std::span<const Kernel> MeasuredKernels() { return AllKernels(); }

std::span<const RayKernel> MeasuredRayKernels() { return AllRayKernels(); }

bool MayBeTimed(const RayKernel& /*kernel*/) { return true; }
#endif

KeptIndexes::~KeptIndexes() = default;

nlohmann::json PeerVersions() {
  nlohmann::json versions = nlohmann::json::object();
#ifdef PITBENCH_PEERS
  for (const PeerLibrary& library : PeerLibraries()) {
    versions[library.name] = library.version;
  }
#endif
  return versions;
}

}  // namespace pitbench
