// Filters of the exact methods: float arithmetic that decides nearly every
// point for certain and knows where it does not.
//
// What a filter gives of a point, and how it says inside, outside or undecided,
// is in margins-inl.h.
//
// Two filters are static: a bound on the error of what is computed for a point,
// known once for a triangle and good for every finite point, so that a point
// costs what it costs without a bound. SlopeFilter takes the edges as lines and
// is the cheapest; AreaFilter takes edge functions and serves where a line
// would be too steep. Where a triangle is so thin or so far away that neither
// bound says anything, and where each lane has a triangle of its own,
// DeterminantMargin bounds the error of each determinant by its products.
#if defined(PITBENCH_KERNELS_LOOPS_FILTERS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PITBENCH_KERNELS_LOOPS_FILTERS_INL_H_
#undef PITBENCH_KERNELS_LOOPS_FILTERS_INL_H_
#else
#define PITBENCH_KERNELS_LOOPS_FILTERS_INL_H_
#endif

#include "kernels/edge_lines-inl.h"
#include "kernels/loops/margins-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

// The edge functions of one triangle, turned so that they are positive inside,
// and a bound on their errors.
//
//   e0 = a0·x + b0·y + c0,  e1 likewise,  e2 = k − e0 − e1
//
// where k is twice the area. Claim: with m = min(e0, e1, e2) as computed,
// m > t only inside the triangle and m < −t only outside it, for all finite
// points.
//
// Let u be T's unit roundoff, X and Y the largest |x| and |y| of the vertices,
// S_j = |a_j|·X + |b_j|·Y and P the two products of k in magnitude. For a point
// with weights w let σ = Σ|w|, so |x| ≤ σX, |y| ≤ σY and |e_j| ≤ σk. Rounding
// a_j and b_j costs u·σS_j, the products and sums of e_j at most u·(3S_j + k)σ,
// and c_j: S_j·u where it is rounded from double (f32), else 3u·S_j, of which
// what is lost by |y| ≤ σY is already part. In e2 come two sums, 2u·σk, and the
// error of k: u·k, or 4u·P. Together
//   |error| ≤ σt   with t = u·(5.5·(S_0 + S_1) + 5.5·k)               for f32,
//                       t = u·(8.5·(S_0 + S_1) + 5.5·k + 4.5·P)       for f64,
// in which the halves pay for terms of order u², and the smallest normal number
// is added for what underflows. Turned, all is negated, which no rounding
// shows, and c_j has t added and k 3t, so that t is added to all three e; for
// f64 these are rounded once more, for u·S_j and u·k.
//
// Inside σ = 1, so no e is as low as −t. Outside, the negative weights sum to
// −N, σ = 1 + 2N, and one of at most two has w ≤ −N/2: its e is computed below
// −N·k/2 + t·(1 + 2N), which is less than t where k > 4t. The code asks for 6t.
//
// Overflow: points in the triangle keep all terms below 2·(S_0 + S_1 + k),
// which is asked to be an eighth of the largest number. So an e that overflows
// belongs to a point outside; if e0 or e1 is +∞, e2 is −∞ or NaN; and m is NaN
// where e2 is, which is never inside. (Turned the signs are the other ones, and
// where e2 is NaN m is, or says outside.)
//
// Scaled, these terms are below 1/u. A coefficient may underflow, by less than
// 2^-20 of t for points in the triangle, or overflow, which the code asks.
template <class T>
struct AreaFilter {
  Number<T> a0, b0, c0, a1, b1, c1, k;
  T decided_above;
  bool holds;  // the claim; else this filter may not be used

