// Point in triangle on a grid laid over the triangle's bounding box, as
// rasterisers snap vertices: three edge functions of small integers, exactly.
//
//   A·X + B·Y + C ≥ 0 for each edge, (X, Y) = P snapped to whole numbers from 0
//   to 127; a point outside the box is outside at once
//
// snapped_i16 computes in lanes of 16 bits: coordinates of 7 bits are as many
// as keep A·X + B·Y + C below 2^15. snapped_u8 keeps X and Y as a pair of bytes
// in such a lane and multiplies pairs in one instruction, where the CPU has it
// (x86: maddubs); the answers are the same.
// Set-up: bounding box, 6 coordinates snapped, 3 edge functions. Per point: 2
// subtractions, 2 multiplications, 2 additions and 4 compares to snap it; 6
// products and 6 sums of 16 bits, or 3 products of pairs and 3 sums; 1 compare.
// Boundary: closed. Winding: fixed by the set-up. Degenerate: contains nothing.
// Fails: P and the vertices each move by half a step of the grid, 1/127 of the
// box, in x and in y, so an answer may be wrong within one step along x and one
// along y of the boundary; a needle that is thinner may contain nothing. Nearer
// to the origin or farther, larger or smaller makes no difference. Worst known
// f32 inputs, A B C p (tests/worst_inputs.csv has f64 as well):
//   snapped_i16, said inside, is 3.62e+05 ulps outside:
//     (-0x1.f58p-1, -0x1.f18p-1) (0x1p+0, 0x1.ecp-1)
//     (0x1.a94p-4, -0x1.d63cp-1) (0x1.e8p-4, -0x1.de04p-1)
//   snapped_u8, said inside, is 3.62e+05 ulps outside:
//     (-0x1.f58p-1, -0x1.f18p-1) (0x1p+0, 0x1.ecp-1)
//     (0x1.a94p-4, -0x1.d63cp-1) (0x1.e8p-4, -0x1.de04p-1)

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/methods/snapped.cc"
#include <hwy/foreach_target.h>

#include "kernels/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

inline constexpr double kLastStep = 127;

// Lanes of 16 bits, as many as D has.
template <class D>
using Short =
    std::conditional_t<std::is_same_v<D, OneLane<TFromD<D>>>,
                       OneLane<std::int16_t>, hn::Rebind<std::int16_t, D>>;

// The whole number next to 0 ≤ v < 2^15, by adding a number so large that its
// last bit is worth 1: the sum's last bits are the whole number. Of others,
// anything.
template <class D>
HWY_INLINE Vec<Short<D>> Nearest(D d, Vec<D> v) {
  using T = TFromD<D>;
  constexpr T kShift =
      T{3} * (std::int64_t{1} << (std::numeric_limits<T>::digits - 2));
  const hn::RebindToUnsigned<D> bits;
  const hn::RebindToUnsigned<Short<D>> last;
  return hn::BitCast(
      Short<D>(),
      hn::TruncateTo(last, hn::BitCast(bits, Add(v, Set(d, kShift)))));
}

// Where none of the lanes of 16 bits is negative, as a mask of E.
template <class E>
HWY_INLINE Mask<E> NonNegative(E e, Vec<Short<E>> v) {
  const hn::RebindToSigned<E> wide;
  const auto below = Set(wide, -1);
  if constexpr (sizeof(TFromD<E>) == 4) {
    return hn::RebindMask(e, Gt(hn::PromoteTo(wide, v), below));
  } else {
    const hn::Rebind<std::int32_t, E> half;
    const auto promoted = hn::PromoteTo(wide, hn::PromoteTo(half, v));
    return hn::RebindMask(e, Gt(promoted, below));
  }
}

// Two bytes of a lane: `low` in the lower one.
template <class V>
HWY_INLINE V PairOfBytes(V low, V high, V low_byte) {
  return Or(And(low, low_byte), hn::ShiftLeft<8>(high));
}

