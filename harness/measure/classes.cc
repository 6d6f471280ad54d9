#include "harness/measure/classes.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>

#include "harness/measure/statistics.h"

namespace pitbench {
namespace {

using nlohmann::json;

json Share(std::size_t count, std::size_t of) {
  const Interval interval = Wilson95(count, of);
  return {{"count", count},
          {"of", of},
          {"low", interval.low},
          {"high", interval.high}};
}

template <class T>
json Hex(const Point<T>& p) {
  const auto text = [](T x) {
    std::array<char, 40> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%a", static_cast<double>(x));
    return std::string(buffer.data());
  };
  return {text(p.x), text(p.y)};
}

template <class T>
json Input(const Scene<T>& scene, const AnswerPlace& place, bool said_inside) {
  const Call& call = scene.calls[place.call];
  const Triangle<T> t = scene.TriangleOf(call, place.answer);
  return {{"a", Hex(t.a)},
          {"b", Hex(t.b)},
          {"c", Hex(t.c)},
          {"p", Hex(scene.PointOf(call, place.answer))},
          {"said", said_inside ? "inside" : "outside"}};
}

// The failing answers of one class: how many, and which lie nearest to and
// farthest from the boundary. These are chosen by an estimate and then measured
// exactly, so that thirty thousand of them take no seconds.
template <class T>
class Failures {
 public:
  explicit Failures(SceneDetails<T>& details) : details_(details) {}

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

