#include "harness/measure/two_truths.h"

#include <gmpxx.h>

#include <nlohmann/json.hpp>

#include "harness/scenes/corpus.h"

namespace pitbench {
namespace {

template <class T>
std::string_view Verdict(const CorpusCase& one) {
  return Name(Classify(one.TriangleAs<T>(), one.PointAs<T>()));
}

}  // namespace

nlohmann::json TwoTruths() {
  nlohmann::json verdicts = nlohmann::json::array();
  for (const TypedCase& one : TypedDecimals()) {
    verdicts.push_back({{"id", one.id},
                        {"source", one.source},
                        {"scalar", one.scalar},
                        {"binary", one.scalar == "f32" ? Verdict<float>(one)
                                                       : Verdict<double>(one)},
                        {"decimal", Verdict<mpq_class>(one)}});
  }
  return verdicts;
}

}  // namespace pitbench
