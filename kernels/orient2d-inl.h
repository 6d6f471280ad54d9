// Shewchuk's adaptive orient2d (1997) for one lane: the sign of the area of a
// triangle by exact arithmetic on floating-point expansions, no further than it
// takes, behind a filter of choice.
//
// A Filter bounds the error of the rounded determinant left − right of rounded
// differences: BoundOf(left, right), of numbers, and BoundOf(d, left, right),
// of vectors. A determinant decides whose magnitude is above its bound, or, if
// kMayEqual, equal to it.
//
// An expansion is a sum of numbers of which none overlaps the next larger one,
// so that the largest that is not 0 has the sign of the sum. Exact as long as
// nothing overflows or underflows: every coordinate is 0 or of magnitude 2^-50
// to 2^62 in f32, 2^-484 to 2^510 in f64 (then the product of two last bits is
// not below the smallest subnormal number).
#if defined(PITBENCH_KERNELS_ORIENT2D_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PITBENCH_KERNELS_ORIENT2D_INL_H_
#undef PITBENCH_KERNELS_ORIENT2D_INL_H_
#else
#define PITBENCH_KERNELS_ORIENT2D_INL_H_
#endif

#include <cmath>

#include "kernels/method-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

// Shewchuk's error bounds: `a` of the determinant from rounded differences (his
// filter), relative to |left| + |right|; `b` of the same with exact products;
// `c` with the first order of what the differences lost; `estimate` of an
// expansion added up.
template <class T>
struct Bound {
  static constexpr T u = std::numeric_limits<T>::epsilon() / 2;
  static constexpr T a = (3 + 16 * u) * u;
  static constexpr T b = (2 + 12 * u) * u;
  static constexpr T c = (9 + 64 * u) * u * u;
  static constexpr T estimate = (3 + 8 * u) * u;
};

// high + low is exact, and high is the rounded result.
template <class T>
struct Pair {
  T high, low;
};

// Knuth's.
template <class T>
HWY_INLINE Pair<T> TwoSum(T a, T b) {
  const T sum = a + b;
  const T of_b = sum - a;
  const T of_a = sum - of_b;
  return {sum, (a - of_a) + (b - of_b)};
}

// The upper half of the bits, and the rest (Dekker, Veltkamp).
template <class T>
HWY_INLINE Pair<T> Split(T a) {
  constexpr int kHalf = (std::numeric_limits<T>::digits + 1) / 2;
  constexpr T kSplitter = T{1 << kHalf} + 1;
  const T c = kSplitter * a;
  const T high = c - (c - a);
  return {high, a - high};
}

// Dekker's.
template <class T>
HWY_INLINE Pair<T> TwoProduct(T a, T b) {
  const T product = a * b;
  const Pair<T> s = Split(a);
  const Pair<T> t = Split(b);
  const T error =
      ((product - s.high * t.high) - s.low * t.high) - s.high * t.low;
  return {product, s.low * t.low - error};
}

template <class T>
struct Expansion {
  T part[16];
  int size = 0;

  // Shewchuk's Grow-Expansion; zeros stay where they are.
  HWY_INLINE void Add(T b) {
    T carry = b;
    for (int i = 0; i < size; ++i) {
      const Pair<T> sum = TwoSum(carry, part[i]);
      part[i] = sum.low;
      carry = sum.high;
    }
    part[size++] = carry;
  }
  HWY_INLINE void AddProduct(T a, T b) {
    const Pair<T> product = TwoProduct(a, b);
    Add(product.low);
    Add(product.high);
  }
  HWY_INLINE T Estimate() const {
    T sum = 0;
    for (int i = 0; i < size; ++i) sum += part[i];
    return sum;
  }
  // A number with the sign of the expansion.
  HWY_INLINE T Largest() const {
    int i = size - 1;
    while (i > 0 && part[i] == 0) --i;
    return part[i];
  }
};

// A number with the sign of (a − p) × (b − p); NaN where a step overflowed and
// left nothing.
template <class Filter, class T>
static HWY_NOINLINE T Orient2d(T ax, T ay, T bx, T by, T px, T py) {
  const Pair<T> u = TwoSum(ax, -px);
  const Pair<T> v = TwoSum(ay, -py);
  const Pair<T> w = TwoSum(bx, -px);
  const Pair<T> z = TwoSum(by, -py);
  const T left = u.high * z.high;
  const T right = v.high * w.high;
  T det = left - right;
  const T bound_of_filter = Filter::BoundOf(left, right);
  if (std::abs(det) > bound_of_filter ||
      (Filter::kMayEqual && std::abs(det) == bound_of_filter)) {
    return det;
  }

  Expansion<T> exact;
  exact.AddProduct(u.high, z.high);
  exact.AddProduct(-v.high, w.high);
  if (u.low == 0 && v.low == 0 && w.low == 0 && z.low == 0) {
    return exact.Largest();
  }
  det = exact.Estimate();
  const T sum = std::abs(left) + std::abs(right);
  if (std::abs(det) >= Bound<T>::b * sum) return det;

  const T bound = Bound<T>::c * sum + Bound<T>::estimate * std::abs(det);
  det += (u.high * z.low + z.high * u.low) - (v.high * w.low + w.high * v.low);
  if (std::abs(det) >= bound) return det;

  exact.AddProduct(u.low, z.high);
  exact.AddProduct(u.high, z.low);
  exact.AddProduct(u.low, z.low);
  exact.AddProduct(-v.low, w.high);
  exact.AddProduct(-v.high, w.low);
  exact.AddProduct(-v.low, w.low);
  return exact.Largest();
}

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

#endif  // include guard that Highway toggles
