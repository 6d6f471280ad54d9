// What every method is written with: lanes of triangles, values kept from the
// set-up, the winding, and the masks that decide.
//
// A method is a class template over a Highway tag D, set up from one triangle
// a lane. Where D has one lane, its points may come in any wider tag: the kept
// values are then broadcast. So one text serves a single triangle as well as a
// vector of them.
//
//   template <class D> class M {
//    public:
//     M(D d, const Triangles<D>& t);                       the set-up
//     template <class E> Mask<E> Inside(E e, Vec<E> x, Vec<E> y) const;
//     template <class E> void Weights(E e, Vec<E> x, Vec<E> y,
//                                     Vec<E>& wa, Vec<E>& wb, Vec<E>& wc)
//                                     const;
//   };
//
// A triangle that is degenerate or not finite contains nothing, and a point
// that is not finite is outside: by arithmetic, lane by lane, so without a
// test.
#if defined(PITBENCH_KERNELS_METHOD_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PITBENCH_KERNELS_METHOD_INL_H_
#undef PITBENCH_KERNELS_METHOD_INL_H_
#else
#define PITBENCH_KERNELS_METHOD_INL_H_
#endif

#include <limits>
#include <type_traits>

#include "kernels/isa-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

namespace hn = hwy::HWY_NAMESPACE;

using hn::Abs;
using hn::Add;
using hn::And;
using hn::Div;
using hn::Ge;
using hn::Gt;
using hn::IfThenElse;
using hn::Le;
using hn::Lt;
using hn::Mask;
using hn::Mul;
using hn::MulAdd;
using hn::MulSub;
using hn::NegMulAdd;
using hn::Or;
using hn::Set;
using hn::Sub;
using hn::TFromD;
using hn::Vec;
using hn::Zero;

template <class T>
using OneLane = hn::CappedTag<T, 1>;

// As many as the ISA has, but no more than the bits of one word.
template <class T>
using Lanes = std::conditional_t<(sizeof(T) < 4), hn::CappedTag<T, 64>,
                                 hn::ScalableTag<T>>;

// A number that a set-up computes with; one that counts, where that is asked.
#if defined(PITBENCH_COUNTING)
using hn::Number;
#else
template <class T>
using Number = T;
#endif

// No vector of tag D has more lanes than this.
template <class D>
inline constexpr std::size_t kMaxLanes = hn::MaxLanes(D());

// `v`, to be kept in a register. Without this the compiler makes what was
// loaded an operand in memory of every instruction that uses it, and reading it
// again each time takes longer than the arithmetic.
template <class V>
HWY_INLINE V InRegister(V v) {
#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR && !defined(PITBENCH_COUNTING)
#if HWY_TARGET == HWY_AVX3
  asm("" : "+v"(v.raw));
#else
  asm("" : "+x"(v.raw));
#endif
#endif
  return v;
}

// The triangles from which a method is set up: element i of each array is lane
// i. Every array holds at least as many elements as D has lanes. Vectors of
// known size are loaded once.
template <class D>
struct Triangles {
  using T = TFromD<D>;
  D d;
  const T* ax;
  const T* ay;
  const T* bx;
  const T* by;
  const T* cx;
  const T* cy;

#if HWY_HAVE_SCALABLE
  HWY_INLINE Vec<D> Ax() const { return hn::LoadU(d, ax); }
  HWY_INLINE Vec<D> Ay() const { return hn::LoadU(d, ay); }
  HWY_INLINE Vec<D> Bx() const { return hn::LoadU(d, bx); }
  HWY_INLINE Vec<D> By() const { return hn::LoadU(d, by); }
  HWY_INLINE Vec<D> Cx() const { return hn::LoadU(d, cx); }
  HWY_INLINE Vec<D> Cy() const { return hn::LoadU(d, cy); }
#else
  Vec<D> loaded[6] = {
      InRegister(hn::LoadU(d, ax)), InRegister(hn::LoadU(d, ay)),
      InRegister(hn::LoadU(d, bx)), InRegister(hn::LoadU(d, by)),
      InRegister(hn::LoadU(d, cx)), InRegister(hn::LoadU(d, cy))};

