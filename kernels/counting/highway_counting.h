// Stands in for <hwy/highway.h> where kernels are compiled to be counted: the
// part of Highway that kernels call, on vectors of 64 bytes that write down
// every operation (kernels/counting/tape.h).
//
// The shape is that of AVX-512, down to what Highway's functions are there: a
// select or the sign of a number is one instruction of logic, a comparison
// under a mask is one comparison, and the smaller of two magnitudes one
// minimum. Never timed.
#ifndef PITBENCH_KERNELS_COUNTING_HIGHWAY_COUNTING_H_
#define PITBENCH_KERNELS_COUNTING_HIGHWAY_COUNTING_H_

#include <hwy/base.h>
#include <hwy/detect_targets.h>
#include <hwy/ops/set_macros-inl.h>

#undef HWY_NAMESPACE
#define HWY_NAMESPACE N_COUNTING
#undef HWY_NATIVE_FMA
#define HWY_NATIVE_FMA 1
#undef HWY_MAX_BYTES
#define HWY_MAX_BYTES 64
// No target of Highway's: not scalar, and none whose intrinsics a kernel uses.
#undef HWY_TARGET
#define HWY_TARGET 0

#include "kernels/counting/vectors.h"

namespace hwy::N_COUNTING {

// --- arithmetic -------------------------------------------------------------

template <class V>
V Add(const V& a, const V& b) {
  using T = typename V::T;
  return Commutative<V>(Kind::kAdd, Code::kAdd, a, b,
                        [](T x, T y) { return x + y; });
}
template <class V>
V Sub(const V& a, const V& b) {
  using T = typename V::T;
  return Binary<V>(Kind::kAdd, Code::kSub, a, b,
                   [](T x, T y) { return x - y; });
}
template <class V>
V Mul(const V& a, const V& b) {
  using T = typename V::T;
  constexpr Kind kKind =
      std::is_integral_v<T> ? Kind::kIntegerMultiply : Kind::kMultiply;
  return Commutative<V>(kKind, Code::kMul, a, b,
                        [](T x, T y) { return x * y; });
}
template <class V>
V Div(const V& a, const V& b) {
  using T = typename V::T;
  return Binary<V>(Kind::kDivide, Code::kDiv, a, b,
                   [](T x, T y) { return x / y; });
}
template <class V>
V Sqrt(const V& a) {
  using T = typename V::T;
  return Unary<V>(Kind::kDivide, Code::kSqrt, a,
                  [](T x) { return std::sqrt(x); });
}

template <class V, class F>
V Fused(Code code, const V& a, const V& b, const V& c, const F& f) {
  return LaneByLane<V>(
      Note<typename V::T>(Kind::kMultiplyAdd, code, V::kLanes,
                          std::min(a.id, b.id), std::max(a.id, b.id), c.id),
      f, a, b, c);
}
template <class V>
V MulAdd(const V& a, const V& b, const V& c) {
  using T = typename V::T;
  return Fused(Code::kMulAdd, a, b, c,
               [](T x, T y, T z) { return std::fma(x, y, z); });
}
template <class V>
V MulSub(const V& a, const V& b, const V& c) {
  using T = typename V::T;
  return Fused(Code::kMulSub, a, b, c,
               [](T x, T y, T z) { return std::fma(x, y, -z); });
}
template <class V>
V NegMulAdd(const V& a, const V& b, const V& c) {
  using T = typename V::T;
  return Fused(Code::kNegMulAdd, a, b, c,
               [](T x, T y, T z) { return std::fma(-x, y, z); });
}
template <class V>
V NegMulSub(const V& a, const V& b, const V& c) {
  using T = typename V::T;
  return Fused(Code::kNegMulSub, a, b, c,
               [](T x, T y, T z) { return std::fma(-x, y, -z); });
}

// As minps and maxps: the second where either is NaN.
template <class V>
V Min(const V& a, const V& b) {
  using T = typename V::T;
  return Binary<V>(Kind::kMinMax, Code::kMin, a, b,
                   [](T x, T y) { return x < y ? x : y; });
}
template <class V>
V Max(const V& a, const V& b) {
  using T = typename V::T;
  return Binary<V>(Kind::kMinMax, Code::kMax, a, b,
                   [](T x, T y) { return x > y ? x : y; });
}

// By the bits of both, as integers: see kernels/loops/margins-inl.h.
template <class I, class V>
V ByBits(Code code, const V& a, const V& b, bool greater) {
  using T = typename V::T;
  return Binary<V>(Kind::kIntegerMinMax, code, a, b, [greater](T x, T y) {
    I p;
    I q;
    std::memcpy(&p, &x, sizeof(p));
    std::memcpy(&q, &y, sizeof(q));
    return (p > q) == greater ? x : y;
  });
}
template <class D>
Vec<D> GreaterAsIntegers(D, const Vec<D>& a, const Vec<D>& b) {
  return ByBits<MakeSigned<TFromD<D>>>(Code::kGreaterAsIntegers, a, b, true);
}
template <class D>
Vec<D> LesserAsUnsigned(D, const Vec<D>& a, const Vec<D>& b) {
  return ByBits<MakeUnsigned<TFromD<D>>>(Code::kLesserAsUnsigned, a, b, false);
}

// --- comparisons ------------------------------------------------------------

#define PITBENCH_COMPARISON(Name, op)                                         \
  template <class V>                                                          \
  MaskOf<typename V::T, V::kLanes> Name(const V& a, const V& b) {             \
    using T = typename V::T;                                                  \
    return Binary<MaskOf<T, V::kLanes>>(Kind::kCompare, Code::k##Name, a, b,  \
                                        [](T x, T y) { return x op y; });     \
  }                                                                           \
  template <class V>                                                          \
  MaskOf<typename V::T, V::kLanes> And##Name(                                 \
      const MaskOf<typename V::T, V::kLanes>& mask, const V& a, const V& b) { \
    using T = typename V::T;                                                  \
    return LaneByLane<MaskOf<T, V::kLanes>>(                                  \
        Note<T>(Kind::kCompare, Code::k##Name, V::kLanes, a.id, b.id,         \
                mask.id),                                                     \
        [](bool m, T x, T y) { return m && x op y; }, mask, a, b);            \
  }
