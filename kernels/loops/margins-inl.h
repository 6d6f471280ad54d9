// Margins: what a filter of an exact method gives of an item, so that it is
// told inside or outside for certain, or not decided.
//
// A filter gives each item a margin: above t it is inside, below −t it is not,
// and between nothing is decided. Their form is that in which an ISA judges a
// block of them soonest:
// - On x86 from SSE4 on, which compares integers without sign as fast as
//   numbers, t − margin takes its place (kTurned): its sign bit says inside,
//   above 2t is outside, and as integers without sign nothing is less than what
//   is undecided.
// - On AVX-512, which takes the upper halves of two vectors in one instruction,
//   these alone are judged (kHalved): half as many compares, whose masks are
//   what is slow there.
// - Elsewhere, if there are fused multiply-adds, margins are multiplied by a
//   power of two that makes t at least 1 and less than 2: what is decided, from
//   ±2 on, has the highest bit of its exponent set (kScaled).
#if defined(PITBENCH_KERNELS_LOOPS_MARGINS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PITBENCH_KERNELS_LOOPS_MARGINS_INL_H_
#undef PITBENCH_KERNELS_LOOPS_MARGINS_INL_H_
#else
#define PITBENCH_KERNELS_LOOPS_MARGINS_INL_H_
#endif

#include <cstring>

#include "kernels/loops/bits-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

#undef PITBENCH_MARGINS_HALVED
#undef PITBENCH_MARGINS_TURNED
#if HWY_TARGET == HWY_AVX3
#define PITBENCH_MARGINS_HALVED 1
#else
#define PITBENCH_MARGINS_HALVED 0
#endif
// What is counted is what every ISA does that has them turned.
#if HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_AVX2 || \
    PITBENCH_MARGINS_HALVED || defined(PITBENCH_COUNTING)
#define PITBENCH_MARGINS_TURNED 1
#else
#define PITBENCH_MARGINS_TURNED 0
#endif

inline constexpr bool kTurned = PITBENCH_MARGINS_TURNED;
inline constexpr bool kHalved = PITBENCH_MARGINS_HALVED;
inline constexpr bool kScaled = HWY_NATIVE_FMA && !kTurned;

// The greater of both as signed integers of 32 bits, the lesser of both as
// unsigned ones; of f64 the halves apart. The upper ones tell a sign from the
// other and a number from one that is 2^-20 of it away.
#if defined(PITBENCH_COUNTING)
using hn::GreaterAsIntegers;
using hn::LesserAsUnsigned;
#else
template <class D>
HWY_INLINE Vec<D> GreaterAsIntegers(D d, Vec<D> a, Vec<D> b) {
  const hn::Repartition<std::int32_t, D> di;
  return hn::BitCast(d, hn::Max(hn::BitCast(di, a), hn::BitCast(di, b)));
}
template <class D>
HWY_INLINE Vec<D> LesserAsUnsigned(D d, Vec<D> a, Vec<D> b) {
  const hn::Repartition<std::uint32_t, D> du;
  return hn::BitCast(d, hn::Min(hn::BitCast(du, a), hn::BitCast(du, b)));
}
#endif

// Above it a margin decides: inside, or outside if it is turned or below the
// negative of it; where a filter has this t.
template <class T>
HWY_INLINE T DecidedAbove(Number<T> t) {
  constexpr T kBelowTwo = 2 - std::numeric_limits<T>::epsilon();
  if constexpr (kScaled) {
    return kBelowTwo;
  } else if constexpr (kTurned && (kHalved || sizeof(T) == 8)) {
    // The largest that has this upper half.
    const T twice = static_cast<T>(2 * t);
    hwy::UnsignedFromSize<sizeof(T)> bits;
    std::memcpy(&bits, &twice, sizeof(bits));
    bits |= (decltype(bits){1} << (4 * sizeof(T))) - 1;
    T largest;
    std::memcpy(&largest, &bits, sizeof(bits));
    return largest;
  } else {
    return static_cast<T>(kTurned ? 2 * t : t);
  }
}

// The lesser of two margins; turned, the greater. NaN is the result where b is,
// and by integers where a is, unless the other says outside; of two NaN it may
// be either.
template <class D>
HWY_INLINE Vec<D> LesserOrSecond(D d, Vec<D> a, Vec<D> b) {
  if constexpr (kTurned) {
    return GreaterAsIntegers(d, a, b);
  } else {
    (void)d;
    return MinOrSecond(a, b);
  }
}

