#include "harness/measure/answers.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "harness/truth/weights.h"

namespace pitbench {
namespace {

// How much nearer to B or C than to A the point is, as a weight: positive
// where cross_solve_published must say outside, negative where the point is in
// the third of the triangle that it accepts.
template <class T>
double BeyondThirdNearA(const Triangle<T>& t, const Point<T>& p) {
  const std::array<mpq_class, 3> w = ExactWeights(t, p);
  const mpq_class beyond = std::max(w[1], w[2]) - w[0];
  return beyond.get_d();
}

// How far the smallest of the three cross products of an edge and the way from
// it to the point is below 0.
template <class T>
double BelowZero(const Triangle<T>& t, const Point<T>& p) {
  const std::array<mpq_class, 3> w = ExactWeights(t, p);
  const double least = std::min({w[0], w[1], w[2]}).get_d();
  const auto wide = [](T x) { return static_cast<double>(x); };
  return -least *
         std::abs((wide(t.b.x) - wide(t.a.x)) * (wide(t.c.y) - wide(t.a.y)) -
                  (wide(t.b.y) - wide(t.a.y)) * (wide(t.c.x) - wide(t.a.x)));
}

// Whether the point is within `distance` of the triangle's boundary, along x
// and along y, in sides of the bounding box. (A little more: by Pythagoras.)
template <class T>
bool WithinSnapDistance(const Triangle<T>& t, const Point<T>& p,
                        double distance) {
  const auto wide = [](T x) { return static_cast<double>(x); };
  const auto x = std::minmax({wide(t.a.x), wide(t.b.x), wide(t.c.x)});
  const auto y = std::minmax({wide(t.a.y), wide(t.b.y), wide(t.c.y)});
  const auto on_box = [&](const Point<T>& q) -> Point<double> {
    return {(wide(q.x) - x.first) / (x.second - x.first),
            (wide(q.y) - y.first) / (y.second - y.first)};
  };
  const Point<double> v[] = {on_box(t.a), on_box(t.b), on_box(t.c)};
  const Point<double> q = on_box(p);
  double nearest = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const Point<double>& from = v[k];
    const Point<double> edge{v[(k + 1) % 3].x - from.x,
                             v[(k + 1) % 3].y - from.y};
    const Point<double> way{q.x - from.x, q.y - from.y};
    const double along = std::clamp(
        (way.x * edge.x + way.y * edge.y) / (edge.x * edge.x + edge.y * edge.y),
        0.0, 1.0);
    nearest = std::min(
        nearest, std::hypot(way.x - along * edge.x, way.y - along * edge.y));
  }
  return nearest <= 1.415 * distance;
}

template <class T>
std::string Describe(const Scene<T>& scene, const Wrong& wrong) {
  const Call& call = scene.calls[wrong.call];
  const Triangle<T> t = scene.TriangleOf(call, wrong.answer);
  const Point<T> p = scene.PointOf(call, wrong.answer);
  char text[400];
  std::snprintf(text, sizeof(text),
                "says %s of (%a, %a) in (%a, %a) (%a, %a) (%a, %a), which is "
                "%s, and rounding cannot be why",
                wrong.said_inside ? "inside" : "outside",
                static_cast<double>(p.x), static_cast<double>(p.y),
                static_cast<double>(t.a.x), static_cast<double>(t.a.y),
                static_cast<double>(t.b.x), static_cast<double>(t.b.y),
                static_cast<double>(t.c.x), static_cast<double>(t.c.y),
                std::string(Name(Classify(t, p))).c_str());
  return text;
}

// Whether the method declares that it may give this wrong answer. None does
// for NaN and infinity.
template <class T>
bool Declared(const Kernel& kernel, const Scene<T>& scene, const Wrong& wrong) {
  const Call& call = scene.calls[wrong.call];
  const Triangle<T> t = scene.TriangleOf(call, wrong.answer);
  const Point<T> p = scene.PointOf(call, wrong.answer);
  if (!IsFinite(t, p)) return false;
  if (kernel.method.accepts == Accepts::kThirdNearVertexA &&
      !wrong.said_inside && BeyondThirdNearA(t, p) > 0) {
    return true;
  }
  // Twice: the kernel's cross product rounds as well.
  if (kernel.method.tolerance > 0 && wrong.said_inside &&
      Classify(t, p) == Position::kOutside &&
      BelowZero(t, p) <= 2 * kernel.method.tolerance) {
    return true;
  }
  const double snap = kernel.method.snap_distance;
  if (snap > 0 && Classify(t, p) != Position::kDegenerate &&
      WithinSnapDistance(t, p, snap)) {
    return true;
  }
  return RoundingMayDecide(t, p, kSlack);
}

// How far weights may be off: kSlack·u·(M/h)², as RoundingMayDecide has it.
template <class T>
double WeightTolerance(const Triangle<T>& t, const Point<T>& p) {
  double largest = 0;
  double longest = 0;
  const Point<T> vertices[] = {t.a, t.b, t.c};
  for (int k = 0; k < 3; ++k) {
    const Point<T>& v = vertices[k];
    const Point<T>& w = vertices[(k + 1) % 3];
    for (const T x : {v.x, v.y, p.x, p.y}) {
      largest = std::max(largest, std::abs(static_cast<double>(x)));
    }
    longest = std::max(
        longest,
        std::hypot(static_cast<double>(w.x) - static_cast<double>(v.x),
                   static_cast<double>(w.y) - static_cast<double>(v.y)));
  }
  const double double_area =
      std::abs((static_cast<double>(t.b.x) - static_cast<double>(t.a.x)) *
                   (static_cast<double>(t.c.y) - static_cast<double>(t.a.y)) -
               (static_cast<double>(t.b.y) - static_cast<double>(t.a.y)) *
                   (static_cast<double>(t.c.x) - static_cast<double>(t.a.x)));
  const double altitude = double_area / longest;
  const double unit =
      static_cast<double>(std::numeric_limits<T>::epsilon()) / 2;
  return kSlack * unit * (largest / altitude) * (largest / altitude);
}

// The first wrong weight among the first answers of each call, if any.
template <class T>
std::optional<std::string> WrongWeights(const Scene<T>& scene,
                                        const Answers<T>& answers) {
  constexpr std::size_t kChecked = 2000;  // weights are slow to know exactly
  std::size_t checked = 0;
  for (std::size_t c = 0; c < scene.calls.size() && checked < kChecked; ++c) {
    const Call& call = scene.calls[c];
    const std::size_t some = kChecked / scene.calls.size() + 1;
    for (std::size_t i = 0; i < std::min(call.n, some); ++i, ++checked) {
      const Triangle<T> t = scene.TriangleOf(call, i);
      const Point<T> p = scene.PointOf(call, i);
      if (!IsFinite(t, p) || Classify(t, p) == Position::kDegenerate) continue;
      const std::array<mpq_class, 3> exact = ExactWeights(t, p);
      const double tolerance = WeightTolerance(t, p);
      for (std::size_t k = 0; k < 3; ++k) {
        const double error = std::abs(
            static_cast<double>(answers.weights[k][c][i]) - exact[k].get_d());
        if (!(error <= tolerance * std::max(1.0, std::abs(exact[k].get_d())))) {
          return "weight " + std::to_string(k) + " of answer " +
                 std::to_string(i) + " is off by " + std::to_string(error);
        }
      }
    }
  }
  return std::nullopt;
}

}  // namespace