PITBENCH_COMPARISON(Eq, ==)
PITBENCH_COMPARISON(Ne, !=)
PITBENCH_COMPARISON(Lt, <)
PITBENCH_COMPARISON(Le, <=)
PITBENCH_COMPARISON(Ge, >=)
PITBENCH_COMPARISON(Gt, >)
#undef PITBENCH_COMPARISON

// --- logic ------------------------------------------------------------------

template <class T>
using BitsOf = std::conditional_t<
    std::is_same_v<T, bool>, bool,
    MakeUnsigned<std::conditional_t<std::is_same_v<T, bool>, std::uint8_t, T>>>;

// f of the bits of the lanes of vectors or masks.
template <class V, class F>
V Bitwise(Code code, const V& a, const V& b, const F& f, bool commutes) {
  using Lane = typename decltype(a.lane)::value_type;
  const auto of_lanes = [&f](Lane x, Lane y) {
    BitsOf<Lane> p;
    BitsOf<Lane> q;
    std::memcpy(&p, &x, sizeof(p));
    std::memcpy(&q, &y, sizeof(q));
    const auto bits = static_cast<BitsOf<Lane>>(f(p, q));
    Lane result;
    std::memcpy(&result, &bits, sizeof(result));
    return result;
  };
  return commutes ? Commutative<V>(Kind::kLogic, code, a, b, of_lanes)
                  : Binary<V>(Kind::kLogic, code, a, b, of_lanes);
}
template <class V>
V And(const V& a, const V& b) {
  return Bitwise(
      Code::kAnd, a, b, [](auto x, auto y) { return x & y; }, true);
}
template <class V>
V Or(const V& a, const V& b) {
  return Bitwise(
      Code::kOr, a, b, [](auto x, auto y) { return x | y; }, true);
}
template <class V>
V Xor(const V& a, const V& b) {
  return Bitwise(
      Code::kXor, a, b, [](auto x, auto y) { return x ^ y; }, true);
}
// The lanes whose sign bit is set.
template <class V>
MaskOf<typename V::T, V::kLanes> MaskFromVec(const V& a) {
  using T = typename V::T;
  return Unary<MaskOf<T, V::kLanes>>(Kind::kLogic, Code::kSignMask, a,
                                     [](T x) { return std::signbit(x); });
}
// Whether the one bit that b has is in a.
template <class V>
MaskOf<typename V::T, V::kLanes> TestBit(const V& a, const V& b) {
  using T = typename V::T;
  return Binary<MaskOf<T, V::kLanes>>(Kind::kCompare, Code::kTestBit, a, b,
                                      [](T x, T y) { return (x & y) != 0; });
}
// b without what is in a.
template <class V>
V AndNot(const V& a, const V& b) {
  using Lane = typename decltype(a.lane)::value_type;
  return Bitwise(
      Code::kAndNot, a, b,
      [](auto x, auto y) {
        if constexpr (std::is_same_v<Lane, bool>) {
          return !x && y;
        } else {
          return ~x & y;
        }
      },
      false);
}
template <class T, std::size_t kN>
MaskOf<T, kN> Not(const MaskOf<T, kN>& a) {
  return Unary<MaskOf<T, kN>>(Kind::kLogic, Code::kNot, a,
                              [](bool x) { return !x; });
}
template <class V>
V Abs(const V& a) {
  using T = typename V::T;
  return Unary<V>(Kind::kLogic, Code::kAbs, a, [](T x) { return std::abs(x); });
}
template <class V>
V Neg(const V& a) {
  using T = typename V::T;
  return Unary<V>(Kind::kLogic, Code::kNeg, a, [](T x) { return -x; });
}
template <class V>
V CopySign(const V& size, const V& sign) {
  using T = typename V::T;
  return Binary<V>(Kind::kLogic, Code::kCopySign, size, sign,
                   [](T x, T y) { return std::copysign(x, y); });
}
template <class V>
V CopySignToAbs(const V& size, const V& sign) {
  return CopySign(size, sign);
}
template <class T, std::size_t kN>
Vector<T, kN> IfThenElse(const MaskOf<T, kN>& mask, const Vector<T, kN>& yes,
                         const Vector<T, kN>& no) {
  return LaneByLane<Vector<T, kN>>(
      Note<T>(Kind::kLogic, Code::kSelect, kN, mask.id, yes.id, no.id),
      [](bool m, T x, T y) { return m ? x : y; }, mask, yes, no);
}
template <class T, std::size_t kN>
Vector<T, kN> IfThenElseZero(const MaskOf<T, kN>& mask,
                             const Vector<T, kN>& yes) {
  return IfThenElse(mask, yes, Zero(Simd<T, kN>()));
}
template <class T, std::size_t kN>
Vector<T, kN> IfThenZeroElse(const MaskOf<T, kN>& mask,
                             const Vector<T, kN>& no) {
  return IfThenElse(mask, Zero(Simd<T, kN>()), no);
}
template <int kBits, class V>
V ShiftLeft(const V& a) {
  using T = typename V::T;
  return Unary<V>(
      Kind::kLogic, Code::kShiftLeft, a,
      [](T x) { return static_cast<MakeUnsigned<T>>(x) << kBits; }, kBits);
}
template <int kBits, class V>
V ShiftRight(const V& a) {
  using T = typename V::T;
  return Unary<V>(
      Kind::kLogic, Code::kShiftRight, a, [](T x) { return x >> kBits; },
      kBits);
}

