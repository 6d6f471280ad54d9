// The loops of the exact methods: float arithmetic decides nearly every point
// for certain, and the few that it cannot decide go to exact arithmetic.
//
// One filter is static: a bound on the error of the three edge functions,
// known once for a triangle and good for every finite point, so that a point
// costs what a plain edge function costs. Where a triangle is so thin or so far
// away that its bound says nothing, and where each lane has a triangle of its
// own, the other filter bounds the error of each determinant by its products.
//
// A filter gives each item a margin: above t it is inside, below −t it is not,
// and between nothing is decided yet.
#if defined(PITBENCH_KERNELS_LOOPS_FILTERED_INL_H_) == \
    defined(HWY_TARGET_TOGGLE)
#ifdef PITBENCH_KERNELS_LOOPS_FILTERED_INL_H_
#undef PITBENCH_KERNELS_LOOPS_FILTERED_INL_H_
#else
#define PITBENCH_KERNELS_LOOPS_FILTERED_INL_H_
#endif

#include "kernels/exact/contains.h"
#include "kernels/loops/bits-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

// |x| of a number; std::abs would be an inline function that ISAs share.
HWY_INLINE double Magnitude(double x) { return x < 0 ? -x : x; }

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
// is added for what underflows.
//
// Inside σ = 1, so no e is below −t. Outside, the negative weights sum to −N,
// σ = 1 + 2N, and one of at most two has w ≤ −N/2: its e is computed below
// −N·k/2 + t·(1 + 2N), which is less than t where k > 4t. The code asks for 6t.
//
// Overflow: points in the triangle keep all terms below 2·(S_0 + S_1 + k),
// which is asked to be an eighth of the largest number. So an e that overflows
// belongs to a point outside; if e0 or e1 is +∞, e2 is −∞ or NaN; and m is NaN
// where e2 is, which leaves both bits 0.
template <class T>
struct StaticFilter {
  T a0, b0, c0, a1, b1, c1, k, t;

  // Whether the claim holds; else only the other filter may be used.
  HWY_INLINE bool Holds() const { return k >= 6 * t; }

  HWY_INLINE explicit StaticFilter(const Corners<T>& v) {
    constexpr bool kFloat = std::is_same_v<T, float>;
    constexpr double kUnit = std::numeric_limits<T>::epsilon() / 2;
    const double ax = v.ax, ay = v.ay;
    const double bx = v.bx, by = v.by;
    const double cx = v.cx, cy = v.cy;
    const double left = (bx - ax) * (cy - ay);
    const double right = (by - ay) * (cx - ax);
    const double area = left - right;
    const double sign = area < 0 ? -1 : 1;
    const double a0_wide = (ay - by) * sign;
    const double b0_wide = (bx - ax) * sign;
    const double a1_wide = (by - cy) * sign;
    const double b1_wide = (cx - bx) * sign;
    const double x =
        HWY_MAX(HWY_MAX(Magnitude(ax), Magnitude(bx)), Magnitude(cx));
    const double y =
        HWY_MAX(HWY_MAX(Magnitude(ay), Magnitude(by)), Magnitude(cy));
    const double edges = (Magnitude(a0_wide) + Magnitude(a1_wide)) * x +
                         (Magnitude(b0_wide) + Magnitude(b1_wide)) * y;
    const double size = edges + area * sign;
    const double products = Magnitude(left) + Magnitude(right);
    const double bound =
        kFloat ? 5.5 * size
               : 8.5 * edges + 5.5 * (area * sign) + 4.5 * products;
    a0 = static_cast<T>(a0_wide);
    b0 = static_cast<T>(b0_wide);
    c0 = static_cast<T>(-(a0_wide * ax + b0_wide * ay));
    a1 = static_cast<T>(a1_wide);
    b1 = static_cast<T>(b1_wide);
    c1 = static_cast<T>(-(a1_wide * bx + b1_wide * by));
    k = static_cast<T>(area * sign);
    const bool in_range =
        size < static_cast<double>(std::numeric_limits<T>::max()) / 8;
    t = in_range
            ? static_cast<T>(kUnit * bound +
                             static_cast<double>(std::numeric_limits<T>::min()))
            : std::numeric_limits<T>::quiet_NaN();  // Holds() is false
  }
};

