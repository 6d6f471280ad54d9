// Failing answers, counted with an interval, and the worst of them.
#ifndef PITBENCH_HARNESS_MEASURE_FAILURES_H_
#define PITBENCH_HARNESS_MEASURE_FAILURES_H_

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "harness/measure/answers.h"
#include "harness/measure/cells.h"
#include "harness/measure/statistics.h"

namespace pitbench {

// An answer of a scene.
struct AnswerPlace {
  std::size_t call;
  std::size_t answer;  // within the call
};

inline nlohmann::json Share(std::size_t count, std::size_t of) {
  const Interval interval = Wilson95(count, of);
  return {{"count", count},
          {"of", of},
          {"low", interval.low},
          {"high", interval.high}};
}

// Coordinates as hex floats.
template <class... T>
nlohmann::json Hex(T... coordinates) {
  const auto text = [](double x) {
    std::array<char, 40> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%a", x);
    return std::string(buffer.data());
  };
  return {text(static_cast<double>(coordinates))...};
}

// What a cell of accuracy.schema.json begins with, of points and of rays.
template <class KernelType, class SceneType>
nlohmann::json CellOf(const KernelType& kernel, const SceneType& scene,
                      const SceneTruth& truth) {
  return {{"name", CellName(kernel, scene.name)},
          {"loop", Name(kernel.loop, kernel.output)},
          {"scene", scene.name},
          {"method", kernel.method.key},
          {"scalar", Name(kernel.scalar)},
          {"isa", Name(kernel.isa)},
          {"boundary_rule", Name(kernel.method.boundary)},
          {"points",
           truth.interior + truth.exterior + truth.boundary + truth.degenerate},
          {"interior", truth.interior},
          {"exterior", truth.exterior - truth.not_finite},
          {"boundary", truth.boundary},
          {"degenerate", truth.degenerate},
          {"not_finite", truth.not_finite}};
}

// Sets `bits` to those that differ between two outputs, of those in `among`.
inline void Differing(const Bits& left, const Bits& right, const Bits& among,
                      Bits& bits) {
  bits.resize(right.size());
  for (std::size_t byte = 0; byte < right.size(); ++byte) {
    bits[byte] =
        static_cast<std::uint8_t>((left[byte] ^ right[byte]) & among[byte]);
  }
}

// The failing answers of one class: how many, and which lie nearest to and
// farthest from the boundary. These are chosen by an estimate and then measured
// exactly, so that thirty thousand of them take no seconds. Details has
// Estimate(place), Distance(place) and Input(place, said_inside).
template <class Details>
class Failures {
 public:
  explicit Failures(Details& details) : details_(details) {}

  void Add(const AnswerPlace& place, bool said_inside) {
    const Failure failure{place, said_inside, details_.Estimate(place)};
    if (count_ == 0 || failure.estimate < nearest_.estimate) nearest_ = failure;
    // The farthest two, the first of equals first.
    if (count_ == 0 || failure.estimate > farthest_[0].estimate) {
      farthest_[1] = farthest_[0];
      farthest_[0] = failure;
    } else if (count_ == 1 || failure.estimate > farthest_[1].estimate) {
      farthest_[1] = failure;
    }
    ++count_;
  }

  std::size_t count() const { return count_; }

  nlohmann::json Of(std::size_t of) const {
    nlohmann::json entry = Share(count_, of);
    entry["distance_ulps"] = nullptr;
    entry["worst"] = nlohmann::json::array();
    if (count_ == 0) return entry;
    double smallest = Exactly(nearest_);
    double largest = smallest;
    for (std::size_t k = 0; k < std::min<std::size_t>(count_, 2); ++k) {
      const Failure& failure = farthest_[k];
      nlohmann::json worst = details_.Input(failure.place, failure.said_inside);
      const double distance = Exactly(failure);
      worst["distance_ulps"] = distance;
      smallest = std::min(smallest, distance);
      largest = std::max(largest, distance);
      entry["worst"].push_back(std::move(worst));
    }
    entry["distance_ulps"] = {{"smallest", smallest}, {"largest", largest}};
    return entry;
  }

 private:
  struct Failure {
    AnswerPlace place;
    bool said_inside;
    double estimate;
  };

  // A number in JSON is finite.
  double Exactly(const Failure& failure) const {
    return std::min(details_.Distance(failure.place),
                    std::numeric_limits<double>::max());
  }

  Details& details_;
  std::size_t count_ = 0;
  Failure nearest_{};
  std::array<Failure, 2> farthest_{};
};

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_FAILURES_H_