  HWY_INLINE Vec<D> Ax() const { return loaded[0]; }
  HWY_INLINE Vec<D> Ay() const { return loaded[1]; }
  HWY_INLINE Vec<D> Bx() const { return loaded[2]; }
  HWY_INLINE Vec<D> By() const { return loaded[3]; }
  HWY_INLINE Vec<D> Cx() const { return loaded[4]; }
  HWY_INLINE Vec<D> Cy() const { return loaded[5]; }
#endif

  // For a method that uses them once: what is an operand in memory needs no
  // instruction that loads it.
  HWY_INLINE Vec<D> AxUsedOnce() const { return hn::LoadU(d, ax); }
  HWY_INLINE Vec<D> AyUsedOnce() const { return hn::LoadU(d, ay); }
  HWY_INLINE Vec<D> BxUsedOnce() const { return hn::LoadU(d, bx); }
  HWY_INLINE Vec<D> ByUsedOnce() const { return hn::LoadU(d, by); }
  HWY_INLINE Vec<D> CxUsedOnce() const { return hn::LoadU(d, cx); }
  HWY_INLINE Vec<D> CyUsedOnce() const { return hn::LoadU(d, cy); }
};

// A value that the set-up keeps for the points. One lane is kept as a number
// and broadcast; a scalable vector, which no class may hold, in memory.
template <class D>
class Held {
  using T = TFromD<D>;
  static constexpr bool kOneLane = std::is_same_v<D, OneLane<T>>;

 public:
  HWY_INLINE Held(D d, Vec<D> v) {
    if constexpr (kOneLane) {
      (void)d;
      kept_ = hn::GetLane(v);
    } else if constexpr (HWY_HAVE_SCALABLE) {
      hn::StoreU(v, d, kept_);
    } else {
      (void)d;
      kept_ = v;
    }
  }

  template <class E>
  HWY_INLINE Vec<E> In(E e) const {
    if constexpr (kOneLane) {
      return Set(e, kept_);
    } else {
      static_assert(std::is_same_v<D, E>, "many triangles need their own tag");
      if constexpr (HWY_HAVE_SCALABLE) {
        return hn::LoadU(e, kept_);
      } else {
        return kept_;
      }
    }
  }

 private:
#if HWY_HAVE_SCALABLE
  std::conditional_t<kOneLane, T, T[HWY_MAX_BYTES / sizeof(T)]> kept_;
#else
  std::conditional_t<kOneLane, Number<T>, Vec<D>> kept_;
#endif
};

// a·b + c·d and a·b − c·d. With kFma the first product is not rounded: what a
// compiler makes of them that may contract.
template <bool kFma, class V>
HWY_INLINE V SumOfProducts(V a, V b, V c, V d) {
  if constexpr (kFma) {
    return MulAdd(a, b, Mul(c, d));
  } else {
    return Add(Mul(a, b), Mul(c, d));
  }
}
template <bool kFma, class V>
HWY_INLINE V DifferenceOfProducts(V a, V b, V c, V d) {
  if constexpr (kFma) {
    return MulSub(a, b, Mul(c, d));
  } else {
    return Sub(Mul(a, b), Mul(c, d));
  }
}

// a·b − c·d within 1.5 ulp by Kahan's algorithm: what it gets has the sign of
// the exact value unless c·d or its rounding error underflows.
template <class V>
HWY_INLINE V KahanDifference(V a, V b, V c, V d) {
  const V cd = Mul(c, d);
  return Add(MulSub(a, b, cd), NegMulAdd(c, d, cd));
}

// Twice the signed area of ABC, from vertex A. Not for a method that contracts
// to decide by whether the triangle is degenerate: with two equal vertices it
// is the cross product of a vector with itself, which contraction makes other
// than 0.
template <class D>
HWY_INLINE Vec<D> DoubleArea(const Triangles<D>& t) {
  const auto ax = t.Ax();
  const auto ay = t.Ay();
  return Sub(Mul(Sub(t.Bx(), ax), Sub(t.Cy(), ay)),
             Mul(Sub(t.By(), ay), Sub(t.Cx(), ax)));
}

