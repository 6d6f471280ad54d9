#include "harness/measure/accuracy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "harness/measure/answers.h"
#include "harness/measure/statistics.h"
#include "harness/truth/weights.h"

namespace pitbench {
namespace {

using nlohmann::json;

json Rate(std::size_t count, std::size_t of) {
  const Interval interval = Wilson95(count, of);
  return {{"count", count},
          {"of", of},
          {"low", interval.low},
          {"high", interval.high}};
}

template <class T>
json Hex(const Point<T>& p) {
  const auto text = [](T x) {
    char buffer[40];
    std::snprintf(buffer, sizeof(buffer), "%a", static_cast<double>(x));
    return std::string(buffer);
  };
  return {text(p.x), text(p.y)};
}

// What is slow to know exactly about a scene, known once for all its kernels:
// how far each point lies from the boundary, and some exact weights.
template <class T>
class SceneDetails {
 public:
  // Weights are judged on this many answers of a scene, the first of each call.
  static constexpr std::size_t kWeighed = 512;

  explicit SceneDetails(const Scene<T>& scene) : scene_(scene) {
    for (const Call& call : scene.calls) {
      distances_.emplace_back(scene.Answers(call), -1.0);
    }
  }

  double Distance(std::size_t call, std::size_t answer) {
    double& distance = distances_[call][answer];
    if (distance < 0) {
      distance =
          BoundaryDistanceInUlps(scene_.TriangleOf(scene_.calls[call], answer),
                                 scene_.PointOf(scene_.calls[call], answer));
    }
    return distance;
  }

  struct Weighed {
    std::size_t call;
    std::size_t answer;
    std::array<mpq_class, 3> weights;
  };
  const std::vector<Weighed>& Weights() {
    if (!weighed_.empty()) return weighed_;
    const std::size_t some = kWeighed / scene_.calls.size() + 1;
    for (std::size_t c = 0; c < scene_.calls.size(); ++c) {
      const Call& call = scene_.calls[c];
      for (std::size_t i = 0; i < std::min(call.n, some); ++i) {
        if (weighed_.size() == kWeighed) return weighed_;
        const Triangle<T> t = scene_.TriangleOf(call, i);
        const Point<T> p = scene_.PointOf(call, i);
        if (!IsFinite(t, p) || Classify(t, p) == Position::kDegenerate)
          continue;
        weighed_.push_back({c, i, ExactWeights(t, p)});
      }
    }
    return weighed_;
  }

