// The cases of tests/cases/real_world.csv: published bug reports and the small
// cases that show why a method fails, with their exact answers.
#ifndef PITBENCH_TESTS_REAL_WORLD_CASES_H_
#define PITBENCH_TESTS_REAL_WORLD_CASES_H_

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "harness/scenes/corpus.h"
#include "harness/truth/truth.h"

namespace pitbench {

struct RealWorldCase {
  std::string id, scalar, truth;
  std::array<double, 8> at;  // ax, ay, …, py

  // Whether T holds the coordinates exactly.
  template <class T>
  bool Fits() const {
    for (const double x : at) {
      if (static_cast<double>(static_cast<T>(x)) != x) return false;
    }
    return true;
  }
  template <class T>
  Triangle<T> TriangleAs() const {
    return {{static_cast<T>(at[0]), static_cast<T>(at[1])},
            {static_cast<T>(at[2]), static_cast<T>(at[3])},
            {static_cast<T>(at[4]), static_cast<T>(at[5])}};
  }
  template <class T>
  Point<T> PointAs() const {
    return {static_cast<T>(at[6]), static_cast<T>(at[7])};
  }
};

inline std::vector<RealWorldCase> RealWorldCases() {
  std::vector<RealWorldCase> cases;
  for (const CorpusCase& read : RealWorldCorpus()) {
    RealWorldCase& one = cases.emplace_back();
    one.id = read.id;
    one.scalar = read.scalar;
    one.truth = read.truth;
    for (std::size_t k = 0; k < one.at.size(); ++k) {
      one.at[k] = read.Number<double>(k);
    }
  }
  return cases;
}

}  // namespace pitbench

#endif  // PITBENCH_TESTS_REAL_WORLD_CASES_H_