#if HWY_TARGET == HWY_AVX3
// Where v is neither 0 nor infinite nor NaN: where −|v| is finite and below 0.
inline constexpr int kFiniteBelowZero = 0x40;
template <class T>
HWY_INLINE hn::Vec512<T> MinusMagnitude(hn::Vec512<T> v) {
  return hn::Or(v, Set(hn::DFromV<hn::Vec512<T>>(), T{-0.0}));
}
HWY_INLINE hn::Mask512<float> FiniteNonZero(hn::Vec512<float> v) {
  return {_mm512_fpclass_ps_mask(MinusMagnitude(v).raw, kFiniteBelowZero)};
}
HWY_INLINE hn::Mask512<double> FiniteNonZero(hn::Vec512<double> v) {
  return {_mm512_fpclass_pd_mask(MinusMagnitude(v).raw, kFiniteBelowZero)};
}
// `value` with what stands in kResponses for the class of v: a digit each, from
// the lowest, for a quiet NaN, a signalling one, 0, 1, −∞, +∞, below and above
// 0. The digit 0 leaves `value`, 3 means NaN, 9 is −1 and A is 1. It spares a
// compare, and each compare writes a mask, which is dear.
template <unsigned kResponses>
HWY_INLINE hn::Vec512<float> ByClass(hn::Vec512<float> value,
                                     hn::Vec512<float> v) {
  const auto responses = _mm512_set1_epi32(static_cast<int>(kResponses));
  return {_mm512_fixupimm_ps(value.raw, v.raw, responses, 0)};
}
template <unsigned kResponses>
HWY_INLINE hn::Vec512<double> ByClass(hn::Vec512<double> value,
                                      hn::Vec512<double> v) {
  const auto responses = _mm512_set1_epi64(kResponses);
  return {_mm512_fixupimm_pd(value.raw, v.raw, responses, 0)};
}
// Whether these take a vector of D.
template <class D>
inline constexpr bool kHasClasses = sizeof(Vec<D>) == 64;
#else
template <class D>
inline constexpr bool kHasClasses = false;
#endif

// Where `area` is neither 0 nor infinite nor NaN. An infinite or NaN coordinate
// always makes DoubleArea infinite or NaN, so a method whose kept values are
// all NaN elsewhere contains nothing then.
template <class D>
HWY_INLINE Mask<D> IsValidArea(D d, Vec<D> area) {
  if constexpr (kHasClasses<D>) {
    return FiniteNonZero(area);
  } else {
    const auto size = Abs(area);
    return And(Gt(size, Zero(d)),
               Lt(size, Set(d, std::numeric_limits<TFromD<D>>::infinity())));
  }
}

// `value` where the area is valid, NaN elsewhere.
template <class D>
HWY_INLINE Vec<D> ValidOrNaN(D d, Vec<D> area, Vec<D> value) {
  if constexpr (kHasClasses<D>) {
    return ByClass<0x330333>(value, area);
  } else {
    return IfThenElse(IsValidArea(d, area), value,
                      Set(d, std::numeric_limits<TFromD<D>>::quiet_NaN()));
  }
}

// +1 for a counter-clockwise triangle, −1 for a clockwise one, NaN for one
// that contains nothing. A product with it is exact.
template <class D>
HWY_INLINE Vec<D> Winding(D d, Vec<D> area) {
  if constexpr (kHasClasses<D>) {
    return ByClass<0xA933A333>(area, area);
  } else {
    return ValidOrNaN(d, area, hn::CopySignToAbs(Set(d, TFromD<D>{1}), area));
  }
}

// `v` with its sign changed where that of `area` is set.
template <class D>
HWY_INLINE Vec<D> TurnedBy(D d, Vec<D> v, Vec<D> area) {
  const auto sign = Set(d, TFromD<D>{-0.0});
#if HWY_TARGET == HWY_AVX3
  if constexpr (sizeof(v) == 64) {
    const hn::RebindToUnsigned<D> du;
    constexpr int kXorOfAnd = 0xF0 ^ (0xCC & 0xAA);
    return hn::BitCast(d, Vec<decltype(du)>{_mm512_ternarylogic_epi64(
                              hn::BitCast(du, v).raw, hn::BitCast(du, area).raw,
                              hn::BitCast(du, sign).raw, kXorOfAnd)});
  }
#endif
  return hn::Xor(v, And(area, sign));
}

