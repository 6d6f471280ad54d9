// Which names a regular expression of the command line chooses.
#ifndef PITBENCH_HARNESS_INPUT_NAME_FILTER_H_
#define PITBENCH_HARNESS_INPUT_NAME_FILTER_H_

#include <memory>
#include <string>

namespace pitbench {

// Names of cells (loop/scene/method/scalar/isa) and of the like. What searches
// is kept out of this header: it takes longer to compile than most who use it.
class NameFilter {
 public:
  // An ECMAScript regular expression; "" finds every name. Throws InputError.
  explicit NameFilter(const std::string& expression);

  // Whether the expression is found anywhere in the name.
  bool Finds(const std::string& name) const;

 private:
  struct Expression;
  std::shared_ptr<const Expression> expression_;
};

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_INPUT_NAME_FILTER_H_
