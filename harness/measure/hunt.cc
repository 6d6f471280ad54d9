#include "harness/measure/hunt.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>

#include "harness/measure/candidates.h"
#include "harness/measure/distance_estimate.h"
#include "harness/scenes/scene.h"
#include "harness/truth/weights.h"

namespace pitbench {
namespace {

constexpr std::size_t kStarts = 1024;  // candidates drawn at once
constexpr std::size_t kMutants = 192;  // tried around the best one at once
constexpr int kPatience = 12;          // such batches without a better one
constexpr int kSteps = 300;            // batches of a climb, at the most
template <class T>
class Hunter {
 public:
  Hunter(const Kernel& kernel, double seconds, std::uint64_t seed)
      : kernel_(kernel),
        source_(seed),
        end_(std::chrono::steady_clock::now() +
             std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                 std::chrono::duration<double>(seconds))) {
    scene_.loop = Loop::kPairs;
  }

  bool TimeLeft() const { return std::chrono::steady_clock::now() < end_; }

  // From one random start to where no mutant is worse; nothing if no start of
  // this batch is wrong.
  std::optional<WrongInput<T>> Climb() {
    batch_.clear();
    while (batch_.size() < kStarts) {
      const Candidate<T> c = source_.Draw();
      if (Admissible(c)) batch_.push_back(c);
    }
    std::optional<Scored> best = WorstOfBatch();
    if (!best) return std::nullopt;
    int patience = kPatience;
    for (int step = 0; step < kSteps && patience > 0 && TimeLeft(); ++step) {
      batch_.clear();
      while (batch_.size() < kMutants) {
        const Candidate<T> c = source_.Mutant(best->candidate);
        if (Admissible(c)) batch_.push_back(c);
      }
      const std::optional<Scored> next = WorstOfBatch();
      if (next && next->estimate > best->estimate) {
        // A gain of less than a thousandth is none worth waiting for.
        if (next->estimate > best->estimate * 1.001) patience = kPatience;
        best = next;
      }
      --patience;
    }
    Shorten(*best);
    const Triangle<T> triangle = TriangleOf(best->candidate);
    const Point<T> p = PointOf(best->candidate);
    return WrongInput<T>{triangle, p, best->said_inside, Classify(triangle, p),
                         BoundaryDistanceInUlps(triangle, p)};
  }

 private:
  struct Scored {
    Candidate<T> candidate;
    bool said_inside;
    double estimate;
  };

  // Gives up a hundredth of the distance for coordinates of fewer digits, which
  // are easier to read and to reason about.
  void Shorten(Scored& best) {
    const double enough = 0.99 * best.estimate;
    for (const std::size_t k : {6u, 7u, 0u, 1u, 2u, 3u, 4u, 5u}) {
      batch_.clear();
      for (int digits = 1; digits < std::numeric_limits<T>::digits; ++digits) {
        Candidate<T> c = best.candidate;
        int exponent = 0;
        const T mantissa = std::frexp(c[k], &exponent);
        c[k] = std::ldexp(std::round(std::ldexp(mantissa, digits)),
                          exponent - digits);
        if (Admissible(c)) batch_.push_back(c);
      }
      AskBatch();
      for (std::size_t i = 0; i < batch_.size(); ++i) {
        const std::optional<Scored> shorter = WrongAt(i);
        if (!shorter || shorter->estimate < enough) continue;
        best = *shorter;
        break;
      }
    }
  }

  // Asks the kernel about the batch.
  void AskBatch() {
    Scene<T>& s = scene_;
    for (auto* coordinates :
         {&s.ax, &s.ay, &s.bx, &s.by, &s.cx, &s.cy, &s.px, &s.py}) {
      coordinates->clear();
    }
    for (const Candidate<T>& c : batch_) {
      s.Add(TriangleOf(c));
      s.Add(PointOf(c));
    }
    bits_.resize(BitBytes(batch_.size()));
    if (batch_.empty()) return;
    FunctionOf<T>(kernel_)(s.BatchOf({0, 0, batch_.size()}),
                           Result<T>{.bits = bits_.data()});
  }

  // Candidate i of the batch if its answer is wrong and farther than `least`
  // from the boundary. The cheap question comes first.
  std::optional<Scored> WrongAt(std::size_t i, double least = -1) const {
    const Triangle<T> triangle = TriangleOf(batch_[i]);
    const Point<T> p = PointOf(batch_[i]);
    const double estimate = DistanceEstimate(triangle, p);
    if (estimate <= least) return std::nullopt;
    const bool said_inside = (bits_[i / 8] >> (i % 8) & 1) != 0;
    const Position truth = Classify(triangle, p);
    if (truth == Position::kBoundary ||
        said_inside == (truth == Position::kInside)) {
      return std::nullopt;
    }
    return Scored{batch_[i], said_inside, estimate};
  }

  // The wrong answer to the batch that is farthest from the boundary, if any.
  std::optional<Scored> WorstOfBatch() {
    AskBatch();
    std::optional<Scored> worst;
    for (std::size_t i = 0; i < batch_.size(); ++i) {
      const std::optional<Scored> wrong =
          WrongAt(i, worst ? worst->estimate : -1);
      if (wrong) worst = wrong;
    }
    return worst;
  }

  const Kernel& kernel_;
  CandidateSource<T> source_;
  std::chrono::steady_clock::time_point end_;
  std::vector<Candidate<T>> batch_;
  Scene<T> scene_;
  std::vector<std::uint8_t> bits_;
};

}  // namespace

template <class T>
std::vector<WrongInput<T>> Hunt(const Kernel& kernel, double seconds,
                                std::uint64_t seed, std::size_t keep) {
  Hunter<T> hunter(kernel, seconds, seed);
  std::vector<WrongInput<T>> found;
  while (hunter.TimeLeft()) {
    std::optional<WrongInput<T>> worst = hunter.Climb();
    if (!worst) continue;
    const auto place = std::upper_bound(
        found.begin(), found.end(), *worst,
        [](const WrongInput<T>& one, const WrongInput<T>& other) {
          return one.distance_ulps > other.distance_ulps;
        });
    found.insert(place, *worst);
    if (found.size() > keep) found.pop_back();
  }
  return found;
}

template <class T>
std::string HuntCsv(const Kernel& kernel,
                    const std::vector<WrongInput<T>>& found) {
  const std::string who = std::string(kernel.method.key) + "," +
                          std::string(Name(kernel.scalar)) + ",";
  std::string csv =
      "method,scalar,ax,ay,bx,by,cx,cy,px,py,said,truth,distance_ulps\n";
  if (found.empty()) csv += who + ",,,,,,,,none_found,,\n";
  for (const WrongInput<T>& input : found) {
    const auto& [a, b, c] = input.triangle;
    csv += who;
    for (const T x : {a.x, a.y, b.x, b.y, c.x, c.y, input.p.x, input.p.y}) {
      std::array<char, 40> buffer{};
      std::snprintf(buffer.data(), buffer.size(), "%a,",
                    static_cast<double>(x));
      csv += buffer.data();
    }
    std::array<char, 40> distance{};
    std::snprintf(distance.data(), distance.size(), "%.17g",
                  input.distance_ulps);
    csv += input.said_inside ? "inside," : "outside,";
    csv += std::string(Name(input.truth)) + "," + distance.data() + "\n";
  }
  return csv;
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
