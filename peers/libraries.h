// One function a library: adds its rows and gives its name and version.
#ifndef PITBENCH_PEERS_LIBRARIES_H_
#define PITBENCH_PEERS_LIBRARIES_H_

#include <vector>

#include "peers/peers.h"

namespace pitbench {

PeerLibrary AddBoost(std::vector<Kernel>& rows);
PeerLibrary AddCgal(std::vector<Kernel>& rows);
PeerLibrary AddEigen(std::vector<Kernel>& rows);
PeerLibrary AddGeos(std::vector<Kernel>& rows);
PeerLibrary AddGlm(std::vector<Kernel>& rows);
PeerLibrary AddOpencv(std::vector<Kernel>& rows);

// Rows of rays. CGAL tells its name and version with those of points.
void AddCgalRays(std::vector<RayKernel>& rows);
PeerLibrary AddEmbreeRays(std::vector<RayKernel>& rows);

}  // namespace pitbench

#endif  // PITBENCH_PEERS_LIBRARIES_H_
