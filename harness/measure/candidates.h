// What a hunt tries: inputs drawn from the hard distributions, and inputs
// like one that is wrong already.
#ifndef PITBENCH_HARNESS_MEASURE_CANDIDATES_H_
#define PITBENCH_HARNESS_MEASURE_CANDIDATES_H_

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "harness/measure/mutants.h"
#include "harness/scenes/families.h"
#include "harness/scenes/step.h"

namespace pitbench {

// ax, ay, bx, by, cx, cy, px, py.
template <class T>
using Candidate = std::array<T, 8>;

template <class T>
Triangle<T> TriangleOf(const Candidate<T>& c) {
  return {{c[0], c[1]}, {c[2], c[3]}, {c[4], c[5]}};
}
template <class T>
Point<T> PointOf(const Candidate<T>& c) {
  return {c[6], c[7]};
}

// Whether it is one that hunt.h allows.
template <class T>
bool Admissible(const Candidate<T>& c) {
  return AreConfined(c) &&
         std::max(std::abs(c[6]), std::abs(c[7])) >= static_cast<T>(0.5);
}

template <class T>
class CandidateSource {
 public:
  explicit CandidateSource(std::uint64_t seed)
      : random_(SeedFor("hunt", seed)) {}

  // A point beside an edge or the line of one, near a vertex or anywhere around
  // a triangle that is well shaped, a needle, or small where it lies. Not
  // always admissible.
  Candidate<T> Draw() {
    // A triangle in [−1, 1]², of any size and altitude.
    Triangle<double> t = WellShaped(random_);
    const double size = random_.Below(2) == 0 ? 2 : 2 * Length();
    const double altitude = random_.Below(2) == 0 ? 1 : Length();
    const Point<double> corner{random_.In(-1, 1), random_.In(-1, 1)};
    const Point<double> along{t.b.x - t.a.x, t.b.y - t.a.y};
    const double s = random_.Unit();
    const Point<double> foot{along.x * s, along.y * s};
    const Point<double> rise{t.c.x - t.a.x - foot.x, t.c.y - t.a.y - foot.y};
    const auto at = [&](double x, double y) {
      return Point<T>{static_cast<T>(corner.x + size * x),
                      static_cast<T>(corner.y + size * y)};
    };
    std::array<Point<T>, 3> v = {
        at(0, 0), at(along.x, along.y),
        at(foot.x + altitude * rise.x, foot.y + altitude * rise.y)};
    std::rotate(v.begin(), v.begin() + static_cast<int>(random_.Below(3)),
                v.end());
    // A point beside an edge or its line, near a vertex, or anywhere around.
    Point<T> p{};
    switch (random_.Below(3)) {
      case 0:
        p = BesideEdge(v[0], v[1],
                       random_.Below(2) == 0 ? random_.In(-0.1, 1.1)
                                             : random_.In(-1, 1) * 2 / size,
                       Ulps());
        break;
      case 1:
        p = {Moved(v[0].x, Ulps()), Moved(v[0].y, Ulps())};
        break;
      default: {
        const double u = random_.In(-0.5, 1.5);
        const double w = random_.In(-0.5, 1.5);
        const auto mix = [u, w](T a, T b, T c) {
          return static_cast<T>(static_cast<double>(a) * (1 - u - w) +
                                static_cast<double>(b) * u +
                                static_cast<double>(c) * w);
        };
        p = {mix(v[0].x, v[1].x, v[2].x), mix(v[0].y, v[1].y, v[2].y)};
      }
    }
    return {v[0].x, v[0].y, v[1].x, v[1].y, v[2].x, v[2].y, p.x, p.y};
  }

  // Not always admissible.
  Candidate<T> Mutant(const Candidate<T>& c) { return MutantOf<2>(c, random_); }

 private:
  std::int64_t Ulps() { return AnyUlps<T>(random_); }
  double Length() { return AnyLength<T>(random_); }

  Random random_;
};

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_CANDIDATES_H_
