// f32 lanes as f64 lanes: one for one where there is one, else in two halves.
#if defined(PITBENCH_KERNELS_WIDE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PITBENCH_KERNELS_WIDE_INL_H_
#undef PITBENCH_KERNELS_WIDE_INL_H_
#else
#define PITBENCH_KERNELS_WIDE_INL_H_
#endif

#include "kernels/method-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

template <class E, bool kOneLane = kMaxLanes<E> == 1>
struct WideOf {
  using Narrow = hn::Half<E>;
  using Tag = hn::Rebind<double, Narrow>;
};
template <class E>
struct WideOf<E, true> {
  using Narrow = E;
  using Tag = hn::Rebind<double, E>;
};
// f64 lanes for half of E's lanes; for the one lane, if E has one.
template <class E>
using Wide = typename WideOf<E>::Tag;

template <class W>
HWY_INLINE Vec<W> PromotedNumber(W w, const Held<OneLane<float>>& held) {
  const Number<float> number = hn::GetLane(held.In(OneLane<float>()));
  return Set(w, static_cast<Number<double>>(number));
}

// Each of these promotes its half of a vector, or of what a set-up has kept: a
// kept number is promoted before it is broadcast, once for both halves.
template <class E>
struct LowerHalfOf {
  HWY_INLINE Vec<Wide<E>> operator()(Vec<E> v) const {
    const typename WideOf<E>::Narrow narrow;
    if constexpr (kMaxLanes<E> == 1) {
      return hn::PromoteTo(Wide<E>(), v);
    } else {
      return hn::PromoteTo(Wide<E>(), hn::LowerHalf(narrow, v));
    }
  }
  template <class D>
  HWY_INLINE Vec<Wide<E>> operator()(const Held<D>& held) const {
    if constexpr (std::is_same_v<D, OneLane<float>>) {
      return PromotedNumber(Wide<E>(), held);
    } else {
      return (*this)(held.In(E()));
    }
  }
};
#if HWY_TARGET != HWY_SCALAR
template <class E>
struct UpperHalfOf {
  HWY_INLINE Vec<Wide<E>> operator()(Vec<E> v) const {
    const typename WideOf<E>::Narrow narrow;
    return hn::PromoteTo(Wide<E>(), hn::UpperHalf(narrow, v));
  }
  template <class D>
  HWY_INLINE Vec<Wide<E>> operator()(const Held<D>& held) const {
    if constexpr (std::is_same_v<D, OneLane<float>>) {
      return PromotedNumber(Wide<E>(), held);
    } else {
      return (*this)(held.In(E()));
    }
  }
};

// The masks of both halves as one.
#if defined(PITBENCH_COUNTING)
using hn::JoinMasks;
#elif HWY_TARGET == HWY_AVX3
HWY_INLINE hn::Mask512<float> JoinMasks(Lanes<float>, hn::Mask512<double> upper,
                                        hn::Mask512<double> lower) {
  return {static_cast<__mmask16>(_mm512_kunpackb(upper.raw, lower.raw))};
}
#else
template <class E>
HWY_INLINE Mask<E> JoinMasks(E e, Mask<Wide<E>> upper, Mask<Wide<E>> lower) {
  const Wide<E> w;
  return hn::MaskFromVec(
      hn::ConcatEven(e, hn::BitCast(e, hn::VecFromMask(w, upper)),
                     hn::BitCast(e, hn::VecFromMask(w, lower))));
}
#endif
#endif

// Mask `f(half)` of all lanes: f is called with a functor for each half, which
// promotes that half of the lanes of a vector.
template <class E, class F>
HWY_INLINE Mask<E> InHalves(E e, const F& f) {
  if constexpr (kMaxLanes<E> == 1) {
    const Wide<E> w;
    const auto one = IfThenElse(f(LowerHalfOf<E>()), Set(w, 1.0), Zero(w));
    return Gt(hn::DemoteTo(e, one), Zero(e));
  } else {
#if HWY_TARGET != HWY_SCALAR
    return JoinMasks(e, f(UpperHalfOf<E>()), f(LowerHalfOf<E>()));
#endif
  }
}

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

#endif  // include guard that Highway toggles
