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
// or along y.
template <class T>
bool NearTheBoundary(const Triangle<T>& t, const Point<T>& p, double distance) {
  const auto wide = [](T x) { return static_cast<double>(x); };
  const double x[] = {wide(t.a.x) - wide(p.x), wide(t.b.x) - wide(p.x),
                      wide(t.c.x) - wide(p.x)};
  const double y[] = {wide(t.a.y) - wide(p.y), wide(t.b.y) - wide(p.y),
                      wide(t.c.y) - wide(p.y)};
  // Where the edge from (u0, v0) to (u1, v1) crosses u = 0, if it does.
  const auto crosses_near = [&](double u0, double v0, double u1, double v1) {
    if (u0 == 0 && u1 == 0) {  // along it
      return std::min(v0, v1) <= distance && std::max(v0, v1) >= -distance;
    }
    if (std::min(u0, u1) > 0 || std::max(u0, u1) < 0) return false;
    return std::abs(v0 + (v1 - v0) * u0 / (u0 - u1)) <= distance;
  };
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3;
    if (crosses_near(x[k], y[k], x[next], y[next]) ||
        crosses_near(y[k], x[k], y[next], x[next])) {
      return true;
    }
  }
  return false;
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
  if (kernel.method.edge_width > 0 && wrong.said_inside &&
      NearTheBoundary(t, p, kernel.method.edge_width)) {
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
  return JudgeAnswers(scene, [&](const Call& call, std::size_t i) -> Verdict {
    const Triangle<T> t = scene.TriangleOf(call, i);
    const Point<T> p = scene.PointOf(call, i);
    const Position position = Classify(t, p);
    const bool finite = position != Position::kOutside || IsFinite(t, p);
    return {position, finite,
            position == Position::kInside ||
                (position == Position::kOutside && finite)};
  });
}

template <class T>
void AskCases(const Kernel& kernel, const Batch<T>& cases, std::uint8_t* bits) {
  const KernelFunction<T> run = FunctionOf<T>(kernel);
  if (kernel.loop == Loop::kPairs) {
    run(cases, Result<T>{.bits = bits});
    return;
  }
  std::fill_n(bits, BitBytes(cases.n), std::uint8_t{0});
  for (std::size_t i = 0; i < cases.n; ++i) {
    std::uint8_t bit = 0;
    run({cases.ax + i, cases.ay + i, cases.bx + i, cases.by + i, cases.cx + i,
         cases.cy + i, cases.px + i, cases.py + i, 1},
        Result<T>{.bits = &bit});
    bits[i / 8] = static_cast<std::uint8_t>(bits[i / 8] | bit << (i % 8));
  }
}
template void AskCases(const Kernel&, const Batch<float>&, std::uint8_t*);
template void AskCases(const Kernel&, const Batch<double>&, std::uint8_t*);

template <class T>
void Run(const Kernel& kernel, const Scene<T>& scene, Answers<T>& answers) {
  const bool weights = kernel.output == Output::kWeights;
  answers.bits.resize(scene.calls.size());
  for (auto& w : answers.weights) w.resize(weights ? scene.calls.size() : 0);
  const Array<T> xy = PointsFor(kernel, scene);
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
    FunctionOf<T>(kernel)(scene.BatchOf(call, xy.data()), result);
  }
}

template <class T>
Answers<T> Ask(const Kernel& kernel, const Scene<T>& scene,
               const SceneTruth& truth) {
  Answers<T> answers = Run(kernel, scene);
  JudgeBits(scene, truth, answers);
  return answers;
}

template <class T>
std::optional<std::string> Refusal(const Kernel& kernel, const Scene<T>& scene,
                                   const SceneTruth& truth) {
  if (kernel.method.finite_only && truth.not_finite != 0) {
    return "must not be asked about NaN and infinity";
  }
  const Answers<T> answers = Ask(kernel, scene, truth);
  if (answers.stray_bits != 0) return "sets bits past the last answer";
  // A method that accepts a third is wrong about a third of all points; that
  // many cannot be looked at exactly, so every so manieth is.
  constexpr std::size_t kWrongExamined = 20000;
  const std::size_t step = answers.wrong.size() / kWrongExamined + 1;
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
PITBENCH_INSTANTIATE(std::int16_t);
PITBENCH_INSTANTIATE(std::uint8_t);
#undef PITBENCH_INSTANTIATE

}  // namespace pitbench
