// The edges of one triangle as lines y = s·x + c.
//
// The points of a triangle without a vertical edge lie above two of the lines
// and below one, or above one and below two; with a vertical edge they lie
// above one, below one, and on one side of an x. Which it is, is known once for
// a triangle; then a point costs three lines, or two.
#if defined(PITBENCH_KERNELS_EDGE_LINES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PITBENCH_KERNELS_EDGE_LINES_INL_H_
#undef PITBENCH_KERNELS_EDGE_LINES_INL_H_
#else
#define PITBENCH_KERNELS_EDGE_LINES_INL_H_
#endif

#include "kernels/exact/contains.h"
#include "kernels/method-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

// |x| of a number; std::abs would be an inline function that ISAs share.
template <class N>
HWY_INLINE N MagnitudeOf(N x) {
  if constexpr (std::is_same_v<N, double>) {
    return __builtin_fabs(x);
  } else if constexpr (std::is_same_v<N, float>) {
    return __builtin_fabsf(x);
  } else {
    return x < 0 ? -x : x;
  }
}
HWY_INLINE Number<double> Magnitude(Number<double> x) { return MagnitudeOf(x); }

// The edges 0, 1 and 2 with the one last that lies alone on its side of the
// triangle, by which of them lie above (bit k: edge k); that none or all do
// comes from an overflow.
constexpr unsigned char kEdgeOrder[8][3] = {{1, 2, 0}, {1, 2, 0}, {2, 0, 1},
                                            {0, 1, 2}, {0, 1, 2}, {2, 0, 1},
                                            {1, 2, 0}, {1, 2, 0}};

// The lines, computed in double precision, with s as T has it: for f32 s is
// rounded once (the differences are nearly always exact, and what double
// precision rounds does not show); for f64 s is within 3 units of roundoff and
// c within 5·|s·x| + |y| of them, (x, y) being the edge's left vertex.
//
// Which line lies where is looked up and not branched on: for triangles that
// come in no order a branch would be mispredicted as often as not.
template <class T>
class EdgeLines {
 public:
  struct Line {
    Number<T> s;
    Number<double> c;
  };

  // `clockwise`: abc is. `valid`: it contains anything.
  HWY_INLINE EdgeLines(const Corners<T>& t, bool clockwise, bool valid) {
    unsigned leftward = 0;
    unsigned vertical = 0;
    const Number<double> ax = t.ax, ay = t.ay;
    const Number<double> bx = t.bx, by = t.by;
    const Number<double> cx = t.cx, cy = t.cy;
    SetEdge(0, ax, ay, bx, by, leftward, vertical);
    SetEdge(1, bx, by, cx, cy, leftward, vertical);
    SetEdge(2, cx, cy, ax, ay, leftward, vertical);
    above_ = leftward ^ (7U * clockwise);
    if (HWY_UNLIKELY(vertical != 0 || !valid)) {
      const Number<double> x[3] = {ax, bx, cx};
      const Number<double> y[3] = {ay, by, cy};
      SetVertical(valid ? vertical : 0, clockwise, x, y);
    }
  }

  // The largest |s|, before it was rounded to T.
  HWY_INLINE Number<double> Steepest() const { return steepest_; }

  // Calls the one that the triangle has: two_below(pair0, pair1, above),
  // two_above(pair0, pair1, below), or one_vertical(below, above, x, right)
  // with the x of the vertical edge and whether the triangle lies to its right.
  // The x is NaN where the triangle contains nothing.
  template <class TwoBelow, class TwoAbove, class OneVertical>
  HWY_INLINE void Choose(const TwoBelow& two_below, const TwoAbove& two_above,
                         const OneVertical& one_vertical) const {
    const Line& first = lines_[kEdgeOrder[above_][0]];
    const Line& second = lines_[kEdgeOrder[above_][1]];
    const Line& alone = lines_[kEdgeOrder[above_][2]];
    if (HWY_UNLIKELY(has_vertical_)) {
      one_vertical(lines_[below_index_], lines_[above_index_], vertical_x_,
                   right_of_vertical_);
    } else if ((above_ & (above_ - 1)) == 0) {
      two_below(first, second, alone);
    } else {
      two_above(first, second, alone);
    }
  }

 private:
  // Edge k from v to w; sets bit k of `leftward` and of `vertical` if it is.
  // Must be inlined: a function of its own would be one that objects share.
  HWY_INLINE void SetEdge(unsigned k, Number<double> vx, Number<double> vy,
                          Number<double> wx, Number<double> wy,
                          unsigned& leftward, unsigned& vertical) {
    const Number<double> run = wx - vx;
    const Number<double> s = (wy - vy) / run;
    // From the left vertex, the same whichever way the edge runs: neighbours
    // compute the same line.
    const Number<double> ends[2][2] = {{vx, vy}, {wx, wy}};
    const unsigned turned = run < 0;
    const auto& left = ends[turned];
    lines_[k] = {static_cast<Number<T>>(s), left[1] - s * left[0]};
    steepest_ = k == 0 ? MagnitudeOf(s) : HWY_MAX(steepest_, MagnitudeOf(s));
    leftward |= turned << k;
    if (HWY_UNLIKELY(run == 0)) vertical |= 1U << k;
  }

  HWY_INLINE void SetVertical(unsigned vertical, bool clockwise,
                              const Number<double> (&x)[3],
                              const Number<double> (&y)[3]) {
    has_vertical_ = true;
    vertical_x_ = std::numeric_limits<T>::quiet_NaN();
    const unsigned edge = vertical >> 1;  // of one bit: 1, 2, 4 are 0, 1, 2
    const unsigned others = above_ & ~vertical & 7;
    const bool one_each = others != 0 && (others | vertical) != 7;
    if ((vertical != 1 && vertical != 2 && vertical != 4) || !one_each) return;
    const auto steepness = [this](unsigned k) {
      return static_cast<Number<double>>(MagnitudeOf(lines_[k].s));
    };
    above_index_ = others >> 1;
    below_index_ = 3 - edge - above_index_;
    steepest_ = HWY_MAX(steepness(below_index_), steepness(above_index_));
    vertical_x_ = static_cast<Number<T>>(x[edge]);
    right_of_vertical_ = (y[(edge + 1) % 3] < y[edge]) != clockwise;
  }

  Line lines_[3];
  Number<double> steepest_;
  unsigned above_;  // bit k: edge k does
  bool has_vertical_ = false;
  // If so:
  unsigned below_index_ = 0;
  unsigned above_index_ = 0;
  Number<T> vertical_x_ = 0;
  bool right_of_vertical_ = false;
};

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

#endif  // include guard that Highway toggles
