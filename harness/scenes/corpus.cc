// The corpus of published bug reports as a scene.
#include "harness/scenes/corpus.h"

#include <string_view>

#include "harness/scenes/families.h"

namespace pitbench {
namespace {

// Written by CMake from the files in tests/cases/.
constexpr std::string_view kRealWorld =
#include "real_world.inc"
    ;
constexpr std::string_view kTypedDecimals =
#include "typed_decimals.inc"
    ;

// The columns that both files have, from row `i` of a table.
CorpusCase CaseAt(const Table<std::string>& table, std::size_t i) {
  CorpusCase one{.id = table.columns[0][i],
                 .scalar = table.columns[1][i],
                 .source = table.columns[2][i],
                 .at = {},
                 .truth = table.columns[11][i]};
  for (std::size_t k = 0; k < one.at.size(); ++k) {
    one.at[k] = table.columns[3 + k][i];
  }
  return one;
}

}  // namespace

std::vector<CorpusCase> RealWorldCorpus() {
  constexpr std::array<std::string_view, 13> kHeader = {
      "id", "scalar", "source", "ax", "ay",    "bx",  "by",
      "cx", "cy",     "px",     "py", "truth", "note"};
  const auto table =
      ReadCsvText<std::string>("real_world.csv", kRealWorld, kHeader);
  std::vector<CorpusCase> cases;
  for (std::size_t i = 0; i < table.rows; ++i) {
    cases.push_back(CaseAt(table, i));
  }
  return cases;
}

std::vector<TypedCase> TypedDecimals() {
  constexpr std::array<std::string_view, 13> kHeader = {
      "id", "scalar", "source", "ax", "ay",     "bx",     "by",
      "cx", "cy",     "px",     "py", "binary", "decimal"};
  const auto table =
      ReadCsvText<std::string>("typed_decimals.csv", kTypedDecimals, kHeader);
  std::vector<TypedCase> cases;
  for (std::size_t i = 0; i < table.rows; ++i) {
    cases.push_back({CaseAt(table, i), table.columns[12][i]});
  }
  return cases;
}

// Nothing about it is random and its size is its own. For pairs it is one call,
// for the other loops a call a case.
template <class T>
Scene<T> CorpusScene(const SceneSpec& spec, Loop loop, SceneSize /*size*/,
                     std::uint64_t /*seed*/) {
  Scene<T> scene{.name = spec.name, .loop = loop};
  for (const CorpusCase& one : RealWorldCorpus()) {
    if (one.scalar != Name(ScalarOf<T>())) continue;
    const std::size_t i = scene.ax.size();
    scene.Add(one.TriangleAs<T>());
    scene.Add(one.PointAs<T>());
    if (loop != Loop::kPairs) scene.calls.push_back({i, i, 1});
  }
  if (loop == Loop::kPairs) scene.calls = {{0, 0, scene.ax.size()}};
  return scene;
}

template Scene<float> CorpusScene(const SceneSpec&, Loop, SceneSize,
                                  std::uint64_t);
template Scene<double> CorpusScene(const SceneSpec&, Loop, SceneSize,
                                   std::uint64_t);

}  // namespace pitbench