// `mask` and a ≥ b (≤, <); false where a or b is NaN. AVX-512
// compares under a mask, which spares the And of two mask registers and the
// port it needs.
#if defined(PITBENCH_COUNTING)
using hn::AndGe;
using hn::AndLe;
using hn::AndLt;
#elif HWY_TARGET == HWY_AVX3
template <int kPredicate>
HWY_INLINE hn::Mask512<float> AndCompare(hn::Mask512<float> mask,
                                         hn::Vec512<float> a,
                                         hn::Vec512<float> b) {
  return {_mm512_mask_cmp_ps_mask(mask.raw, a.raw, b.raw, kPredicate)};
}
template <int kPredicate>
HWY_INLINE hn::Mask512<double> AndCompare(hn::Mask512<double> mask,
                                          hn::Vec512<double> a,
                                          hn::Vec512<double> b) {
  return {_mm512_mask_cmp_pd_mask(mask.raw, a.raw, b.raw, kPredicate)};
}
template <class M, class V>
HWY_INLINE M AndGe(M mask, V a, V b) {
  return AndCompare<_CMP_GE_OQ>(mask, a, b);
}
template <class M, class V>
HWY_INLINE M AndLe(M mask, V a, V b) {
  return AndCompare<_CMP_LE_OQ>(mask, a, b);
}
template <class M, class V>
HWY_INLINE M AndLt(M mask, V a, V b) {
  return AndCompare<_CMP_LT_OQ>(mask, a, b);
}
#else
template <class M, class V>
HWY_INLINE M AndGe(M mask, V a, V b) {
  return And(mask, Ge(a, b));
}
template <class M, class V>
HWY_INLINE M AndLe(M mask, V a, V b) {
  return And(mask, Le(a, b));
}
template <class M, class V>
HWY_INLINE M AndLt(M mask, V a, V b) {
  return And(mask, Lt(a, b));
}
#endif

// `v`, or NaN where `a` is not finite: in the units that multiply, which where
// masks are vectors have less to do than those that compare.
template <class D>
HWY_INLINE Vec<D> NaNUnlessFinite(D d, Vec<D> v, Vec<D> a) {
  return MulAdd(a, Zero(d), v);
}

// min(a, b) as x86 has it: b where either is NaN. Spelt out where Highway's Min
// does something else with NaN, so that all ISAs give the same bits.
template <class V>
HWY_INLINE V MinOrSecond(V a, V b) {
#if defined(PITBENCH_COUNTING) || (HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR)
  return hn::Min(a, b);
#else
  return IfThenElse(Lt(a, b), a, b);
#endif
}

// max(a, b) in the same way.
template <class V>
HWY_INLINE V MaxOrSecond(V a, V b) {
#if defined(PITBENCH_COUNTING) || (HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR)
  return hn::Max(a, b);
#else
  return IfThenElse(Gt(a, b), a, b);
#endif
}

// Whether u ≥ 0, v ≥ 0 and w ≥ 0; false where v or w is NaN. Where only u is,
// it is v and w that decide: a method must see to it that they do not then
// accept a point that is not finite. A minimum and two compares take less time
// than three compares that depend on each other through their masks.
template <class D>
HWY_INLINE Mask<D> AllNonNegative(D d, Vec<D> u, Vec<D> v, Vec<D> w) {
  if constexpr (std::is_integral_v<TFromD<D>>) {
    return Gt(hn::Or(hn::Or(u, v), w), Set(d, TFromD<D>{-1}));
  } else {
    const auto zero = Zero(d);
    return AndGe(Ge(MinOrSecond(u, v), zero), w, zero);
  }
}

// Whether u ≥ least_u, v ≥ least_v and w ≥ least_w; false where any is NaN.
template <class V>
HWY_INLINE auto AllAtLeast(V u, V least_u, V v, V least_v, V w, V least_w) {
  return AndGe(AndGe(Ge(u, least_u), v, least_v), w, least_w);
}

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

#endif  // include guard that Highway toggles
