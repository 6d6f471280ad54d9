// The climb that every hunt makes (hunt.h, rays/ray_hunt.h): from a random
// start that is answered wrongly to where no change makes it worse.
//
// What is hunted is a class
//
//   class Quarry {
//    public:
//     using Candidate = std::array<T, kCount>;    the coordinates of an input
//     using Found = …;                            with distance_ulps
//     static constexpr std::array<std::size_t, kCount> kShortenedFirst;
//     Candidate Draw();
//     Candidate Mutant(const Candidate&);
//     static bool Admissible(const Candidate&);   neither need be
//     void Ask(const std::vector<Candidate>&, std::vector<std::uint8_t>& bits);
//     static double Estimate(const Candidate&);   of the distance, quickly
//     bool IsWrong(const Candidate&, bool said_inside) const;
//     Found Report(const Candidate&, bool said_inside) const;
//   };
#ifndef PITBENCH_HARNESS_MEASURE_CLIMB_H_
#define PITBENCH_HARNESS_MEASURE_CLIMB_H_

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pitbench {

template <class Quarry>
class Climber {
 public:
  using Candidate = typename Quarry::Candidate;
  using Found = typename Quarry::Found;

  Climber(Quarry& quarry, double seconds)
      : quarry_(quarry),
        end_(std::chrono::steady_clock::now() +
             std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                 std::chrono::duration<double>(seconds))) {}

  bool TimeLeft() const { return std::chrono::steady_clock::now() < end_; }

  // From one random start to where no mutant is worse; nothing if no start of
  // this batch is wrong.
  std::optional<Found> Climb() {
    batch_.clear();
    while (batch_.size() < kStarts) {
      const Candidate c = quarry_.Draw();
      if (Quarry::Admissible(c)) batch_.push_back(c);
    }
    std::optional<Scored> best = WorstOfBatch();
    if (!best) return std::nullopt;
    int patience = kPatience;
    for (int step = 0; step < kSteps && patience > 0 && TimeLeft(); ++step) {
      batch_.clear();
      while (batch_.size() < kMutants) {
        const Candidate c = quarry_.Mutant(best->candidate);
        if (Quarry::Admissible(c)) batch_.push_back(c);
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
    return quarry_.Report(best->candidate, best->said_inside);
  }

 private:
  static constexpr std::size_t kStarts = 1024;  // candidates drawn at once
  static constexpr std::size_t kMutants = 192;  // tried around the best one
  static constexpr int kPatience = 12;  // such batches without a better one
  static constexpr int kSteps = 300;    // batches of a climb, at the most

  struct Scored {
    Candidate candidate;
    bool said_inside;
    double estimate;
  };

  // Gives up a hundredth of the distance for coordinates of fewer digits, which
  // are easier to read and to reason about.
  void Shorten(Scored& best) {
    using T = typename Candidate::value_type;
    const double enough = 0.99 * best.estimate;
    for (const std::size_t k : Quarry::kShortenedFirst) {
      batch_.clear();
      for (int digits = 1; digits < std::numeric_limits<T>::digits; ++digits) {
        Candidate c = best.candidate;
        int exponent = 0;
        const T mantissa = std::frexp(c[k], &exponent);
        c[k] = std::ldexp(std::round(std::ldexp(mantissa, digits)),
                          exponent - digits);
        if (Quarry::Admissible(c)) batch_.push_back(c);
      }
      quarry_.Ask(batch_, bits_);
      for (std::size_t i = 0; i < batch_.size(); ++i) {
        const std::optional<Scored> shorter = WrongAt(i);
        if (!shorter || shorter->estimate < enough) continue;
        best = *shorter;
        break;
      }
    }
  }

  // Candidate i of the batch if its answer is wrong and farther than `least`
  // from the boundary. The cheap question comes first.
  std::optional<Scored> WrongAt(std::size_t i, double least = -1) const {
    const double estimate = Quarry::Estimate(batch_[i]);
    if (estimate <= least) return std::nullopt;
    const bool said_inside = (bits_[i / 8] >> (i % 8) & 1) != 0;
    if (!quarry_.IsWrong(batch_[i], said_inside)) return std::nullopt;
    return Scored{batch_[i], said_inside, estimate};
  }

  // The wrong answer to the batch that is farthest from the boundary, if any.
  std::optional<Scored> WorstOfBatch() {
    quarry_.Ask(batch_, bits_);
    std::optional<Scored> worst;
    for (std::size_t i = 0; i < batch_.size(); ++i) {
      const std::optional<Scored> wrong =
          WrongAt(i, worst ? worst->estimate : -1);
      if (wrong) worst = wrong;
    }
    return worst;
  }

  Quarry& quarry_;
  std::chrono::steady_clock::time_point end_;
  std::vector<Candidate> batch_;
  std::vector<std::uint8_t> bits_;
};

// The worst of each climb that was made in about that time, the worst first,
// at most `keep`.
template <class Quarry>
std::vector<typename Quarry::Found> WorstOfClimbs(Quarry& quarry,
                                                  double seconds,
                                                  std::size_t keep) {
  using Found = typename Quarry::Found;
  Climber<Quarry> climber(quarry, seconds);
  std::vector<Found> found;
  while (climber.TimeLeft()) {
    const std::optional<Found> worst = climber.Climb();
    if (!worst) continue;
    const auto place =
        std::upper_bound(found.begin(), found.end(), *worst,
                         [](const Found& one, const Found& other) {
                           return one.distance_ulps > other.distance_ulps;
                         });
    found.insert(place, *worst);
    if (found.size() > keep) found.pop_back();
  }
  return found;
}

// The lines of a hunt's CSV file. `columns` name the coordinates, `row` gives
// those of an input, and the words for what was said and for the truth.
struct HuntRow {
  std::vector<double> coordinates;
  std::string_view said;
  std::string_view truth;
  double distance_ulps;
};
std::string HuntLines(std::string_view method, std::string_view scalar,
                      std::string_view columns,
                      const std::vector<HuntRow>& rows);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_CLIMB_H_