template <class T>
SceneTruth JudgeScene(const Scene<T>& scene) {
  SceneTruth truth;
  for (const Call& call : scene.calls) {
    CallTruth& judged = truth.calls.emplace_back();
    const std::size_t bytes = scene.OutputBytes(call);
    for (Bits* bits : {&judged.inside, &judged.boundary, &judged.strict,
                       &judged.not_finite}) {
      bits->resize(bytes);
    }
    for (std::size_t i = 0; i < scene.Answers(call); ++i) {
      const Triangle<T> t = scene.TriangleOf(call, i);
      const Point<T> p = scene.PointOf(call, i);
      const std::size_t bit = scene.BitOf(i);
      switch (Classify(t, p)) {
        case Position::kInside:
          SetBit(judged.inside, bit);
          SetBit(judged.strict, bit);
          ++truth.interior;
          break;
        case Position::kBoundary:
          SetBit(judged.boundary, bit);
          ++truth.boundary;
          break;
        case Position::kOutside:
          ++truth.exterior;
          if (IsFinite(t, p)) {
            SetBit(judged.strict, bit);
          } else {
            SetBit(judged.not_finite, bit);
            ++truth.not_finite;
          }
          break;
        case Position::kDegenerate:
          ++truth.degenerate;
          break;
      }
    }
  }
  return truth;
}