  HWY_INLINE explicit AreaFilter(const Corners<T>& v) {
    constexpr bool kFloat = std::is_same_v<T, float>;
    constexpr double kUnit = std::numeric_limits<T>::epsilon() / 2;
    const Number<double> ax = v.ax, ay = v.ay;
    const Number<double> bx = v.bx, by = v.by;
    const Number<double> cx = v.cx, cy = v.cy;
    const Number<double> left = (bx - ax) * (cy - ay);
    const Number<double> right = (by - ay) * (cx - ax);
    const Number<double> area = left - right;
    const Number<double> size_of_area = Magnitude(area);
    const Number<double> sign = (area < 0) != kTurned ? -1 : 1;
    const Number<double> a0_wide = (ay - by) * sign;
    const Number<double> b0_wide = (bx - ax) * sign;
    const Number<double> a1_wide = (by - cy) * sign;
    const Number<double> b1_wide = (cx - bx) * sign;
    const Number<double> x =
        HWY_MAX(HWY_MAX(Magnitude(ax), Magnitude(bx)), Magnitude(cx));
    const Number<double> y =
        HWY_MAX(HWY_MAX(Magnitude(ay), Magnitude(by)), Magnitude(cy));
    const Number<double> edges = (Magnitude(a0_wide) + Magnitude(a1_wide)) * x +
                                 (Magnitude(b0_wide) + Magnitude(b1_wide)) * y;
    const Number<double> size = edges + size_of_area;
    const Number<double> products = Magnitude(left) + Magnitude(right);
    const double more = kTurned ? 1 : 0;
    const Number<double> bound = kFloat ? 5.5 * size
                                        : (8.5 + more) * edges +
                                              (5.5 + more) * size_of_area +
                                              4.5 * products;
    const Number<double> wide_t =
        kUnit * bound + static_cast<double>(std::numeric_limits<T>::min());
    // As T has it, so that all uses of it agree.
    const Number<T> t = static_cast<Number<T>>(wide_t);
    const Number<double> shift =
        kTurned ? static_cast<Number<double>>(t) : Number<double>(0);
    const Number<double> scale =
        static_cast<Number<double>>(MarginScale<T>(wide_t));
    const auto scaled = [scale](Number<double> wide) {
      return static_cast<Number<T>>(kScaled ? wide * scale : wide);
    };
    a0 = scaled(a0_wide);
    b0 = scaled(b0_wide);
    c0 = scaled(shift - (a0_wide * ax + b0_wide * ay));
    a1 = scaled(a1_wide);
    b1 = scaled(b1_wide);
    c1 = scaled(shift - (a1_wide * bx + b1_wide * by));
    k = scaled(area * sign + 3 * shift);
    decided_above = DecidedAbove<T>(t);
    constexpr double kMax = std::numeric_limits<T>::max();
    // An area that is NaN fails.
    holds = size < kMax / 8 && static_cast<Number<T>>(size_of_area) >= 6 * t &&
            (!kScaled || 2 * (x + y) * scale < kMax);
  }

  template <class D>
  HWY_INLINE Vec<D> Margin(D d, Vec<D> x, Vec<D> y0, Vec<D> y1) const {
    const auto e0 = MulAdd(Set(d, a0), x, MulAdd(Set(d, b0), y0, Set(d, c0)));
    const auto e1 = MulAdd(Set(d, a1), x, MulAdd(Set(d, b1), y1, Set(d, c1)));
    return LesserOrSecond(d, Lesser(d, e0, e1), Sub(Sub(Set(d, k), e0), e1));
  }
};

