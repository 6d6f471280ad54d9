#include "harness/measure/two_truths.h"

#include <gmpxx.h>

#include <nlohmann/json.hpp>

#include "harness/scenes/corpus.h"

namespace pitbench {
namespace {

template <class T>
std::string_view VerdictWord(const CorpusCase& one) {
  return Name(Classify(one.TriangleAs<T>(), one.PointAs<T>()));
}

}  // namespace

nlohmann::json TwoTruths() {
  nlohmann::json verdicts = nlohmann::json::array();
  for (const TypedCase& one : TypedDecimals()) {
    verdicts.push_back(
        {{"id", one.id},
         {"source", one.source},
         {"scalar", one.scalar},
         {"binary", one.scalar == "f32" ? VerdictWord<float>(one)
                                        : VerdictWord<double>(one)},
         {"decimal", VerdictWord<mpq_class>(one)}});
  }
  return verdicts;
}

}  // namespace pitbench
