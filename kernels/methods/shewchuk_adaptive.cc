// Point in triangle by Shewchuk's adaptive orient2d (1997), our own code from
// the published formulas.
//
//   (v − P) × (w − P) ≥ 0 for each edge vw; where the rounded determinant is
//   below A·(|left| + |right|), A = (3 + 16u)u, by exact expansions
//
// Set-up: the orientation of the triangle, adaptively, by which B and C are
// exchanged. Per point: 9 subtractions, 9 multiplications, 3 additions, 6
// absolute values, 6 compares; an undecided point costs some hundred to
// thousand operations of one lane. A point that is surely beyond one edge is
// decided whatever the others say.
// Boundary: closed. Winding: fixed by the set-up. Degenerate: contains nothing.
// Right where every coordinate is 0 or of magnitude 2^-50 to 2^62 in f32,
// 2^-484 to 2^510 in f64. Fails: outside that range. Products that underflow
// look like a point on the edge; those that overflow like one outside.
// Worst known f32 inputs, A B C p (tests/worst_inputs.csv has f64 as well):
//   shewchuk_adaptive: none found
// by `pitbench hunt`, whose coordinates are 2^-30 to 1, those of P at least
// 1/2; report/recipes.csv has inputs elsewhere.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/methods/shewchuk_adaptive.cc"
#include <hwy/foreach_target.h>

#include "kernels/adaptive-inl.h"
#include "kernels/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

struct ShewchukFilter {
  static constexpr bool kMayEqual = true;

  template <class T>
  static HWY_INLINE T BoundOf(T left, T right) {
    return Bound<T>::a * (std::abs(left) + std::abs(right));
  }
  template <class D>
  static HWY_INLINE Vec<D> BoundOf(D d, Vec<D> left, Vec<D> right) {
    return Mul(Set(d, Bound<TFromD<D>>::a), Add(Abs(left), Abs(right)));
  }
};

template <class D>
using ShewchukAdaptive = Adaptive<D, ShewchukFilter>;

constexpr Method kShewchukAdaptive{
    .key = "shewchuk_adaptive",
    .source = "Shewchuk 1997",
    .formula = "(v − P) × (w − P) ≥ 0 for each edge vw, adaptively exact",
};

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

PITBENCH_KERNELS(shewchuk_adaptive,
                 FloatRows<ShewchukAdaptive>(kShewchukAdaptive));