 private:
  const Scene<T>& scene_;
  std::vector<std::vector<double>> distances_;
  std::vector<Weighed> weighed_;
};

// The errors of the weights, in ulps of 1: that is what their sum is, and the
// ulp of a weight near 0 would make an error of nothing look like a large one.
template <class T>
json WeightErrors(const Answers<T>& answers, SceneDetails<T>& details) {
  double largest = 0;
  double sum = 0;
  std::size_t finite = 0;
  std::size_t not_finite = 0;
  for (const auto& weighed : details.Weights()) {
    for (std::size_t k = 0; k < 3; ++k) {
      const T computed = answers.weights[k][weighed.call][weighed.answer];
      if (std::isfinite(computed)) {
        const mpq_class off =
            mpq_class(static_cast<double>(computed)) - weighed.weights[k];
        const double error =
            std::abs(off.get_d()) /
            static_cast<double>(std::numeric_limits<T>::epsilon());
        largest = std::max(largest, error);
        sum += error;
        ++finite;
      } else {
        ++not_finite;
      }
    }
  }
  return {{"largest_ulps", largest},
          {"mean_ulps", finite == 0 ? 0 : sum / static_cast<double>(finite)},
          {"not_finite", not_finite},
          {"points", details.Weights().size()}};
}

template <class T>
json MeasureCell(const Kernel& kernel, const Scene<T>& scene,
                 const SceneTruth& truth, SceneDetails<T>& details) {
  const Answers<T> answers = Ask(kernel, scene, truth);
  std::size_t false_inside = 0;
  double smallest = 0;
  double largest = -1;
  const Wrong* worst = nullptr;
  for (const Wrong& wrong : answers.wrong) {
    if (wrong.said_inside) ++false_inside;
    const double distance = details.Distance(wrong.call, wrong.answer);
    if (worst == nullptr || distance < smallest) smallest = distance;
    if (distance > largest) {
      largest = distance;
      worst = &wrong;
    }
  }
  json cell = {
      {"name", CellName(kernel, scene.name)},
      {"loop", Name(kernel.loop, kernel.output)},
      {"scene", scene.name},
      {"method", kernel.method.key},
      {"scalar", Name(kernel.scalar)},
      {"isa", Name(kernel.isa)},
      {"boundary_rule", Name(kernel.method.boundary)},
      {"accepts", Name(kernel.method.accepts)},
      {"points",
       truth.interior + truth.exterior + truth.boundary + truth.degenerate},
      {"interior", truth.interior},
      {"exterior", truth.exterior},
      {"boundary", truth.boundary},
      {"degenerate", truth.degenerate},
      {"false_outside",
       Rate(answers.wrong.size() - false_inside, truth.interior)},
      {"false_inside", Rate(false_inside, truth.exterior + truth.degenerate)},
      {"boundary_accepted", Rate(answers.boundary_accepted, truth.boundary)},
      {"error_distance_ulps", nullptr},
      {"worst", json::array()},
      {"weights", nullptr}};
  if (worst != nullptr) {
    cell["error_distance_ulps"] = {{"smallest", smallest},
                                   {"largest", largest}};
    const Call& call = scene.calls[worst->call];
    const Triangle<T> t = scene.TriangleOf(call, worst->answer);
    cell["worst"].push_back(
        {{"kind", worst->said_inside ? "false_inside" : "false_outside"},
         {"distance_ulps", largest},
         {"a", Hex(t.a)},
         {"b", Hex(t.b)},
         {"c", Hex(t.c)},
         {"p", Hex(scene.PointOf(call, worst->answer))}});
  }
  if constexpr (!std::is_integral_v<T>) {
    if (kernel.output == Output::kWeights) {
      cell["weights"] = WeightErrors(answers, details);
    }
  }
  return cell;
}

template <class T>
void Append(json& cells, const ProfileScene& listed, Loop loop, SceneSize size,
            const std::vector<const Kernel*>& kernels, std::uint64_t seed) {
  const Scene<T> scene =
      MakeScene<T>(ParseScene(listed.name), loop, size, seed);
  for (json& cell : MeasureAccuracyOn(scene, kernels)) {
    cells.push_back(std::move(cell));
  }
}

}  // namespace

template <class T>
json MeasureAccuracyOn(const Scene<T>& scene,
                       const std::vector<const Kernel*>& kernels) {
  const SceneTruth truth = JudgeScene(scene);
  SceneDetails<T> details(scene);
  json cells = json::array();
  for (const Kernel* kernel : kernels) {
    cells.push_back(MeasureCell(*kernel, scene, truth, details));
  }
  return cells;
}

template json MeasureAccuracyOn(const Scene<float>&,
                                const std::vector<const Kernel*>&);
template json MeasureAccuracyOn(const Scene<double>&,
                                const std::vector<const Kernel*>&);
template json MeasureAccuracyOn(const Scene<std::int32_t>&,
                                const std::vector<const Kernel*>&);

json MeasureAccuracy(const Profile& profile, const std::regex& filter,
                     std::uint64_t seed) {
  json cells = json::array();
  for (const ProfileScene& listed : profile.accuracy) {
    for (const Loop loop : listed.loops) {
      const std::vector<const Kernel*> kernels =
          KernelsFor(listed, loop, filter);
      if (kernels.empty()) continue;
      const SceneSize size = profile.accuracy_size;
      switch (listed.scalar) {
        case Scalar::kF32:
          Append<float>(cells, listed, loop, size, kernels, seed);
          break;
        case Scalar::kF64:
          Append<double>(cells, listed, loop, size, kernels, seed);
          break;
        case Scalar::kI32:
          Append<std::int32_t>(cells, listed, loop, size, kernels, seed);
          break;
      }
    }
  }
  return cells;
}

}  // namespace pitbench
