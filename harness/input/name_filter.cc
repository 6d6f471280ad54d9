#include "harness/input/name_filter.h"

#include <regex>

#include "harness/input/csv.h"

namespace pitbench {

struct NameFilter::Expression {
  std::regex regex;
};

NameFilter::NameFilter(const std::string& expression) {
  try {
    expression_ =
        std::make_shared<Expression>(Expression{std::regex(expression)});
  } catch (const std::regex_error& error) {
    throw InputError("--filter '" + expression +
                     "' is not a regular expression: " + error.what());
  }
}

bool NameFilter::Finds(const std::string& name) const {
  return std::regex_search(name, expression_->regex);
}

}  // namespace pitbench