// The edges of one triangle as lines over x, and a bound on their errors. The
// margin of a point is the least of its distances along y from the lines, and
// from a vertical edge along x.
//
// Claim as for AreaFilter: the margin is above t only inside the triangle and
// below −t only outside it, for all finite points.
//
// Let S and C be a line's exact slope and constant, s and c what T keeps of
// them, X, Y, w and σ as there, so |C| ≤ |S|·X + Y. What is rounded to l is off
// from S·x + C by at most σe: for f32 s and c are rounded from double, so
//   e = u·(2·|S|·X + Y),
// for f64 s is off by 3u·|S| and c by u·(5·|S|·X + Y), so e = u·(8·|S|·X + Y);
// u·|S|·X more where s·x is rounded by itself, and for f64 u·(|S|·X + Y) more
// where c is rounded once more because, turned, it has t added. What the last
// rounding adds need not be known of all l, only of those near y. Where y is
// not below the exact line, l is at most what y + σe rounds to, which is at
// most y + σe + u·(|y| + σe); likewise where it is not above. So a distance has
// the wrong sign by at most σt, with t = e + u·Y; that y − l is rounded changes
// nothing: rounding is monotone and t a number of type T. The distance from a
// vertical edge has the right sign. t is the largest of the three bounds,
// halves added for terms of order u², and the smallest normal number times 1 +
// X for what underflows.
//
// Inside σ = 1, so no margin is as low as −t. Outside, as there, one w is at
// most −N/2 with σ = 1 + 2N, and y is N·H/2 beyond that edge's line, where H is
// how far the triangle reaches from the edge along y. Where H > 4t that exceeds
// the 2N·t by which σt exceeds t, so the margin is less than t. The code asks
// for 12t of an H that may be 4t off. A vertical edge's margin is negative.
//
// Overflow: with |S| below the largest number and |S|·X + Y below a 512th of it
// no line overflows for points in the triangle, and beside a line that does, a
// y on its wrong side would have to be within t of the largest number. Infinite
// x: lines below and above are infinite in the wrong order or equal to y, so
// that a distance is −∞ or NaN; LesserOrSecond keeps the NaN of the two lines
// that are taken together.
//
// Turned, a margin whose sign bit is set and that is −0 is t exactly. Lines
// above are negated and y added to them, so that y may be an operand in memory
// on both sides.
//
// Scaled, s must not overflow, which the code asks; what underflows there is
// less than 2^-20 of t for points in the triangle. Lines overflow sooner, but
// only beyond the triangle, where those that meet in its last vertex are in the
// wrong order. Their slopes differ by H/(2·X) or more, and t ≥ 2.5u·|S|·X is
// asked to be less than a 2¹³th of H, so the lines differ by more than 10⁴·u of
// themselves: where the one above is +∞ so is the one below it, where that one
// is −∞ so is the one above, and the margin is −∞.
template <class T>
struct SlopeFilter {
  struct Line {
    Number<T> s, c;

    template <class D>
    HWY_INLINE Vec<D> At(D d, Vec<D> x) const {
      return MulAdd(Set(d, s), x, Set(d, c));
    }
  };

  // How far a line that LineAbove made lies above y, and y above one of
  // LineBelow; turned, t less that.
  template <class D>
  static HWY_INLINE Vec<D> Above(D d, Number<T> scale, Vec<D> line, Vec<D> y) {
    if constexpr (kTurned) {
      return Add(line, y);
    } else if constexpr (kScaled) {
      return NegMulAdd(Set(d, scale), y, line);
    } else {
      return Sub(line, y);
    }
  }
  template <class D>
  static HWY_INLINE Vec<D> Below(D d, Number<T> scale, Vec<D> line, Vec<D> y) {
    if constexpr (kTurned) {
      return Sub(line, y);
    } else if constexpr (kScaled) {
      return MulSub(Set(d, scale), y, line);
    } else {
      return Sub(y, line);
    }
  }

  // Margins for each way in which the lines may lie. Both y are the same.
  struct TwoBelow {
    Line below0, below1, above;
    Number<T> scale;
    template <class D>
    HWY_INLINE Vec<D> Margin(D d, Vec<D> x, Vec<D> y0, Vec<D> y1) const {
      const auto most = hn::Max(below0.At(d, x), below1.At(d, x));
      return LesserOrSecond(d, Above(d, scale, above.At(d, x), y0),
                            Below(d, scale, most, y1));
    }
  };
  struct TwoAbove {
    Line above0, above1, below;
    Number<T> scale;
    template <class D>
    HWY_INLINE Vec<D> Margin(D d, Vec<D> x, Vec<D> y0, Vec<D> y1) const {
      const auto line0 = above0.At(d, x);
      const auto line1 = above1.At(d, x);
      const auto least =
          kTurned ? hn::Max(line0, line1) : hn::Min(line0, line1);
      return LesserOrSecond(d, Below(d, scale, below.At(d, x), y0),
                            Above(d, scale, least, y1));
    }
  };
  struct OneVertical {
    Line below, above;
    // The distance from the vertical edge: sign·x + offset.
    Number<T> sign, offset;
    Number<T> scale;
    template <class D>
    HWY_INLINE Vec<D> Margin(D d, Vec<D> x, Vec<D> y0, Vec<D> y1) const {
      const auto across = Add(Mul(Set(d, sign), x), Set(d, offset));
      return LesserOrSecond(
          d, Lesser(d, Above(d, scale, above.At(d, x), y0), across),
          Below(d, scale, below.At(d, x), y1));
    }
  };