// The sum of the products of the two bytes of each lane, those of `points`
// unsigned and those of `factors` signed. Precondition: it has 16 bits.
#if defined(PITBENCH_COUNTING)
using hn::SumOfPairs;
#elif HWY_TARGET == HWY_SSSE3 || HWY_TARGET == HWY_SSE4 || \
    HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3
template <std::size_t kN>
HWY_INLINE hn::Vec128<std::int16_t, kN> SumOfPairs(
    hn::Vec128<std::int16_t, kN> points, hn::Vec128<std::int16_t, kN> factors,
    hn::Vec128<std::int16_t, kN>) {
  return hn::Vec128<std::int16_t, kN>{
      _mm_maddubs_epi16(points.raw, factors.raw)};
}
#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3
HWY_INLINE hn::Vec256<std::int16_t> SumOfPairs(hn::Vec256<std::int16_t> points,
                                               hn::Vec256<std::int16_t> factors,
                                               hn::Vec256<std::int16_t>) {
  return hn::Vec256<std::int16_t>{
      _mm256_maddubs_epi16(points.raw, factors.raw)};
}
#endif
#else
template <class V>
HWY_INLINE V SumOfPairs(V points, V factors, V low_byte) {
  const V low =
      Mul(And(points, low_byte), hn::ShiftRight<8>(hn::ShiftLeft<8>(factors)));
  return Add(low, Mul(hn::ShiftRight<8>(points), hn::ShiftRight<8>(factors)));
}
#endif

template <class D, bool kBytes>
class Snapped {
  using T = TFromD<D>;
  using S = Short<D>;

  // A·X + B·Y + C, not negative inside; A and B are bytes of `a` if kBytes.
  struct Edge {
    Held<S> a, b, c;

    HWY_INLINE Edge(S s, Vec<S> a_, Vec<S> b_, Vec<S> vx, Vec<S> vy,
                    Vec<S> sign)
        : a(s, kBytes ? PairOfBytes(a_, b_, Set(s, 0xFF)) : a_),
          b(s, b_),
          c(s, IfThenElse(hn::Eq(sign, Zero(s)), Set(s, -1),
                          Sub(Zero(s), Add(Mul(a_, vx), Mul(b_, vy))))) {}

    template <class E>
    HWY_INLINE Vec<E> At(E e, Vec<E> x, Vec<E> y, Vec<E> pair) const {
      if constexpr (kBytes) {
        return Add(SumOfPairs(pair, a.In(e), Set(e, 0xFF)), c.In(e));
      } else {
        return Add(Add(Mul(a.In(e), x), Mul(b.In(e), y)), c.In(e));
      }
    }
  };

 public:
  HWY_INLINE Snapped(D d, const Triangles<D>& t)
      : Snapped(d, t, hn::Min(hn::Min(t.Ax(), t.Bx()), t.Cx()),
                hn::Max(hn::Max(t.Ax(), t.Bx()), t.Cx()),
                hn::Min(hn::Min(t.Ay(), t.By()), t.Cy()),
                hn::Max(hn::Max(t.Ay(), t.By()), t.Cy())) {}

  // A coordinate that is NaN or infinite fails the comparison with the box, and
  // so does everything where the box is NaN.
  template <class E>
  HWY_INLINE Mask<E> Inside(E e, Vec<E> x, Vec<E> y) const {
    const auto left = left_.In(e);
    const auto bottom = bottom_.In(e);
    const auto in_x = AndLe(Ge(x, left), x, right_.In(e));
    const auto in_box = AndLe(AndGe(in_x, y, bottom), y, top_.In(e));
    const Short<E> s;
    const auto sx = Nearest(e, Mul(Sub(x, left), scale_x_.In(e)));
    const auto sy = Nearest(e, Mul(Sub(y, bottom), scale_y_.In(e)));
    const auto pair = kBytes ? PairOfBytes(sx, sy, Set(s, 0xFF)) : sx;
    const auto all = Or(ab_.At(s, sx, sy, pair),
                        Or(bc_.At(s, sx, sy, pair), ca_.At(s, sx, sy, pair)));
    return And(in_box, NonNegative(e, all));
  }

