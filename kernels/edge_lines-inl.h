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

// Lines below and above the triangle, in double precision: s within 3 units of
// roundoff, c within 5·|s·x| + |y| of them, (x, y) being the edge's left vertex
// (f32: the slope's differences are nearly always exact, and what double
// precision rounds does not show in f32).
struct EdgeLines {
  struct Line {
    Number<double> s, c;
  };
  Line below[2] = {};
  Line above[2] = {};
  int below_count = 0;
  int above_count = 0;
  // Of a vertical edge; there is one if below_count + above_count is 2.
  Number<double> vertical_x = 0;
  bool right_of_vertical = false;  // the triangle is

  // `winding`: +1 where abc is counter-clockwise, −1 where it is clockwise; NaN
  // leaves both counts 0.
  template <class T>
  HWY_INLINE EdgeLines(const Corners<T>& t, Number<double> winding) {
    Add(t.ax, t.ay, t.bx, t.by, winding);
    Add(t.bx, t.by, t.cx, t.cy, winding);
    Add(t.cx, t.cy, t.ax, t.ay, winding);
  }

 private:
  HWY_INLINE void Add(Number<double> vx, Number<double> vy, Number<double> wx,
                      Number<double> wy, Number<double> winding) {
    const Number<double> run = wx - vx;
    const Number<double> rise = wy - vy;
    // The same whichever way the edge runs: neighbours compute the same line.
    const Number<double> s = rise / run;
    const Line line{s, run < 0 ? wy - s * wx : vy - s * vx};
    const Number<double> side = run * winding;
    if (side > 0) {
      below[below_count++] = line;
    } else if (side < 0) {
      above[above_count++] = line;
    } else if (side == 0) {
      vertical_x = vx;
      right_of_vertical = rise * winding < 0;
    }
  }
};

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

#endif  // include guard that Highway toggles
