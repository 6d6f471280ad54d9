#include "harness/measure/hunt.h"

#include <array>
#include <cstddef>
#include <cstdint>

#include "harness/measure/answers.h"
#include "harness/measure/candidates.h"
#include "harness/measure/climb.h"
#include "harness/measure/distance_estimate.h"
#include "harness/scenes/scene.h"
#include "harness/truth/weights.h"

namespace pitbench {
namespace {

// What climb.h asks of points and triangles.
template <class T>
class PointQuarry : public CandidateSource<T> {
 public:
  using Candidate = pitbench::Candidate<T>;
  using Found = WrongInput<T>;
  // The point's coordinates, then the triangle's.
  static constexpr std::array<std::size_t, 8> kShortenedFirst = {6, 7, 0, 1,
                                                                 2, 3, 4, 5};

  PointQuarry(const Kernel& kernel, std::uint64_t seed)
      : CandidateSource<T>(seed), kernel_(kernel) {
    scene_.loop = Loop::kPairs;
  }

  static bool Admissible(const Candidate& c) {
    return pitbench::Admissible<T>(c);
  }

  void Ask(const std::vector<Candidate>& batch,
           std::vector<std::uint8_t>& bits) {
    Scene<T>& s = scene_;
    for (auto* coordinates :
         {&s.ax, &s.ay, &s.bx, &s.by, &s.cx, &s.cy, &s.px, &s.py}) {
      coordinates->clear();
    }
    for (const Candidate& c : batch) {
      s.Add(TriangleOf(c));
      s.Add(PointOf(c));
    }
    bits.resize(BitBytes(batch.size()));
    if (batch.empty()) return;
    AskCases(kernel_, s.BatchOf({0, 0, batch.size()}), bits.data());
  }

  static double Estimate(const Candidate& c) {
    return DistanceEstimate(TriangleOf(c), PointOf(c));
  }

  static bool IsWrong(const Candidate& c, bool said_inside) {
    const Position truth = Classify(TriangleOf(c), PointOf(c));
    return truth != Position::kBoundary &&
           said_inside != (truth == Position::kInside);
  }

  static Found Report(const Candidate& c, bool said_inside) {
    const Triangle<T> triangle = TriangleOf(c);
    const Point<T> p = PointOf(c);
    return {triangle, p, said_inside, Classify(triangle, p),
            BoundaryDistanceInUlps(triangle, p)};
  }

 private:
  const Kernel& kernel_;
  Scene<T> scene_;
};

}  // namespace

template <class T>
std::vector<WrongInput<T>> Hunt(const Kernel& kernel, double seconds,
                                std::uint64_t seed, std::size_t keep) {
  PointQuarry<T> quarry(kernel, seed);
  return WorstOfClimbs(quarry, seconds, keep);
}

template <class T>
std::string HuntCsv(const Kernel& kernel,
                    const std::vector<WrongInput<T>>& found) {
  std::vector<HuntRow> rows;
  for (const WrongInput<T>& input : found) {
    HuntRow row{.said = input.said_inside ? "inside" : "outside",
                .truth = Name(input.truth),
                .distance_ulps = input.distance_ulps};
    const auto& [a, b, c] = input.triangle;
    for (const Point<T>& q : {a, b, c, input.p}) {
      row.coordinates.push_back(static_cast<double>(q.x));
      row.coordinates.push_back(static_cast<double>(q.y));
    }
    rows.push_back(row);
  }
  return HuntLines(kernel.method.key, Name(kernel.scalar),
                   "ax,ay,bx,by,cx,cy,px,py", rows);
}

template std::vector<WrongInput<float>> Hunt(const Kernel&, double,
                                             std::uint64_t, std::size_t);
template std::vector<WrongInput<double>> Hunt(const Kernel&, double,
                                              std::uint64_t, std::size_t);
template std::string HuntCsv(const Kernel&,
                             const std::vector<WrongInput<float>>&);
template std::string HuntCsv(const Kernel&,
                             const std::vector<WrongInput<double>>&);

}  // namespace pitbench
