// Vectors of exact numbers.
#ifndef PITBENCH_TESTS_RAYS_RATIONAL_VECTORS_H_
#define PITBENCH_TESTS_RAYS_RATIONAL_VECTORS_H_

#include <gmpxx.h>

#include <cmath>

#include "tests/rays/hard_rays.h"

namespace pitbench {

// The square root of a number as a double.
inline double Length(const mpq_class& squared) {
  return std::sqrt(squared.get_d());
}
inline RationalVector Minus(const RationalVector& a, const RationalVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline RationalVector Cross(const RationalVector& a, const RationalVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
          a[0] * b[1] - a[1] * b[0]};
}
inline mpq_class Dot(const RationalVector& a, const RationalVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace pitbench

#endif  // PITBENCH_TESTS_RAYS_RATIONAL_VECTORS_H_
