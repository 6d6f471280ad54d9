// How wrong the weights are that a kernel writes.
#ifndef PITBENCH_HARNESS_MEASURE_WEIGHT_ERRORS_H_
#define PITBENCH_HARNESS_MEASURE_WEIGHT_ERRORS_H_

#include <gmpxx.h>

#include <array>
#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "harness/measure/answers.h"

namespace pitbench {

// An answer whose weights are known exactly.
struct WeighedAnswer {
  std::size_t call;
  std::size_t answer;
  std::array<mpq_class, 3> weights;
  // ax, ay, bx, by, cx, cy, px, py in units of 2^exponent, and an ulp of the
  // point's coordinate of larger magnitude.
  std::array<mpz_class, 8> coordinates;
  int exponent;
  int ulp_exponent;
};

// The first answers of each call, some 512 in all, that have weights: finite
// and of a triangle with an area.
template <class T>
std::vector<WeighedAnswer> WeighAnswers(const Scene<T>& scene);

// "weights" of harness/schema/accuracy.schema.json.
template <class T>
nlohmann::json WeightErrors(const Answers<T>& answers,
                            const std::vector<WeighedAnswer>& weighed);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_WEIGHT_ERRORS_H_