// min(a, b); NaN if b is.
template <class V>
HWY_INLINE V MinOrSecond(V a, V b) {
#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR
  return hn::Min(a, b);
#else
  return IfThenElse(Lt(a, b), a, b);
#endif
}

// min(nearest, |margin|), where `nearest` is not NaN; a margin that is NaN is
// passed over, or makes the result NaN.
#if HWY_TARGET == HWY_AVX3
HWY_INLINE hn::Vec512<float> MinMagnitude(hn::Vec512<float> nearest,
                                          hn::Vec512<float> margin) {
  constexpr int kLeastMagnitudeSignCleared = 0b1010;
  return {_mm512_range_ps(margin.raw, nearest.raw, kLeastMagnitudeSignCleared)};
}
HWY_INLINE hn::Vec512<double> MinMagnitude(hn::Vec512<double> nearest,
                                           hn::Vec512<double> margin) {
  constexpr int kLeastMagnitudeSignCleared = 0b1010;
  return {_mm512_range_pd(margin.raw, nearest.raw, kLeastMagnitudeSignCleared)};
}
#else
template <class V>
HWY_INLINE V MinMagnitude(V nearest, V margin) {
  return hn::Min(Abs(margin), nearest);
}
#endif

// The margin of points to one triangle, which decides beyond ±f.t. NaN, which
// decides as well, is outside.
template <class D, class T = TFromD<D>>
HWY_INLINE Vec<D> Margin(D d, const StaticFilter<T>& f, Vec<D> x, Vec<D> y) {
  const auto e0 =
      MulAdd(Set(d, f.a0), x, MulAdd(Set(d, f.b0), y, Set(d, f.c0)));
  const auto e1 =
      MulAdd(Set(d, f.a1), x, MulAdd(Set(d, f.b1), y, Set(d, f.c1)));
  return MinOrSecond(hn::Min(e0, e1), Sub(Sub(Set(d, f.k), e0), e1));
}

// The margin by the other filter: +1, −1 or an undecided 0. Each determinant
// (v − p) × (w − p) has a bound of its own, 4u·(|l| + |r|) and the smallest
// normal number (see exact/contains.cc). Inside where all three are certainly
// of one sign; outside where two certainly differ.
template <class D>
HWY_INLINE Vec<D> Margin(D d, const Triangles<D>& t, Vec<D> x, Vec<D> y) {
  using T = TFromD<D>;
  const auto ax = Sub(t.Ax(), x);
  const auto ay = Sub(t.Ay(), y);
  const auto bx = Sub(t.Bx(), x);
  const auto by = Sub(t.By(), y);
  const auto cx = Sub(t.Cx(), x);
  const auto cy = Sub(t.Cy(), y);
  const auto zero = Zero(d);
  const auto four_u = Set(d, 2 * std::numeric_limits<T>::epsilon());
  const auto least_normal = Set(d, std::numeric_limits<T>::min());
  const auto certain = [&](Vec<D> vx, Vec<D> vy, Vec<D> wx,
                           Vec<D> wy) HWY_ATTR {
    const auto left = Mul(vx, wy);
    const auto right = Mul(vy, wx);
    const auto det = Sub(left, right);
    const auto bound =
        Add(Mul(four_u, Add(Abs(left), Abs(right))), least_normal);
    return IfThenElse(Gt(Abs(det), bound), det, zero);
  };
  const auto ab = certain(ax, ay, bx, by);
  const auto bc = certain(bx, by, cx, cy);
  const auto ca = certain(cx, cy, ax, ay);
  const auto least = hn::Min(hn::Min(ab, bc), ca);
  const auto most = hn::Max(hn::Max(ab, bc), ca);
  const auto one = Set(d, T{1});
  const auto outside = And(Lt(least, zero), Gt(most, zero));
  const auto inside = Or(Gt(least, zero), Lt(most, zero));
  return IfThenElse(inside, one, IfThenElse(outside, Sub(zero, one), zero));
}