  T decided_above;
  bool holds;

  HWY_INLINE explicit SlopeFilter(const Corners<T>& v)
      : SlopeFilter(v, Area(v)) {}

  // Calls use(margin) with the one that the triangle has.
  template <class Use>
  HWY_INLINE void Choose(const Use& use) const {
    using Edge = typename EdgeLines<T>::Line;
    lines_.Choose(
        [&](const Edge& pair0, const Edge& pair1, const Edge& above) HWY_ATTR {
          use(TwoBelow{LineBelow(pair0), LineBelow(pair1), LineAbove(above),
                       scale_});
        },
        [&](const Edge& pair0, const Edge& pair1, const Edge& below) HWY_ATTR {
          use(TwoAbove{LineAbove(pair0), LineAbove(pair1), LineBelow(below),
                       scale_});
        },
        [&](const Edge& below, const Edge& above, Number<T> vertical_x,
            bool right) HWY_ATTR {
          const Number<T> sign = right != kTurned ? 1 : -1;
          const auto edge = static_cast<Number<double>>(sign * vertical_x);
          use(OneVertical{LineBelow(below), LineAbove(above), Scaled(sign),
                          Scaled(Constant(shift_ - edge)), scale_});
        });
  }

 private:
  HWY_INLINE SlopeFilter(const Corners<T>& v, Number<double> area)
      : lines_(v, area < 0, true) {
    constexpr bool kFloat = std::is_same_v<T, float>;
    constexpr double kUnit = std::numeric_limits<T>::epsilon() / 2;
    constexpr double kMin = std::numeric_limits<T>::min();
    constexpr double kMax = std::numeric_limits<T>::max();
    const Number<double> x = MostOf(v.ax, v.bx, v.cx);
    const Number<double> y = MostOf(v.ay, v.by, v.cy);
    const Number<double> steepest = lines_.Steepest();
    const double apart = HWY_NATIVE_FMA ? 0 : 1;
    const double more = kTurned && !kFloat ? 1 : 0;
    const double of_slope = kUnit * ((kFloat ? 2.5 : 8.5) + apart + more);
    const Number<double> bound =
        steepest * (of_slope * x) + (kUnit * (2.5 + more) * y + kMin * (1 + x));
    const Number<T> t = static_cast<Number<T>>(bound);
    // The widest edge along x has the least reach along y.
    const Number<double> width =
        HWY_MAX(HWY_MAX(Magnitude(Number<double>(v.bx) - Number<double>(v.ax)),
                        Magnitude(Number<double>(v.cx) - Number<double>(v.bx))),
                Magnitude(Number<double>(v.ax) - Number<double>(v.cx)));
    const Number<double> size = Magnitude(area);  // reach times width
    shift_ = kTurned ? static_cast<Number<double>>(t) : Number<double>(0);
    scale_ = MarginScale<T>(bound);
    decided_above = DecidedAbove<T>(t);
    holds = steepest < kMax && steepest * x + y < kMax / 512 &&
            size * kMostUndecided >= bound * width && size > kLeast &&
            size < std::numeric_limits<double>::max() &&
            (!kScaled || steepest * static_cast<Number<double>>(scale_) < kMax);
  }

  // Where t is a larger share of the triangle's reach, more points are left
  // undecided than the cheaper margin gains; it is far below a twelfth.
  static constexpr double kMostUndecided = 0x1p-13;
  // Where twice the area is smaller, products might underflow.
  static constexpr double kLeast = 0x1p-1000;

