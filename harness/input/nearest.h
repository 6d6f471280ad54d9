// Suggestions for mistyped names.
#ifndef PITBENCH_HARNESS_INPUT_NEAREST_H_
#define PITBENCH_HARNESS_INPUT_NEAREST_H_

#include <string>
#include <string_view>
#include <vector>

namespace pitbench {

// The one of `names` with the smallest Levenshtein distance from `word`; the
// first of several. `names` must not be empty.
std::string_view Nearest(std::string_view word,
                         const std::vector<std::string_view>& names);

// "no method 'edge_funtion': did you mean 'edge_function'?"
std::string NoSuch(std::string_view kind, std::string_view word,
                   const std::vector<std::string_view>& names);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_INPUT_NEAREST_H_
