#include "harness/measure/climb.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace pitbench {

std::string HuntLines(std::string_view method, std::string_view scalar,
                      std::string_view columns,
                      const std::vector<HuntRow>& rows) {
  std::string who(method);
  who.append(",").append(scalar).append(",");
  std::string csv = "method,scalar,";
  csv.append(columns).append(",said,truth,distance_ulps\n");
  if (rows.empty()) {
    const auto commas = std::count(columns.begin(), columns.end(), ',');
    csv += who + std::string(static_cast<std::size_t>(commas) + 1, ',') +
           "none_found,,\n";
  }
  const auto printed = [](const char* format, double value) {
    std::array<char, 40> buffer{};
    std::snprintf(buffer.data(), buffer.size(), format, value);
    return std::string(buffer.data());
  };
  for (const HuntRow& row : rows) {
    csv += who;
    for (const double x : row.coordinates) csv += printed("%a,", x);
    csv.append(row.said).append(",").append(row.truth).append(",");
    csv += printed("%.17g\n", row.distance_ulps);
  }
  return csv;
}

}  // namespace pitbench