// The same where it does not matter what comes of NaN.
template <class D>
HWY_INLINE Vec<D> Lesser(D d, Vec<D> a, Vec<D> b) {
  return kTurned ? LesserOrSecond(d, a, b) : hn::Min(a, b);
}

// The power of two that margins are multiplied by, where t is bound rounded to
// T: its exponent is that of bound with the opposite sign. Where bound is as
// large as T's largest numbers it is 0, or no number. In a vector's integers,
// since the set-up waits for it.
template <class T, class Wide>
HWY_INLINE Number<T> MarginScale(Wide bound) {
  if constexpr (!kScaled) {
    return 1;
  } else {
    constexpr bool kFloat = std::is_same_v<T, float>;
    constexpr std::uint64_t kBiases = 1023 + (kFloat ? 127 : 1023);
    const hn::CappedTag<Wide, 1> dw;
    const hn::RebindToUnsigned<decltype(dw)> du;
    const auto exponent = hn::And(hn::BitCast(du, hn::Set(dw, bound)),
                                  hn::Set(du, std::uint64_t{0x7FF} << 52));
    const auto scale = hn::Sub(hn::Set(du, kBiases << 52), exponent);
    if constexpr (kFloat) {
      const hn::Repartition<float, decltype(dw)> df;
      return hn::GetLane(hn::BitCast(df, hn::ShiftRight<52 - 23>(scale)));
    } else {
      return hn::GetLane(hn::BitCast(dw, scale));
    }
  }
}

// What is kept of the margins of blocks, two vectors at a time, and tells
// whether all of them decide; and which of them say inside, if they do.
#if PITBENCH_MARGINS_TURNED
// The least among unsigned integers, of which negative margins are the largest:
// the lesser of two first, so that what is kept waits for one instruction in
// two vectors.
template <class D>
HWY_INLINE Vec<D> OfNoMargin(D d) {
  const hn::RebindToSigned<D> di;
  return hn::BitCast(d, hn::Set(di, -1));
}
#endif
#if PITBENCH_MARGINS_HALVED
template <class D>
using UpperHalf =
    hn::Repartition<hwy::UnsignedFromSize<sizeof(TFromD<D>) / 2>, D>;