 private:
  HWY_INLINE Snapped(D d, const Triangles<D>& t, Vec<D> left, Vec<D> right,
                     Vec<D> bottom, Vec<D> top)
      : Snapped(d, t, left, right, bottom, top,
                Div(Set(d, T{kLastStep}), Sub(right, left)),
                Div(Set(d, T{kLastStep}), Sub(top, bottom))) {}

  HWY_INLINE Snapped(D d, const Triangles<D>& t, Vec<D> left, Vec<D> right,
                     Vec<D> bottom, Vec<D> top, Vec<D> scale_x, Vec<D> scale_y)
      : Snapped(d, ValidOrNaN(d, DoubleArea(t), left), right, bottom, top,
                scale_x, scale_y,  //
                Nearest(d, Mul(Sub(t.Ax(), left), scale_x)),
                Nearest(d, Mul(Sub(t.Ay(), bottom), scale_y)),
                Nearest(d, Mul(Sub(t.Bx(), left), scale_x)),
                Nearest(d, Mul(Sub(t.By(), bottom), scale_y)),
                Nearest(d, Mul(Sub(t.Cx(), left), scale_x)),
                Nearest(d, Mul(Sub(t.Cy(), bottom), scale_y))) {}

  HWY_INLINE Snapped(D d, Vec<D> left, Vec<D> right, Vec<D> bottom, Vec<D> top,
                     Vec<D> scale_x, Vec<D> scale_y, Vec<S> ax, Vec<S> ay,
                     Vec<S> bx, Vec<S> by, Vec<S> cx, Vec<S> cy)
      : left_(d, left),
        right_(d, right),
        bottom_(d, bottom),
        top_(d, top),
        scale_x_(d, scale_x),
        scale_y_(d, scale_y),
        ab_(EdgeOf(ax, ay, bx, by, Sign(ax, ay, bx, by, cx, cy))),
        bc_(EdgeOf(bx, by, cx, cy, Sign(ax, ay, bx, by, cx, cy))),
        ca_(EdgeOf(cx, cy, ax, ay, Sign(ax, ay, bx, by, cx, cy))) {}

  static HWY_INLINE Edge EdgeOf(Vec<S> vx, Vec<S> vy, Vec<S> wx, Vec<S> wy,
                                Vec<S> sign) {
    return {S(), Mul(Sub(vy, wy), sign), Mul(Sub(wx, vx), sign), vx, vy, sign};
  }

  // Of the snapped area.
  static HWY_INLINE Vec<S> Sign(Vec<S> ax, Vec<S> ay, Vec<S> bx, Vec<S> by,
                                Vec<S> cx, Vec<S> cy) {
    const auto area =
        Sub(Mul(Sub(bx, ax), Sub(cy, ay)), Mul(Sub(by, ay), Sub(cx, ax)));
    const auto one = Set(S(), 1);
    return hn::Max(hn::Min(area, one), Sub(Zero(S()), one));
  }

  Held<D> left_, right_, bottom_, top_, scale_x_, scale_y_;
  Edge ab_, bc_, ca_;
};

template <class D>
using SnappedI16 = Snapped<D, false>;
template <class D>
using SnappedU8 = Snapped<D, true>;

constexpr Method kSnappedI16{
    .key = "snapped_i16",
    .source = "rasterisers' fixed point",
    .formula =
        "A·X + B·Y + C ≥ 0 for each edge, on a grid of 128 × 128 over the "
        "bounding box",
    .snap_distance = 1 / kLastStep,
};
constexpr Method kSnappedU8{
    .key = "snapped_u8",
    .source = "rasterisers' fixed point, as pairs of bytes",
    .formula = kSnappedI16.formula,
    .snap_distance = kSnappedI16.snap_distance,
};

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

PITBENCH_KERNELS(snapped, FloatRows<SnappedI16>(kSnappedI16) +
                              FloatRows<SnappedU8>(kSnappedU8));
