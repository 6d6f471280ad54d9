#include "harness/measure/slices.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "harness/measure/parts.h"

namespace pitbench {
namespace {

// Of slow calls there are fewer passes, so that a repetition sees more of what
// calls differ by.
constexpr double kFewestPasses = 3;
constexpr double kFewestCalls = 16;
// Shorter slices would be as much clock and warm-up as calls.
constexpr double kShortestSliceSeconds = 2e-5;
constexpr double kWarmUpShare = 0.25;
// Longer calls warm themselves up.
constexpr double kLongestWarmUpSeconds = 1e-3;
constexpr std::size_t kCallsBetween = 400;

std::size_t Whole(double x) {
  return static_cast<std::size_t>(std::max(std::floor(x), 1.0));
}

// Seconds a call, in the best of three tries that last long enough to tell.
double Calibrated(const TimedCalls& row) {
  std::size_t count = 1;
  double best = std::numeric_limits<double>::infinity();
  for (int tries = 0; tries < 3;) {
    const double time = std::max(row.time(0, count), 1e-9);
    best = std::min(best, time / static_cast<double>(count));
    if (time < kShortestSliceSeconds) {
      count *= 2;
    } else {
      tries += time < 10 * kSliceSeconds ? 1 : 2;
    }
  }
  return best;
}

// What the passes over one piece of a repetition came to.
struct Piece {
  std::size_t first;  // call
  std::size_t count;
  double fastest = std::numeric_limits<double>::infinity();
  double sum = 0;
  std::size_t calls = 0;
};

// One repetition of one row.
class Window {
 public:
  Window(const TimedCalls& row, const SlicePlan& plan, std::size_t repetition)
      : row_(row), plan_(plan), start_(repetition * plan.window % row.round) {
    for (std::size_t k = 0; k < plan.pieces; ++k) {
      const std::size_t begin = plan.window * k / plan.pieces;
      const std::size_t end = plan.window * (k + 1) / plan.pieces;
      pieces_.push_back({(start_ + begin) % row.round, end - begin});
    }
  }

  void TimeSlice() {
    if (row_.time_parts) {
      row_.time_parts(start_, seconds_);
      parts_.AddPass(seconds_);
      return;
    }
    Piece& piece = pieces_[next_];
    if (plan_.warm_up != 0) {
      const std::size_t back = plan_.warm_up % row_.round;
      row_.time((piece.first + row_.round - back) % row_.round, plan_.warm_up);
    }
    const double time = row_.time(piece.first, piece.count);
    piece.fastest = std::min(piece.fastest, time);
    piece.sum += time;
    piece.calls += piece.count;
  }
  void GoOn() {
    if (++next_ == pieces_.size()) next_ = 0;
  }

  Repetition Result() const {
    if (row_.time_parts) {
      return {parts_.Fastest(),
              parts_.Sum() / static_cast<double>(parts_.Passes()),
              parts_.Passes()};
    }
    double fastest = 0;
    double sum = 0;
    std::size_t calls = 0;
    for (const Piece& piece : pieces_) {
      fastest += piece.fastest;
      sum += piece.sum;
      calls += piece.calls;
    }
    return {fastest / static_cast<double>(plan_.window),
            sum / static_cast<double>(calls), calls};
  }

 private:
  const TimedCalls& row_;
  const SlicePlan& plan_;
  std::size_t start_;
  std::vector<Piece> pieces_;
  PartTimes parts_;  // of a call that is timed so
  std::vector<double> seconds_;
  std::size_t next_ = 0;
};

// Times slices where it is quiet, if that comes soon enough.
class Patience {
 public:
  Patience(const std::function<Quiet()>& look, double times)
      : look_(look),
        times_(times),
        now_(look()),
        start_(std::chrono::steady_clock::now()) {}

  // The next slice of the window, which lasts about `seconds`; at least once,
  // and again until it is quiet before and after or the time for it is over.
  // What earlier slices left of theirs is there for the later ones. Returns the
  // worse of the last two looks.
  Quiet Time(Window& window, double seconds) {
    allowed_ += times_ * seconds;
    Quiet around = Quiet::kDisturbed;
    do {
      while (now_ < Wanted()) now_ = look_();
      const Quiet before = now_;
      window.TimeSlice();
      now_ = look_();
      // Who waited for threads of its own has just been woken up: look again.
      if (now_ < Wanted()) now_ = look_();
      around = std::min(before, now_);
    } while (around < Wanted());
    window.GoOn();
    return around;
  }

