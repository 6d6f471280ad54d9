// Rays from published bug reports, built into the program.
#ifndef PITBENCH_HARNESS_SCENES_RAYS_RAY_CORPUS_H_
#define PITBENCH_HARNESS_SCENES_RAYS_RAY_CORPUS_H_

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "harness/input/csv.h"
#include "harness/truth/ray_truth.h"

namespace pitbench {

// One case, its numbers as they are written.
struct RayCase {
  std::string id;
  std::string scalar;  // "f32" or "f64"
  std::string source;
  std::array<std::string, 15> at;  // A, B, C, origin, direction
  std::string truth;  // the verdict on the numbers rounded to scalar, t ≥ 0

  template <class T>
  Triangle3<T> TriangleAs() const {
    return {PointAs<T>(0), PointAs<T>(1), PointAs<T>(2)};
  }
  template <class T>
  Ray<T> RayAs() const {
    return {PointAs<T>(3), PointAs<T>(4), 0,
            std::numeric_limits<T>::infinity()};
  }

 private:
  template <class T>
  Point3<T> PointAs(std::size_t k) const {
    return {ParseNumber<T>(at[3 * k]), ParseNumber<T>(at[3 * k + 1]),
            ParseNumber<T>(at[3 * k + 2])};
  }
};

// tests/cases/rays.csv.
std::vector<RayCase> RayCorpus();

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_SCENES_RAYS_RAY_CORPUS_H_
