// The cases of tests/cases/real_world.csv: published bug reports and the small
// cases that show why a method fails, with their exact answers.
#ifndef PITBENCH_TESTS_REAL_WORLD_CASES_H_
#define PITBENCH_TESTS_REAL_WORLD_CASES_H_

#include <array>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

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

// Its columns are id,scalar,source,ax,ay,bx,by,cx,cy,px,py,truth,note.
inline std::vector<RealWorldCase> RealWorldCases() {
  std::ifstream file(PITBENCH_TESTS_DIR "/cases/real_world.csv");
  std::string line;
  std::getline(file, line);
  std::vector<RealWorldCase> cases;
  while (std::getline(file, line)) {
    std::vector<std::string> fields;
    std::stringstream stream(line);
    for (std::string field; std::getline(stream, field, ',');) {
      fields.push_back(field);
    }
    RealWorldCase& one = cases.emplace_back();
    one.id = fields.at(0);
    one.scalar = fields.at(1);
    one.truth = fields.at(11);
    for (std::size_t k = 0; k < 8; ++k) {
      one.at[k] = std::strtod(fields.at(3 + k).c_str(), nullptr);
    }
  }
  return cases;
}

}  // namespace pitbench

#endif  // PITBENCH_TESTS_REAL_WORLD_CASES_H_
