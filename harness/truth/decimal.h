// Numbers exactly as they are written, for the second truth: what somebody who
// typed decimals meant, beside what the program got after rounding them.
#ifndef PITBENCH_HARNESS_TRUTH_DECIMAL_H_
#define PITBENCH_HARNESS_TRUTH_DECIMAL_H_

#include <gmpxx.h>

#include <optional>
#include <string_view>

namespace pitbench {

// Exponents are limited, so that a line of text cannot ask for all memory.
inline constexpr int kLargestExponent = 9999;

// The number that `text` writes, without rounding: decimal (-12.5, .1, 1e-3) or
// hexadecimal (0x1.8p-3), as strtod reads it. Nothing for anything else
// (blanks, nan and inf included), or where the exponent is above
// kLargestExponent or below its negative.
std::optional<mpq_class> ParseExactly(std::string_view text);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_TRUTH_DECIMAL_H_
