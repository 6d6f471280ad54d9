// Cases from published bug reports, built into the program.
#ifndef PITBENCH_HARNESS_SCENES_CORPUS_H_
#define PITBENCH_HARNESS_SCENES_CORPUS_H_

#include <array>
#include <string>
#include <vector>

#include "harness/input/csv.h"
#include "harness/truth/truth.h"

namespace pitbench {

// One case, its numbers as they are written.
struct CorpusCase {
  std::string id;
  std::string scalar;  // "f32" or "f64"
  std::string source;
  std::array<std::string, 8> at;  // ax, ay, bx, by, cx, cy, px, py
  std::string truth;  // the verdict on the numbers rounded to scalar

  template <class T>
  Triangle<T> TriangleAs() const {
    return {{Number<T>(0), Number<T>(1)},
            {Number<T>(2), Number<T>(3)},
            {Number<T>(4), Number<T>(5)}};
  }
  template <class T>
  Point<T> PointAs() const {
    return {Number<T>(6), Number<T>(7)};
  }
  // Rounded once to T; exact where T is mpq_class.
  template <class T>
  T Number(std::size_t k) const {
    return ParseNumber<T>(at[k]);
  }
};

// tests/cases/real_world.csv.
std::vector<CorpusCase> RealWorldCorpus();

// A case whose numbers somebody typed as decimals, and the verdict on those.
struct TypedCase : CorpusCase {
  std::string decimal_truth;
};

// tests/cases/typed_decimals.csv.
std::vector<TypedCase> TypedDecimals();

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_SCENES_CORPUS_H_