  json Of(std::size_t of) const {
    json entry = Share(count_, of);
    entry["distance_ulps"] = nullptr;
    entry["worst"] = json::array();
    if (count_ == 0) return entry;
    double smallest = Exactly(nearest_);
    double largest = smallest;
    for (std::size_t k = 0; k < std::min<std::size_t>(count_, 2); ++k) {
      const Failure& failure = farthest_[k];
      json worst = Input(details_.scene(), failure.place, failure.said_inside);
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

  SceneDetails<T>& details_;
  std::size_t count_ = 0;
  Failure nearest_{};
  std::array<Failure, 2> farthest_{};
};

template <class T>
void AddWrong(const Answers<T>& answers, SceneDetails<T>& details,
              json& classes) {
  const SceneTruth& truth = details.truth();
  Failures<T> false_inside(details);
  Failures<T> false_outside(details);
  std::size_t not_finite = 0;
  json inputs = json::array();
  for (const Wrong& wrong : answers.wrong) {
    const AnswerPlace place{wrong.call, wrong.answer};
    const std::size_t bit = details.scene().BitOf(wrong.answer);
    if (BitAt(truth.calls[wrong.call].not_finite, bit)) {
      if (++not_finite <= 2) {
        inputs.push_back(Input(details.scene(), place, wrong.said_inside));
        inputs.back()["distance_ulps"] = nullptr;
      }
    } else {
      (wrong.said_inside ? false_inside : false_outside)
          .Add(place, wrong.said_inside);
    }
  }
  classes["false_inside"] =
      false_inside.Of(truth.exterior - truth.not_finite + truth.degenerate);
  classes["false_outside"] = false_outside.Of(truth.interior);
  json boundary = Share(answers.boundary_accepted, truth.boundary);
  boundary["distance_ulps"] = nullptr;
  boundary["worst"] = json::array();
  classes["boundary_accepted"] = std::move(boundary);
  if (truth.not_finite != 0) {
    json accepted = Share(not_finite, truth.not_finite);
    accepted["distance_ulps"] = nullptr;
    accepted["worst"] = std::move(inputs);
    classes["not_finite_accepted"] = std::move(accepted);
  }
}

// Sets `bits` to those that differ between two outputs, of those in `among`.
void Differing(const Bits& left, const Bits& right, const Bits& among,
               Bits& bits) {
  bits.resize(right.size());
  for (std::size_t byte = 0; byte < right.size(); ++byte) {
    bits[byte] =
        static_cast<std::uint8_t>((left[byte] ^ right[byte]) & among[byte]);
  }
}

template <class T>
void AddChanged(const Kernel& kernel, const Answers<T>& answers,
                SceneDetails<T>& details, json& classes) {
  const Variants<T>& variants = details.GetVariants();
  std::vector<Bits> reversed;  // what exchanging B and C changes
  Bits changed;
  for (const auto& [name, variant] : variants.changed) {
    const Scene<T>& scene = variant;  // no binding can be captured
    Run(kernel, scene, details.Scratch());
    const std::vector<Bits>& told_otherwise = details.Scratch().bits;
    Failures<T> failures(details);
    for (std::size_t c = 0; c < scene.calls.size(); ++c) {
      Differing(answers.bits[c], told_otherwise[c],
                details.truth().calls[c].strict, changed);
      // The last byte of a call cut short may hold answers of the whole one.
      const std::size_t n = scene.Answers(scene.calls[c]);
      if (name == "reversed_winding") {
        reversed.push_back(changed);
      } else if (name == "swapped_vertices") {
        for (std::size_t byte = 0; byte < changed.size(); ++byte) {
          changed[byte] = static_cast<std::uint8_t>(
              changed[byte] & ~static_cast<unsigned>(reversed[c][byte]));
        }
      }
      ForEachAnswer(scene, scene.calls[c], changed, [&](std::size_t i) {
        if (i >= n) return;
        failures.Add({c, i}, BitAt(answers.bits[c], scene.BitOf(i)));
      });
    }
    classes[name] = failures.Of(variants.of);
  }
}

template <class T>
void AddNotFinite(const Kernel& kernel, SceneDetails<T>& details,
                  json& classes) {
  const Variants<T>& variants = details.GetVariants();
  if (!variants.not_finite) return;
  const Scene<T>& scene = *variants.not_finite;
  Run(kernel, scene, details.Scratch());
  const std::vector<Bits>& said = details.Scratch().bits;
  std::size_t accepted = 0;
  json inputs = json::array();
  for (std::size_t c = 0; c < scene.calls.size(); ++c) {
    Bits bits = variants.not_finite_bits[c];
    for (std::size_t byte = 0; byte < bits.size(); ++byte) {
      bits[byte] = static_cast<std::uint8_t>(bits[byte] & said[c][byte]);
    }
    ForEachAnswer(scene, scene.calls[c], bits, [&](std::size_t i) {
      if (++accepted > 2) return;
      inputs.push_back(Input(scene, {c, i}, /*said_inside=*/true));
      inputs.back()["distance_ulps"] = nullptr;
    });
  }
  json entry = Share(accepted, variants.not_finite_of);
  entry["distance_ulps"] = nullptr;
  entry["worst"] = std::move(inputs);
  classes["not_finite_accepted"] = std::move(entry);
}

// Of each query the answer shown is that of a triangle that is wrong about it,
// if one is: for a hole one that does hold the point, for a double hit one that
// claims but does not hold it.
template <class T>
void AddClaims(const Answers<T>& answers, SceneDetails<T>& details,
               json& classes) {
  if (details.Queries().empty()) return;
  Failures<T> holes(details);
  Failures<T> double_hits(details);
  std::size_t asked = 0;
  for (const std::vector<AnswerPlace>& query : details.Queries()) {
    if (query.empty()) continue;
    ++asked;
    const auto bit = [&](const AnswerPlace& place) {
      return details.scene().BitOf(place.answer);
    };
    const auto claims = [&](const AnswerPlace& place) {
      return BitAt(answers.bits[place.call], bit(place));
    };
    const auto holds = [&](const AnswerPlace& place) {
      const CallTruth& truth = details.truth().calls[place.call];
      return BitAt(truth.inside, bit(place)) ||
             BitAt(truth.boundary, bit(place));
    };
    const auto count = std::count_if(query.begin(), query.end(), claims);
    if (count == 1) continue;
    const bool hit = count != 0;
    auto shown =
        std::find_if(query.begin(), query.end(), [&](const AnswerPlace& place) {
          return claims(place) == hit && holds(place) != hit;
        });
    if (shown == query.end()) {
      shown = std::find_if(
          query.begin(), query.end(),
          [&](const AnswerPlace& place) { return claims(place) == hit; });
    }
    (hit ? double_hits : holes).Add(*shown, hit);
  }
  classes["hole"] = holes.Of(asked);
  classes["double_hit"] = double_hits.Of(asked);
}

}  // namespace

template <class T>
json ErrorClasses(const Kernel& kernel, const Answers<T>& answers,
                  SceneDetails<T>& details) {
  json classes;
  AddWrong(answers, details, classes);
  AddChanged(kernel, answers, details, classes);
  AddNotFinite(kernel, details, classes);
  AddClaims(answers, details, classes);
  return classes;
}

template json ErrorClasses(const Kernel&, const Answers<float>&,
                           SceneDetails<float>&);
template json ErrorClasses(const Kernel&, const Answers<double>&,
                           SceneDetails<double>&);
template json ErrorClasses(const Kernel&, const Answers<std::int32_t>&,
                           SceneDetails<std::int32_t>&);

}  // namespace pitbench
