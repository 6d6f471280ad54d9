// What ray kernels call of Highway beyond the part that stands in for it where
// 2D kernels are counted (kernels/counting/highway_counting.h). Included before
// everything else where ray methods are compiled to be counted.
#ifndef PITBENCH_HARNESS_MEASURE_RAYS_COUNTING_HIGHWAY_FOR_RAYS_H_
#define PITBENCH_HARNESS_MEASURE_RAYS_COUNTING_HIGHWAY_FOR_RAYS_H_

#include "kernels/counting/highway_counting.h"

namespace hwy::N_COUNTING {

// A constant: the sign bit of each lane.
template <class D>
Vec<D> SignBit(D d) {
  return Set(d, TFromD<D>{-0.0});
}

}  // namespace hwy::N_COUNTING

#endif  // PITBENCH_HARNESS_MEASURE_RAYS_COUNTING_HIGHWAY_FOR_RAYS_H_