// --- other types, other lanes -----------------------------------------------

template <class D, class From>
Vec<D> Converted(D, const From& v) {
  using T = TFromD<D>;
  // One instruction for the longer of the two vectors' types.
  return LaneByLane<Vec<D>>(
      Note<T>(Kind::kConvert, Code::kConvert, D::kLanes, v.id, 0, 0,
              sizeof(typename From::T)),
      [](typename From::T x) { return static_cast<T>(x); }, v);
}
template <class D, class From>
Vec<D> PromoteTo(D d, const From& v) {
  return Converted(d, v);
}
template <class D, class From>
Vec<D> DemoteTo(D d, const From& v) {
  return Converted(d, v);
}
template <class D, class From>
Vec<D> TruncateTo(D d, const From& v) {
  return Converted(d, v);
}
template <class D, class From>
Vec<D> ConvertTo(D d, const From& v) {
  return Converted(d, v);
}
template <class D, class From>
Vec<D> BitCast(D, const From& v) {
  Vec<D> out;
  static_assert(sizeof(out.lane) == sizeof(v.lane));
  std::memcpy(out.lane.data(), v.lane.data(), sizeof(out.lane));
  out.id = Note<TFromD<D>>(Kind::kFree, Code::kSame, D::kLanes, v.id);
  return out;
}
template <class D, class From>
Mask<D> RebindMask(D, const From& mask) {
  return {mask.lane,
          Note<TFromD<D>>(Kind::kFree, Code::kSame, D::kLanes, mask.id)};
}
template <class D>
Vec<D> LowerHalf(D, const Vector<TFromD<D>, 2 * D::kLanes>& v) {
  Vec<D> out;
  out.id = Note<TFromD<D>>(Kind::kFree, Code::kSame, D::kLanes, v.id);
  std::copy_n(v.lane.begin(), D::kLanes, out.lane.begin());
  return out;
}
template <class D>
Vec<D> UpperHalf(D, const Vector<TFromD<D>, 2 * D::kLanes>& v) {
  Vec<D> out;
  out.id = Note<TFromD<D>>(Kind::kConvert, Code::kUpperHalf, D::kLanes, v.id);
  std::copy_n(v.lane.begin() + D::kLanes, D::kLanes, out.lane.begin());
  return out;
}