// Answers for items `first` to `end`, of which those that their margin leaves
// undecided are answered by contains(i). `first` is a multiple of 8; bits past
// `end` in its last byte become 0. See WriteFiltered, whose functions are
// copied here: if their addresses got out, every bit stored might change what
// they hold, and the compiler would load it all again for each vector.
template <class D, class MarginAt, class TailAt, class Contains>
static HWY_NOINLINE void Decide(D d, std::size_t first, std::size_t end,
                                TFromD<D> t, std::uint8_t* bits,
                                MarginAt margin_at, TailAt tail_at,
                                Contains contains) {
  const std::size_t lanes = hn::Lanes(d);
  const std::size_t step = HWY_MAX(lanes, std::size_t{8});
  for (; first < end; first += step) {
    const std::size_t count = HWY_MIN(step, end - first);
    std::uint64_t inside = 0;
    std::uint64_t undecided = 0;
    for (std::size_t j = 0; j < count; j += lanes) {
      const std::size_t exist = HWY_MIN(lanes, count - j);
      const auto margin =
          exist == lanes ? margin_at(first + j) : tail_at(first + j, exist);
      const auto real = hn::FirstN(d, exist);
      const auto threshold = Set(d, t);
      inside |= MaskBits(d, And(Gt(margin, threshold), real)) << j;
      undecided |= MaskBits(d, And(Le(Abs(margin), threshold), real)) << j;
    }
    for (; undecided != 0; undecided &= undecided - 1) {
      const auto bit = hwy::Num0BitsBelowLS1Bit_Nonzero64(undecided);
      inside |= std::uint64_t{contains(first + bit)} << bit;
    }
    std::memcpy(bits + first / 8, &inside, BitBytes(count));
  }
}

// Writes n answers. margin_at(i) gives the margins of the items from i on, all
// of which exist; tail_at(i, count) those of the last count < Lanes(d) items;
// beyond ±t they decide, else contains(i) answers for one item exactly.
template <class D, class MarginAt, class TailAt, class Contains>
HWY_INLINE void WriteFiltered(D d, std::size_t n, TFromD<D> t,
                              std::uint8_t* bits, const MarginAt& margin_at,
                              const TailAt& tail_at, const Contains& contains) {
  const std::size_t lanes = hn::Lanes(d);
  const std::size_t step = HWY_MAX(lanes, std::size_t{8});
  // So many items share one look at whether all are decided.
  const std::size_t block = 8 * step;
  const std::size_t whole = n - n % block;
  std::size_t first = 0;
  while (first < whole) {
    // No call in this loop, so that its constants stay in registers.
    bool decided = true;
    for (; first < whole; first += block) {
      const auto threshold = Set(d, t);
      std::uint8_t* const to = bits + first / 8;
      auto nearest = Set(d, std::numeric_limits<TFromD<D>>::max());
#pragma GCC unroll 8
      for (std::size_t i = 0; i < block; i += step) {
        if (lanes >= 8) {
          const auto margin = margin_at(first + i);
          nearest = MinMagnitude(nearest, margin);
          hn::StoreMaskBits(d, Gt(margin, threshold), to + i / 8);
        } else {
          std::uint64_t byte = 0;
          for (std::size_t j = 0; j < 8; j += lanes) {
            const auto margin = margin_at(first + i + j);
            nearest = MinMagnitude(nearest, margin);
            byte |= MaskBits(d, Gt(margin, threshold)) << j;
          }
          to[i / 8] = static_cast<std::uint8_t>(byte);
        }
      }
      decided = hn::AllTrue(d, Gt(nearest, threshold));
      if (HWY_UNLIKELY(!decided)) break;
    }
    if (!decided) {
      Decide(d, first, first + block, t, bits, margin_at, tail_at, contains);
      first += block;
    }
  }
  Decide(d, first, n, t, bits, margin_at, tail_at, contains);
}

