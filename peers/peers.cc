#include "peers/peers.h"

#include <vector>

#include "peers/libraries.h"

namespace pitbench {
namespace {

struct All {
  std::vector<Kernel> rows;
  std::vector<RayKernel> ray_rows;
  std::vector<PeerLibrary> libraries;

  All() {
    for (const auto add :
         {AddBoost, AddCgal, AddEigen, AddGeos, AddGlm, AddOpencv}) {
      libraries.push_back(add(rows));
    }
    AddCgalRays(ray_rows);
    libraries.push_back(AddEmbreeRays(ray_rows));
  }
};

const All& Everything() {
  static const All all;
  return all;
}

}  // namespace

std::span<const Kernel> PeerKernels() { return Everything().rows; }

std::span<const RayKernel> PeerRayKernels() { return Everything().ray_rows; }

std::span<const PeerLibrary> PeerLibraries() { return Everything().libraries; }

}  // namespace pitbench