  static HWY_INLINE Number<double> Area(const Corners<T>& v) {
    const Number<double> ax = v.ax, ay = v.ay;
    return (v.bx - ax) * (v.cy - ay) - (v.by - ay) * (v.cx - ax);
  }
  static HWY_INLINE Number<double> MostOf(Number<double> a, Number<double> b,
                                          Number<double> c) {
    return HWY_MAX(HWY_MAX(Magnitude(a), Magnitude(b)), Magnitude(c));
  }
  HWY_INLINE Number<T> Scaled(Number<T> value) const {
    return kScaled ? value * scale_ : value;
  }
  HWY_INLINE Line LineBelow(const typename EdgeLines<T>::Line& line) const {
    return kTurned ? Line{line.s, Constant(line.c + shift_)} : ScaledLine(line);
  }
  HWY_INLINE Line LineAbove(const typename EdgeLines<T>::Line& line) const {
    return kTurned ? Line{-line.s, Constant(shift_ - line.c)}
                   : ScaledLine(line);
  }
  HWY_INLINE Line ScaledLine(const typename EdgeLines<T>::Line& line) const {
    return {Scaled(line.s), Scaled(Constant(line.c))};
  }
  static HWY_INLINE Number<T> Constant(Number<double> c) {
    return static_cast<Number<T>>(c);
  }

  EdgeLines<T> lines_;
  Number<double> shift_;
  Number<T> scale_;
};

// The margin of points that each have a triangle of their own, never NaN: above
// 0 inside, below 0 outside, turned the other way round, an undecided +0; where
// margins are scaled, +2 and −2. Each
// determinant (v − p) × (w − p) is wrong by less than 4u·(|l| + |r|) and the
// smallest normal number (see exact/contains.cc); the three have one bound, in
// which their magnitudes are added, since of a maximum NaN might get lost. Let
// m be the larger of their least and minus their greatest. Where all have one
// sign, m is the least magnitude: inside if the bound is less. Where they have
// not, −m is the smaller magnitude of two that differ: outside if that is more.
template <class D>
HWY_INLINE Vec<D> DeterminantMargin(D d, const Triangles<D>& t, Vec<D> x,
                                    Vec<D> y) {
  using T = TFromD<D>;
  // Seen from the vertices, which negates both factors of every product: so
  // the vertices may be operands in memory.
  const auto ax = Sub(x, t.AxUsedOnce());
  const auto ay = Sub(y, t.AyUsedOnce());
  const auto bx = Sub(x, t.BxUsedOnce());
  const auto by = Sub(y, t.ByUsedOnce());
  const auto cx = Sub(x, t.CxUsedOnce());
  const auto cy = Sub(y, t.CyUsedOnce());
  auto of_ab = x;
  auto of_bc = x;
  auto of_ca = x;
  const auto determinant = [](Vec<D> vx, Vec<D> vy, Vec<D> wx, Vec<D> wy,
                              Vec<D>& magnitudes) HWY_ATTR {
    const auto left = Mul(vx, wy);
    const auto right = Mul(vy, wx);
    magnitudes = Add(Abs(left), Abs(right));
    return Sub(left, right);
  };
  const auto ab = determinant(ax, ay, bx, by, of_ab);
  const auto bc = determinant(bx, by, cx, cy, of_bc);
  const auto ca = determinant(cx, cy, ax, ay, of_ca);
  const auto magnitudes = Add(Add(of_ab, of_bc), of_ca);
  const auto bound = MulAdd(Set(d, 2 * std::numeric_limits<T>::epsilon()),
                            magnitudes, Set(d, std::numeric_limits<T>::min()));
  const auto least = hn::Min(hn::Min(ab, bc), ca);
  const auto most = hn::Max(hn::Max(ab, bc), ca);
  const auto margin =
      kTurned ? hn::Min(most, hn::Neg(least)) : hn::Max(least, hn::Neg(most));
  const auto decided = Gt(Abs(margin), bound);
  return hn::IfThenElseZero(
      decided, kScaled ? hn::CopySignToAbs(Set(d, T{2}), margin) : margin);
}

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

#endif  // include guard that Highway toggles
