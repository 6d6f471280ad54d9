// Point in triangle by the filter of Ozaki, Bünger, Ogita, Oishi and Rump
// (2016) and, where it does not decide, Shewchuk's expansions; our own code
// from the published formulas.
//
//   (v − P) × (w − P) ≥ 0 for each edge vw; where the magnitude of the rounded
//   determinant is not above θ·(|left + right| + u_N), by exact expansions
//   θ = 3u − (φ − 22)u², φ = 2⌊(−1 + √(4/u + 45))/4⌋; u_N: least normal number
//
// θ is a little less than Shewchuk's bound, and one absolute value suffices:
// where left and right have different signs, their sum is less than their
// difference, which decides. u_N keeps the filter from deciding by products
// that underflow.
// Set-up: the orientation of the triangle, adaptively, by which B and C are
// exchanged. Per point: 9 subtractions, 9 multiplications, 6 additions, 3
// absolute values, 6 compares; an undecided point costs some hundred to
// thousand operations of one lane.
// Boundary: closed. Winding: fixed by the set-up. Degenerate: contains nothing.
// Right where shewchuk_adaptive is: every coordinate is 0 or of magnitude 2^-50
// to 2^62 in f32, 2^-484 to 2^510 in f64. Fails: outside that range. The filter
// itself holds down to subnormal numbers, but what it leaves there expansions
// cannot tell either; what overflows looks like a point outside.
// Worst known f32 inputs, A B C p (tests/worst_inputs.csv has f64 as well):
//   ozaki_adaptive: none found
// by `pitbench hunt`, whose coordinates are 2^-30 to 1, those of P at least
// 1/2; report/recipes.csv has inputs elsewhere.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/methods/ozaki_adaptive.cc"
#include <hwy/foreach_target.h>

#include "kernels/adaptive-inl.h"
#include "kernels/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

template <class T>
struct Theta {
  static constexpr T u = std::numeric_limits<T>::epsilon() / 2;
  static constexpr T phi = sizeof(T) == 4 ? 4094 : 94906264;
  static constexpr T value = (3 - (phi - 22) * u) * u;
};

struct OzakiFilter {
  static constexpr bool kMayEqual = false;

  template <class T>
  static HWY_INLINE T BoundOf(T left, T right) {
    return Theta<T>::value *
           (std::abs(left + right) + std::numeric_limits<T>::min());
  }
  template <class D>
  static HWY_INLINE Vec<D> BoundOf(D d, Vec<D> left, Vec<D> right) {
    using T = TFromD<D>;
    return Mul(
        Set(d, Theta<T>::value),
        Add(Abs(Add(left, right)), Set(d, std::numeric_limits<T>::min())));
  }
};

template <class D>
using OzakiAdaptive = Adaptive<D, OzakiFilter>;

constexpr Method kOzakiAdaptive{
    .key = "ozaki_adaptive",
    .source = "Ozaki et al. 2016; Shewchuk 1997",
    .formula = "(v − P) × (w − P) ≥ 0 for each edge vw, adaptively exact",
};

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

PITBENCH_KERNELS(ozaki_adaptive, FloatRows<OzakiAdaptive>(kOzakiAdaptive));