template <class T>
void Run(const Kernel& kernel, const Scene<T>& scene, Answers<T>& answers) {
  const bool weights = kernel.output == Output::kWeights;
  answers.bits.resize(scene.calls.size());
  for (auto& w : answers.weights) w.resize(weights ? scene.calls.size() : 0);
  for (std::size_t c = 0; c < scene.calls.size(); ++c) {
    const Call& call = scene.calls[c];
    answers.bits[c].resize(scene.OutputBytes(call));
    Result<T> result{.bits = answers.bits[c].data()};
    if (weights) {
      for (std::size_t k = 0; k < 3; ++k) {
        answers.weights[k][c].resize(call.n);
        result.w[k] = answers.weights[k][c].data();
      }
    }
    FunctionOf<T>(kernel)(scene.BatchOf(call), result);
  }
}

template <class T>
Answers<T> Ask(const Kernel& kernel, const Scene<T>& scene,
               const SceneTruth& truth) {
  Answers<T> answers = Run(kernel, scene);
  for (std::size_t c = 0; c < scene.calls.size(); ++c) {
    const Bits& bits = answers.bits[c];
    const CallTruth& judged = truth.calls[c];
    const std::size_t row =
        scene.loop == Loop::kGrid ? scene.width : scene.calls[c].n;
    const std::size_t row_bytes = BitBytes(row);
    for (std::size_t byte = 0; byte < bits.size(); ++byte) {
      const unsigned said = bits[byte];
      const unsigned boundary = judged.boundary[byte];
      answers.boundary_accepted +=
          static_cast<std::size_t>(std::popcount(said & boundary));
      unsigned wrong = (said ^ judged.inside[byte]) & ~boundary & 0xff;
      for (; wrong != 0; wrong &= wrong - 1) {
        const auto bit = static_cast<std::size_t>(std::countr_zero(wrong));
        const std::size_t column = byte % row_bytes * 8 + bit;
        if (column >= row) {
          ++answers.stray_bits;
          continue;
        }
        answers.wrong.push_back(
            {c, byte / row_bytes * row + column, (said >> bit & 1) != 0});
      }
    }
  }
  return answers;
}

template <class T>
std::optional<std::string> Refusal(const Kernel& kernel, const Scene<T>& scene,
                                   const SceneTruth& truth) {
  const Answers<T> answers = Ask(kernel, scene, truth);
  if (answers.stray_bits != 0) return "sets bits past the last answer";
  // A method that accepts a third is wrong about a third of all points; that
  // many cannot be looked at exactly, so every so manieth is.
  constexpr std::size_t kExamined = 20000;
  const std::size_t step = answers.wrong.size() / kExamined + 1;
  for (std::size_t i = 0; i < answers.wrong.size(); i += step) {
    if (!Declared(kernel, scene, answers.wrong[i])) {
      return Describe(scene, answers.wrong[i]);
    }
  }
  if constexpr (!std::is_integral_v<T>) {
    if (kernel.output == Output::kWeights) return WrongWeights(scene, answers);
  }
  return std::nullopt;
}

#define PITBENCH_INSTANTIATE(T)                                               \
  template SceneTruth JudgeScene(const Scene<T>&);                            \
  template void Run(const Kernel&, const Scene<T>&, Answers<T>&);             \
  template Answers<T> Ask(const Kernel&, const Scene<T>&, const SceneTruth&); \
  template std::optional<std::string> Refusal(const Kernel&, const Scene<T>&, \
                                              const SceneTruth&)
PITBENCH_INSTANTIATE(float);
PITBENCH_INSTANTIATE(double);
PITBENCH_INSTANTIATE(std::int32_t);
#undef PITBENCH_INSTANTIATE

}  // namespace pitbench