// Both halves as one (vinsertf32x8).
template <class D, class V>
Vec<D> Combine(D, const V& upper, const V& lower) {
  Vec<D> out;
  out.id = Note<TFromD<D>>(Kind::kConvert, Code::kCombine, D::kLanes, upper.id,
                           lower.id);
  std::copy_n(lower.lane.begin(), V::kLanes, out.lane.begin());
  std::copy_n(upper.lane.begin(), V::kLanes, out.lane.begin() + V::kLanes);
  return out;
}

// `v`, of which nothing is known from before: what is computed from it is
// computed anew.
template <class V>
V Opaque(const V& v) {
  static thread_local std::uint64_t unknown = 0;
  V out = v;
  out.id = Note<typename V::T>(Kind::kFree, Code::kSame, V::kLanes, v.id, 0, 0,
                               ++unknown);
  return out;
}

// --- what kernels have of their own for AVX-512 -----------------------------

// The masks of both halves of e's lanes as one (kunpckbw).
template <class E, class M>
Mask<E> JoinMasks(E, const M& upper, const M& lower) {
  Mask<E> out;
  out.id =
      Note<TFromD<E>>(Kind::kLogic, Code::kJoin, E::kLanes, upper.id, lower.id);
  std::copy_n(lower.lane.begin(), M::kLanes, out.lane.begin());
  std::copy_n(upper.lane.begin(), M::kLanes, out.lane.begin() + M::kLanes);
  return out;
}

// The sum of the products of the two bytes of each lane, those of `points`
// unsigned and those of `factors` signed (vpmaddubsw).
template <class V>
V SumOfPairs(const V& points, const V& factors, const V&) {
  return Binary<V>(Kind::kIntegerMultiply, Code::kSumOfPairs, points, factors,
                   [](std::int16_t p, std::int16_t f) {
                     const int low = (p & 0xFF) * static_cast<std::int8_t>(f);
                     const int high = (static_cast<std::uint16_t>(p) >> 8) *
                                      static_cast<std::int8_t>(f >> 8);
                     return low + high;
                   });
}

}  // namespace hwy::N_COUNTING

#endif  // PITBENCH_KERNELS_COUNTING_HIGHWAY_COUNTING_H_