 private:
  Quiet Wanted() const {
    const std::chrono::duration<double> passed =
        std::chrono::steady_clock::now() - start_;
    if (passed.count() < allowed_ / 2) return Quiet::kYes;
    return passed.count() < allowed_ ? Quiet::kSlower : Quiet::kDisturbed;
  }

  const std::function<Quiet()>& look_;
  double times_;
  Quiet now_;
  std::chrono::steady_clock::time_point start_;
  double allowed_ = 0;
};

}  // namespace

SlicePlan PlanSlices(double call_seconds, std::size_t round, double seconds) {
  const double most_passes =
      std::clamp(std::floor(seconds / kShortestSliceSeconds), 1.0, kMostPasses);
  const double fewest_passes = std::min(kFewestPasses, most_passes);
  const double calls = seconds / call_seconds;
  std::size_t window = Whole(std::max(
      calls / most_passes, std::min(calls / fewest_passes, kFewestCalls)));
  if (window > round) window -= window % round;
  const double window_seconds = static_cast<double>(window) * call_seconds;
  const std::size_t passes =
      Whole(std::min(seconds / window_seconds, most_passes));
  const std::size_t pieces =
      std::min(Whole(window_seconds / kSliceSeconds + 0.5), window);
  const double warm_up_seconds =
      kWarmUpShare * window_seconds / static_cast<double>(pieces);
  const bool warms_itself = call_seconds > kLongestWarmUpSeconds;
  return {window, pieces, passes,
          warms_itself ? 0 : Whole(warm_up_seconds / call_seconds)};
}

SliceTimes TimeInSlices(const std::vector<TimedCalls>& rows,
                        const SliceBudget& budget, int repetitions,
                        const Surroundings& surroundings) {
  std::vector<SlicePlan> plans;
  std::vector<double> slice_seconds;
  for (const TimedCalls& row : rows) {
    const double call_seconds = Calibrated(row);
    SlicePlan plan = PlanSlices(call_seconds, row.round, budget.seconds);
    if (row.time_parts) {
      plan = {1, 1, PassesOfParts(call_seconds, budget.seconds), 0};
    }
    plans.push_back(plan);
    slice_seconds.push_back(
        call_seconds *
        (static_cast<double>(plan.window) / static_cast<double>(plan.pieces) +
         static_cast<double>(plan.warm_up)));
  }
  std::vector<Window> windows;
  std::vector<std::uint32_t> slices;  // whose, as often as it has some
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (int k = 0; k < repetitions; ++k) {
      slices.insert(slices.end(), plans[row].pieces * plans[row].passes,
                    static_cast<std::uint32_t>(windows.size()));
      windows.emplace_back(rows[row], plans[row], static_cast<std::size_t>(k));
    }
  }
  std::mt19937_64 random;  // NOLINT(cert-msc*): the same order every time
  std::shuffle(slices.begin(), slices.end(), random);
  Patience patience(surroundings.look, budget.patience);
  std::size_t quiet_slices = 0;
  std::size_t calls = 0;
  for (std::size_t k = 0; k < slices.size(); ++k) {
    for (; calls * slices.size() <= k * kCallsBetween; ++calls) {
      surroundings.between(static_cast<double>(calls) / kCallsBetween);
    }
    Window& window = windows[slices[k]];
    const std::size_t row = slices[k] / static_cast<std::size_t>(repetitions);
    const Quiet around = patience.Time(window, slice_seconds[row]);
    if (around != Quiet::kDisturbed) ++quiet_slices;
  }
  SliceTimes times{
      std::vector<std::vector<Repetition>>(rows.size()),
      static_cast<double>(quiet_slices) / static_cast<double>(slices.size())};
  for (std::size_t k = 0; k < windows.size(); ++k) {
    times.rows[k / static_cast<std::size_t>(repetitions)].push_back(
        windows[k].Result());
  }
  return times;
}

}  // namespace pitbench
