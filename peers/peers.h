// What people use today, behind the same function pointers: calls into other
// libraries that decide whether a point is in a triangle, so that they are
// timed and judged as the kernels of pitbench are.
//
// A row is one call × scalar × loop, its ISA is Isa::kLibrary. Where a library
// builds something before it can be asked (a ring, an index), that is set-up:
// once a call in loop one_triangle, once an item in one_point and pairs. The
// contract of kernels/README.md holds for what is read and written; a library
// may allocate, and what it throws is caught and counts as outside.
//
// Rows of rays are the same, but that a scene in which a library looks
// triangles up can be kept (KeptScenes), so that building it is not timed, and
// that they are asked about one range of t alone: from 0 to infinity, as scenes
// have it.
#ifndef PITBENCH_PEERS_PEERS_H_
#define PITBENCH_PEERS_PEERS_H_

#include <span>
#include <string>
#include <string_view>

#include "kernels/kernels.h"
#include "kernels/rays/ray_kernels.h"

namespace pitbench {

struct PeerLibrary {
  std::string_view name;  // the keys of its rows begin with this
  std::string version;
};

// The rows of all libraries, one library after the other. They outlive main().
std::span<const Kernel> PeerKernels();

std::span<const RayKernel> PeerRayKernels();

std::span<const PeerLibrary> PeerLibraries();

// Whether a kernel builds a scene to look triangles up in; in loop ray_pairs it
// builds one an item and keeps none.
bool BuildsScenes(const RayKernel& kernel);

// While one lives, the scenes that are built are kept, and found again by the
// address of their triangles, which must not change meanwhile. Not more than
// one at a time, and not for several threads.
class KeptScenes {
 public:
  KeptScenes();
  ~KeptScenes();
  KeptScenes(const KeptScenes&) = delete;
  KeptScenes& operator=(const KeptScenes&) = delete;
};

}  // namespace pitbench

#endif  // PITBENCH_PEERS_PEERS_H_
