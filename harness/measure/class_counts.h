// The classes of errors, counted in the same way for points and for rays: a
// Details (scene_details.h) knows the scene.
#ifndef PITBENCH_HARNESS_MEASURE_CLASS_COUNTS_H_
#define PITBENCH_HARNESS_MEASURE_CLASS_COUNTS_H_

#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "harness/measure/failures.h"

namespace pitbench {

template <class T, class Details>
void AddWrong(const Answers<T>& answers, Details& details,
              nlohmann::json& classes) {
  const SceneTruth& truth = details.truth();
  Failures<Details> false_inside(details);
  Failures<Details> false_outside(details);
  std::size_t not_finite = 0;
  nlohmann::json inputs = nlohmann::json::array();
  for (const Wrong& wrong : answers.wrong) {
    const AnswerPlace place{wrong.call, wrong.answer};
    const std::size_t bit = details.scene().BitOf(wrong.answer);
    if (BitAt(truth.calls[wrong.call].not_finite, bit)) {
      if (++not_finite <= 2) {
        inputs.push_back(InputOf(details.scene(), place, wrong.said_inside));
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
  nlohmann::json boundary = Share(answers.boundary_accepted, truth.boundary);
  boundary["distance_ulps"] = nullptr;
  boundary["worst"] = nlohmann::json::array();
  classes["boundary_accepted"] = std::move(boundary);
  if (truth.not_finite != 0) {
    nlohmann::json accepted = Share(not_finite, truth.not_finite);
    accepted["distance_ulps"] = nullptr;
    accepted["worst"] = std::move(inputs);
    classes["not_finite_accepted"] = std::move(accepted);
  }
}

template <class KernelType, class T, class Details>
void AddChanged(const KernelType& kernel, const Answers<T>& answers,
                Details& details, nlohmann::json& classes) {
  const auto& variants = details.GetVariants();
  std::vector<Bits> reversed;  // what exchanging B and C changes
  Bits changed;
  for (const auto& [name, variant] : variants.changed) {
    const auto& scene = variant;  // no binding can be captured
    Run(kernel, scene, details.Scratch());
    const std::vector<Bits>& told_otherwise = details.Scratch().bits;
    Failures<Details> failures(details);
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

template <class KernelType, class Details>
void AddNotFinite(const KernelType& kernel, Details& details,
                  nlohmann::json& classes) {
  const auto& variants = details.GetVariants();
  if (!variants.not_finite) return;
  const auto& scene = *variants.not_finite;
  Run(kernel, scene, details.Scratch());
  const std::vector<Bits>& said = details.Scratch().bits;
  std::size_t accepted = 0;
  nlohmann::json inputs = nlohmann::json::array();
  for (std::size_t c = 0; c < scene.calls.size(); ++c) {
    Bits bits = variants.not_finite_bits[c];
    for (std::size_t byte = 0; byte < bits.size(); ++byte) {
      bits[byte] = static_cast<std::uint8_t>(bits[byte] & said[c][byte]);
    }
    ForEachAnswer(scene, scene.calls[c], bits, [&](std::size_t i) {
      if (++accepted > 2) return;
      inputs.push_back(InputOf(scene, {c, i}, /*said_inside=*/true));
      inputs.back()["distance_ulps"] = nullptr;
    });
  }
  nlohmann::json entry = Share(accepted, variants.not_finite_of);
  entry["distance_ulps"] = nullptr;
  entry["worst"] = std::move(inputs);
  classes["not_finite_accepted"] = std::move(entry);
}

// Of each query the answer shown is that of a triangle that is wrong about it,
// if one is: for a hole one that does hold the point, for a double hit one that
// claims but does not hold it.
template <class T, class Details>
void AddClaims(const Answers<T>& answers, Details& details,
               nlohmann::json& classes) {
  if (details.Queries().empty()) return;
  Failures<Details> holes(details);
  Failures<Details> double_hits(details);
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

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_CLASS_COUNTS_H_