template <class T, Boundary kBoundary>
static void FilteredOneTriangle(const Batch<T>& batch, const Result<T>& to) {
  using D = Lanes<T>;
  const D d;
  const std::size_t n = batch.n;
  const T* const px = batch.px;
  const T* const py = batch.py;
  std::uint8_t* const bits = to.bits;
  const Corners<T> corners{*batch.ax, *batch.ay, *batch.bx,
                           *batch.by, *batch.cx, *batch.cy};
  const StaticFilter<T> filter(corners);
  const auto write = [=](T t, auto margin) HWY_ATTR {
    WriteFiltered(
        d, n, t, bits,
        [=](std::size_t i) HWY_ATTR {
          return margin(hn::LoadU(d, px + i), hn::LoadU(d, py + i));
        },
        [=](std::size_t i, std::size_t count) HWY_ATTR {
          const Tail<D> x(px + i, count);
          const Tail<D> y(py + i, count);
          return margin(hn::Load(d, x.data()), hn::Load(d, y.data()));
        },
        [=](std::size_t i) {
          return ExactlyContains(kBoundary, corners, px[i], py[i]);
        });
  };
  if (filter.Holds()) {
    write(filter.t,
          [=](Vec<D> x, Vec<D> y) HWY_ATTR { return Margin(d, filter, x, y); });
  } else if (ExactOrientation(corners) == 0) {
    std::memset(bits, 0, BitBytes(n));
  } else {
    HWY_ALIGN T all[6][kMaxLanes<D>];  // every lane has the same triangle
    hn::Store(Set(d, corners.ax), d, all[0]);
    hn::Store(Set(d, corners.ay), d, all[1]);
    hn::Store(Set(d, corners.bx), d, all[2]);
    hn::Store(Set(d, corners.by), d, all[3]);
    hn::Store(Set(d, corners.cx), d, all[4]);
    hn::Store(Set(d, corners.cy), d, all[5]);
    const Triangles<D> same{d, all[0], all[1], all[2], all[3], all[4], all[5]};
    write(T{0},
          [=](Vec<D> x, Vec<D> y) HWY_ATTR { return Margin(d, same, x, y); });
  }
}

template <class T, Boundary kBoundary, bool kOnePoint>
static HWY_INLINE void FilteredManyTriangles(const Batch<T>& batch,
                                             const Result<T>& to) {
  using D = Lanes<T>;
  const D d;
  const Batch<T> b = batch;  // local, so that no store can alias it
  const T x0 = kOnePoint && b.n != 0 ? *b.px : T{0};
  const T y0 = kOnePoint && b.n != 0 ? *b.py : T{0};
  WriteFiltered(
      d, b.n, T{0}, to.bits,
      [=](std::size_t i) HWY_ATTR {
        const Triangles<D> t{d,        b.ax + i, b.ay + i, b.bx + i,
                             b.by + i, b.cx + i, b.cy + i};
        return Margin(d, t, kOnePoint ? Set(d, x0) : hn::LoadU(d, b.px + i),
                      kOnePoint ? Set(d, y0) : hn::LoadU(d, b.py + i));
      },
      [=](std::size_t i, std::size_t count) HWY_ATTR {
        const Tail<D> ax(b.ax + i, count), ay(b.ay + i, count);
        const Tail<D> bx(b.bx + i, count), by(b.by + i, count);
        const Tail<D> cx(b.cx + i, count), cy(b.cy + i, count);
        const Tail<D> px(kOnePoint ? b.px : b.px + i, kOnePoint ? 1 : count);
        const Tail<D> py(kOnePoint ? b.py : b.py + i, kOnePoint ? 1 : count);
        const Triangles<D> t{d,         ax.data(), ay.data(), bx.data(),
                             by.data(), cx.data(), cy.data()};
        return Margin(d, t, kOnePoint ? Set(d, x0) : hn::Load(d, px.data()),
                      kOnePoint ? Set(d, y0) : hn::Load(d, py.data()));
      },
      [=](std::size_t i) {
        return ExactlyContains<T>(
            kBoundary, {b.ax[i], b.ay[i], b.bx[i], b.by[i], b.cx[i], b.cy[i]},
            kOnePoint ? x0 : b.px[i], kOnePoint ? y0 : b.py[i]);
      });
}

template <class T, Boundary kBoundary>
static void FilteredOnePoint(const Batch<T>& batch, const Result<T>& to) {
  FilteredManyTriangles<T, kBoundary, true>(batch, to);
}

template <class T, Boundary kBoundary>
static void FilteredPairs(const Batch<T>& batch, const Result<T>& to) {
  FilteredManyTriangles<T, kBoundary, false>(batch, to);
}

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

#endif  // include guard that Highway toggles