template <class D>
HWY_INLINE Vec<UpperHalf<D>> UpperHalves(D, Vec<D> margin0, Vec<D> margin1) {
  const UpperHalf<D> dh;
  return hn::ConcatOdd(dh, hn::BitCast(dh, margin1), hn::BitCast(dh, margin0));
}
template <class T>
HWY_INLINE auto UpperHalfOf(T value) {
  hwy::UnsignedFromSize<sizeof(T)> bits;
  std::memcpy(&bits, &value, sizeof(bits));
  return static_cast<hwy::UnsignedFromSize<sizeof(T) / 2>>(bits >>
                                                           (4 * sizeof(T)));
}
template <class D>
HWY_INLINE Vec<D> OfMargins(D d, Vec<D> margin0, Vec<D> margin1) {
  return hn::BitCast(d, UpperHalves(d, margin0, margin1));
}
template <class D>
HWY_INLINE Vec<D> OfBoth(D d, Vec<D> of_some, Vec<D> of_others) {
  const UpperHalf<D> dh;
  return hn::BitCast(
      d, hn::Min(hn::BitCast(dh, of_some), hn::BitCast(dh, of_others)));
}
template <class D>
HWY_INLINE bool AllDecided(D, Vec<D> of_all, TFromD<D> decided_above) {
  const UpperHalf<D> dh;
  return hn::AllTrue(
      dh, Gt(hn::BitCast(dh, of_all), Set(dh, UpperHalfOf(decided_above))));
}
// From −0 to −∞, which leaves out NaN: that has a larger upper half, as it
// comes of arithmetic and so is a quiet one.
template <class D>
HWY_INLINE void StoreInside(D d, Vec<D> margin0, Vec<D> margin1,
                            std::uint8_t* to) {
  using T = TFromD<D>;
  const hn::RebindToSigned<UpperHalf<D>> di;
  constexpr T kInfinity = std::numeric_limits<T>::infinity();
  const auto after =
      static_cast<TFromD<decltype(di)>>(UpperHalfOf(-kInfinity) + 1);
  const auto halves = hn::BitCast(di, UpperHalves(d, margin0, margin1));
  hn::StoreMaskBits(di, Lt(halves, Set(di, after)), to);
}
#elif PITBENCH_MARGINS_TURNED
// Of f64 the halves apart: their least together are no more than the least
// margin.
template <class D>
HWY_INLINE Vec<D> OfMargins(D d, Vec<D> margin0, Vec<D> margin1) {
  return LesserAsUnsigned(d, margin0, margin1);
}
template <class D>
HWY_INLINE Vec<D> OfBoth(D d, Vec<D> of_some, Vec<D> of_others) {
  return LesserAsUnsigned(d, of_some, of_others);
}
template <class D>
HWY_INLINE bool AllDecided(D d, Vec<D> of_all, TFromD<D> decided_above) {
  return hn::AllTrue(
      d, Or(Gt(of_all, Set(d, decided_above)), hn::MaskFromVec(of_all)));
}
// The sign bit, which costs nothing; but that of NaN says so as well, which is
// what the watch is for.
template <class D>
HWY_INLINE Mask<D> InsideIfDecided(D, Vec<D> margin, TFromD<D>) {
  return hn::MaskFromVec(margin);
}
#else
// Scaled: the and of their bits; else their least magnitude, where a margin
// that is NaN is passed over, as it says outside.
template <class D>
HWY_INLINE Vec<D> OfNoMargin(D d) {
  using Limits = std::numeric_limits<TFromD<D>>;
  return Set(d, kScaled ? Limits::infinity() : Limits::max());
}
template <class D>
HWY_INLINE Vec<D> OfMargins(D d, Vec<D> margin0, Vec<D> margin1) {
  if constexpr (kScaled) {
    return And(margin0, margin1);
  } else {
    return hn::Min(Abs(margin1), hn::Min(Abs(margin0), OfNoMargin(d)));
  }
}
template <class D>
HWY_INLINE Vec<D> OfBoth(D, Vec<D> of_some, Vec<D> of_others) {
  return kScaled ? And(of_some, of_others) : hn::Min(of_some, of_others);
}
template <class D>
HWY_INLINE bool AllDecided(D d, Vec<D> of_all, TFromD<D> decided_above) {
  if constexpr (kScaled) {
    const hn::RebindToSigned<D> di;
    using I = TFromD<decltype(di)>;
    constexpr I kHighestOfExponent = I{1} << (8 * sizeof(I) - 2);
    return hn::AllTrue(
        di, hn::TestBit(hn::BitCast(di, of_all), Set(di, kHighestOfExponent)));
  } else {
    return hn::AllTrue(d, Gt(of_all, Set(d, decided_above)));
  }
}
template <class D>
HWY_INLINE Mask<D> InsideIfDecided(D d, Vec<D> margin,
                                   TFromD<D> decided_above) {
  return Gt(margin, Set(d, decided_above));
}
#endif

// NaN where a margin was, two vectors at a time. (It may also come of margins
// that are, or whose product is, infinite; then the block is looked at again.)
inline constexpr bool kWatched = kTurned && !kHalved && kIsa != Isa::kCounting;
template <class V>
HWY_INLINE V Watch(V so_far, V margin0, V margin1) {
  if constexpr (!kWatched) {
    return so_far;
  } else if constexpr (HWY_NATIVE_FMA) {
    return MulAdd(margin0, margin1, so_far);
  } else {
    // In a register, or the compiler adds later and stores the margins.
    return InRegister(Add(Add(so_far, margin0), margin1));
  }
}
template <class D>
HWY_INLINE bool NoneIsNaN(D d, Vec<D> watch) {
  if constexpr (kWatched) {
    return hn::AllTrue(d, hn::Eq(watch, watch));
  } else {
    return true;
  }
}

// Which lanes a margin says are inside and which outside, as bits.
struct Verdict {
  std::uint64_t inside, outside;
};
template <class D>
HWY_INLINE Verdict VerdictOf(D d, Vec<D> margin, TFromD<D> decided_above) {
  const auto threshold = Set(d, decided_above);
  if constexpr (kTurned) {
    return {MaskBits(d, Lt(margin, Zero(d))),
            MaskBits(d, Gt(margin, threshold))};
  } else {
    return {MaskBits(d, Gt(margin, threshold)),
            MaskBits(d, Lt(margin, hn::Neg(threshold)))};
  }
}

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

#endif  // include guard that Highway toggles
