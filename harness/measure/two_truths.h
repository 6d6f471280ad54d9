// Two truths: the exact verdict on the binary numbers that a program got, and
// on the decimals that somebody typed.
#ifndef PITBENCH_HARNESS_MEASURE_TWO_TRUTHS_H_
#define PITBENCH_HARNESS_MEASURE_TWO_TRUTHS_H_

#include <nlohmann/json_fwd.hpp>

namespace pitbench {

// [{"id", "source", "scalar", "binary", "decimal"}] for the cases of
// tests/cases/typed_decimals.csv, computed now. "binary" and "decimal" are
// "inside", "boundary", "outside" or "degenerate".
nlohmann::json TwoTruths();

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_TWO_TRUTHS_H_
