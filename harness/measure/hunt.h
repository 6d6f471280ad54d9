// The search for the inputs on which a method is most wrong.
//
// Random restarts from the hard distributions (points near an edge or a vertex,
// of well-shaped triangles, needles, and triangles that are small against their
// distance from the origin); then a climb: coordinates are moved by powers of
// two of ulps, and the wrong answer farthest from the boundary is kept.
//
// The distance is in ulps of the point's larger coordinate. So that it says how
// wrong a method is and not how small an ulp, inputs are confined: every
// coordinate is 0 or has a magnitude from 2^-30 to 1, and the point's larger
// one is at least 1/2.
#ifndef PITBENCH_HARNESS_MEASURE_HUNT_H_
#define PITBENCH_HARNESS_MEASURE_HUNT_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "harness/truth/truth.h"
#include "kernels/kernels.h"

namespace pitbench {

template <class T>
struct WrongInput {
  Triangle<T> triangle;
  Point<T> p;
  bool said_inside;
  Position truth;        // never kBoundary
  double distance_ulps;  // of p from the triangle's boundary
};

// The worst inputs that were found in about that time, the worst first, at most
// `keep`, each from another start. What is tried depends on `seed` alone; how
// much of it, on the time. Precondition: the kernel is one of loop pairs for T
// (float or double) and runs here.
template <class T>
std::vector<WrongInput<T>> Hunt(const Kernel& kernel, double seconds,
                                std::uint64_t seed, std::size_t keep);

// As a CSV file: the header
//   method,scalar,ax,ay,bx,by,cx,cy,px,py,said,truth,distance_ulps
// and a line for each input, or one with said = none_found if there is none.
// tests/worst_inputs.csv has such lines.
template <class T>
std::string HuntCsv(const Kernel& kernel,
                    const std::vector<WrongInput<T>>& found);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_HUNT_H_
