// The tables of worst known inputs, of points and of rays.
#ifndef PITBENCH_TESTS_WORST_ROWS_H_
#define PITBENCH_TESTS_WORST_ROWS_H_

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "kernels/kernels.h"

namespace pitbench {

// The fields of a line, as the header of its file names them.
using Row = std::vector<std::string>;
using MethodAndScalar = std::pair<std::string, std::string>;
using Rows = std::multimap<MethodAndScalar, Row>;

// The lines of a file, which begin with method and scalar, by these.
inline Rows ReadWorstRows(const std::string& path, const std::string& header) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  EXPECT_EQ(line, header) << path;
  const auto fields_of_header = 1 + static_cast<std::size_t>(std::count(
                                        header.begin(), header.end(), ','));
  Rows rows;
  while (std::getline(file, line)) {
    Row row;
    std::istringstream fields(line + ",");
    for (std::string field; std::getline(fields, field, ',');) {
      row.push_back(field);
    }
    EXPECT_EQ(row.size(), fields_of_header) << line;
    if (row.size() == fields_of_header) {
      rows.emplace(std::pair{row[0], row[1]}, std::move(row));
    }
  }
  return rows;
}

// One row for every method and scalar of the kernels that need one, and no
// other.
template <class Kernels, class NeedsARow>
void ExpectOneRowAMethod(const Rows& rows, const Kernels& kernels,
                         const NeedsARow& needs_a_row) {
  std::set<MethodAndScalar> needed;
  for (const auto& kernel : kernels) {
    if (!needs_a_row(kernel)) continue;
    needed.emplace(kernel.method.key, Name(kernel.scalar));
  }
  EXPECT_FALSE(needed.empty());
  for (const MethodAndScalar& key : needed) {
    EXPECT_EQ(rows.count(key), 1u) << key.first << " " << key.second;
  }
  for (const auto& [key, row] : rows) {
    EXPECT_TRUE(needed.contains(key))
        << key.first << " " << key.second << " is no method that needs a row";
  }
}

}  // namespace pitbench

#endif  // PITBENCH_TESTS_WORST_ROWS_H_
