#include "harness/input/nearest.h"

#include <algorithm>
#include <numeric>

namespace pitbench {
namespace {

std::size_t Levenshtein(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string_view Nearest(std::string_view word,
                         const std::vector<std::string_view>& names) {
  return *std::min_element(names.begin(), names.end(),
                           [word](std::string_view a, std::string_view b) {
                             return Levenshtein(word, a) < Levenshtein(word, b);
                           });
}

std::string NoSuch(std::string_view kind, std::string_view word,
                   const std::vector<std::string_view>& names) {
  std::string message = "no ";
  message.append(kind).append(" '").append(word).append("': did you mean '");
  message.append(Nearest(word, names)).append("'?");
  return message;
}

}  // namespace pitbench
