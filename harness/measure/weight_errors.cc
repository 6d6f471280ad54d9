#include "harness/measure/weight_errors.h"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>

#include "harness/measure/error_size.h"
#include "harness/truth/scaled_integers.h"
#include "harness/truth/weights.h"

namespace pitbench {
namespace {

using nlohmann::json;

constexpr std::size_t kWeighed = 512;

// |w_a·A + w_b·B + w_c·C − p| in ulps of p's larger coordinate: the sum and the
// difference exactly, the length rounded.
template <class T>
double ForwardError(const std::array<T, 3>& weights,
                    const WeighedAnswer& answer) {
  thread_local std::array<mpz_class, 3> w;
  thread_local std::array<mpz_class, 2> off;
  const int exponent = ScaleToIntegers<T, 3>(weights, w);
  std::array<double, 2> error{};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto& z = answer.coordinates;
    mpz_class& sum = off[axis];
    sum = w[0] * z[axis];
    sum += w[1] * z[2 + axis];
    sum += w[2] * z[4 + axis];
    // The sum is in units of 2^(exponent of weights + of coordinates), p in
    // those of the coordinates: bring both to the smaller.
    if (exponent < 0) {
      sum -= z[6 + axis] << static_cast<mp_bitcnt_t>(-exponent);
    } else {
      sum <<= static_cast<mp_bitcnt_t>(exponent);
      sum -= z[6 + axis];
    }
    long bits = 0;
    const double mantissa = mpz_get_d_2exp(&bits, sum.get_mpz_t());
    error[axis] =
        std::ldexp(mantissa, static_cast<int>(bits) + std::min(exponent, 0) +
                                 answer.exponent - answer.ulp_exponent);
  }
  return std::hypot(error[0], error[1]);
}

}  // namespace

template <class T>
std::vector<WeighedAnswer> WeighAnswers(const Scene<T>& scene) {
  std::vector<WeighedAnswer> weighed;
  if (scene.calls.empty() || scene.loop == Loop::kGrid) return weighed;
  const std::size_t some = kWeighed / scene.calls.size() + 1;
  for (std::size_t c = 0; c < scene.calls.size(); ++c) {
    const Call& call = scene.calls[c];
    for (std::size_t i = 0; i < std::min(call.n, some); ++i) {
      if (weighed.size() == kWeighed) return weighed;
      const Triangle<T> t = scene.TriangleOf(call, i);
      const Point<T> p = scene.PointOf(call, i);
      if (!IsFinite(t, p) || Classify(t, p) == Position::kDegenerate) continue;
      WeighedAnswer& one = weighed.emplace_back();
      one.call = c;
      one.answer = i;
      one.weights = ExactWeights(t, p);
      one.exponent = ScaleToIntegers<T, 8>(
          {t.a.x, t.a.y, t.b.x, t.b.y, t.c.x, t.c.y, p.x, p.y},
          one.coordinates);
      one.ulp_exponent = 0;
      if constexpr (std::floating_point<T>) {
        using Limits = std::numeric_limits<T>;
        const T largest = std::max(std::abs(p.x), std::abs(p.y));
        const int smallest = Limits::min_exponent - 1;
        const int log2 = largest == 0 ? smallest : std::ilogb(largest);
        one.ulp_exponent = std::max(log2, smallest) - (Limits::digits - 1);
      }
    }
  }
  return weighed;
}

template <class T>
json WeightErrors(const Answers<T>& answers,
                  const std::vector<WeighedAnswer>& weighed) {
  ErrorSize of_weights;
  ErrorSize forward;
  std::size_t not_finite = 0;
  mpq_class off;
  for (const WeighedAnswer& one : weighed) {
    std::array<T, 3> computed{};
    bool all_finite = true;
    for (std::size_t k = 0; k < 3; ++k) {
      computed[k] = answers.weights[k][one.call][one.answer];
      if (!std::isfinite(computed[k])) {
        all_finite = false;
        ++not_finite;
        continue;
      }
      // In ulps of 1: that is what their sum is, and the ulp of a weight near
      // 0 would make an error of nothing look like a large one.
      off = static_cast<double>(computed[k]);
      off -= one.weights[k];
      of_weights.Add(std::abs(off.get_d()) /
                     static_cast<double>(std::numeric_limits<T>::epsilon()));
    }
    if (all_finite) forward.Add(ForwardError(computed, one));
  }
  return {{"largest_ulps", of_weights.largest()},
          {"mean_ulps", of_weights.mean()},
          {"not_finite", not_finite},
          {"points", weighed.size()},
          {"largest_forward_ulps", forward.largest()},
          {"mean_forward_ulps", forward.mean()}};
}

template std::vector<WeighedAnswer> WeighAnswers(const Scene<float>&);
template std::vector<WeighedAnswer> WeighAnswers(const Scene<double>&);
template std::vector<WeighedAnswer> WeighAnswers(const Scene<std::int32_t>&);
template std::vector<WeighedAnswer> WeighAnswers(const Scene<std::int16_t>&);
template std::vector<WeighedAnswer> WeighAnswers(const Scene<std::uint8_t>&);
template json WeightErrors(const Answers<float>&,
                           const std::vector<WeighedAnswer>&);
template json WeightErrors(const Answers<double>&,
                           const std::vector<WeighedAnswer>&);

}  // namespace pitbench
