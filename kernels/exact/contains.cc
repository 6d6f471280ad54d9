#include "kernels/exact/contains.h"

#include <cmath>
#include <limits>

#include "kernels/exact/big_number.h"

namespace pitbench {
namespace {

// The sign of the area by whole numbers, x and y in units of their own.
int OrientationByIntegers(const Corners<double>& t) {
  const int of_x = CommonUnit({t.ax, t.bx, t.cx});
  const int of_y = CommonUnit({t.ay, t.by, t.cy});
  const SmallWhole ax(t.ax, of_x), bx(t.bx, of_x), cx(t.cx, of_x);
  const SmallWhole ay(t.ay, of_y), by(t.by, of_y), cy(t.cy, of_y);
  if (ax.fits && bx.fits && cx.fits && ay.fits && by.fits && cy.fits) {
    __extension__ using Int128 = __int128;
    const Int128 left = Int128{bx.value - ax.value} * (cy.value - ay.value);
    const Int128 right = Int128{by.value - ay.value} * (cx.value - ax.value);
    return (left > right ? 1 : 0) - (left < right ? 1 : 0);
  }
  const BigNumber<1> a_x(t.ax, of_x);
  const BigNumber<1> a_y(t.ay, of_y);
  return ((BigNumber<1>(t.bx, of_x) - a_x) * (BigNumber<1>(t.cy, of_y) - a_y) -
          (BigNumber<1>(t.by, of_y) - a_y) * (BigNumber<1>(t.cx, of_x) - a_x))
      .Sign();
}

// The sign of the area; a determinant that rounding cannot have turned is
// trusted. The bound is that of harness/truth/orientation.cc's proof: each
// product errs by (3u + 7u²) of itself and half the smallest subnormal, so
// |det| > 4u·(|l| + |r|) + 2^-1022 has the right sign. An overflow makes the
// bound infinite or NaN and the comparison false.
int Orientation(const Corners<double>& t) {
  const double left = (t.bx - t.ax) * (t.cy - t.ay);
  const double right = (t.by - t.ay) * (t.cx - t.ax);
  const double det = left - right;
  const double bound = 2 * std::numeric_limits<double>::epsilon() *
                           (std::abs(left) + std::abs(right)) +
                       std::numeric_limits<double>::min();
  if (det > bound) return 1;
  if (-det > bound) return -1;
  return OrientationByIntegers(t);
}

template <class T>
Corners<double> Widened(const Corners<T>& t) {
  return {t.ax, t.ay, t.bx, t.by, t.cx, t.cy};
}

// Whether an edge of a counter-clockwise triangle is a top or a left one, y
// upwards: it goes down, or level to the left.
bool IsTopLeft(double from_x, double from_y, double to_x, double to_y) {
  return to_y < from_y || (to_y == from_y && to_x < from_x);
}

// x − x is 0 for a finite x and else NaN.
bool IsFinite(const Corners<double>& t) {
  return (t.ax - t.ax) + (t.ay - t.ay) + (t.bx - t.bx) + (t.by - t.by) +
             (t.cx - t.cx) + (t.cy - t.cy) ==
         0;
}

bool Contains(Boundary boundary, const Corners<double>& t, double x, double y) {
  if (!IsFinite(t) || !IsFinite({x, y, 0, 0, 0, 0})) return false;
  const int ab = Orientation({t.ax, t.ay, t.bx, t.by, x, y});
  const int bc = Orientation({t.bx, t.by, t.cx, t.cy, x, y});
  if (ab * bc < 0) return false;
  const int ca = Orientation({t.cx, t.cy, t.ax, t.ay, x, y});
  if (ab * ca < 0 || bc * ca < 0) return false;
  // No two signs differ. The three determinants sum to the triangle's, so its
  // winding is their sign, and if all are 0, so is its area.
  if (ab != 0 && bc != 0 && ca != 0) return true;
  const int winding = ab != 0 ? ab : bc != 0 ? bc : ca;
  if (winding == 0) return false;
  if (boundary != Boundary::kTopLeft) return boundary == Boundary::kClosed;
  const auto counts = [winding](int side, double vx, double vy, double wx,
                                double wy) {
    if (side != 0) return true;
    return winding > 0 ? IsTopLeft(vx, vy, wx, wy) : IsTopLeft(wx, wy, vx, vy);
  };
  return counts(ab, t.ax, t.ay, t.bx, t.by) &&
         counts(bc, t.bx, t.by, t.cx, t.cy) &&
         counts(ca, t.cx, t.cy, t.ax, t.ay);
}

}  // namespace

template <class T>
int ExactOrientation(const Corners<T>& abc) {
  const Corners<double> wide = Widened(abc);
  return IsFinite(wide) ? Orientation(wide) : 0;
}

template <class T>
bool ExactlyContains(Boundary boundary, const Corners<T>& triangle, T x, T y) {
  return Contains(boundary, Widened(triangle), x, y);
}

template int ExactOrientation(const Corners<float>&);
template int ExactOrientation(const Corners<double>&);
template bool ExactlyContains(Boundary, const Corners<float>&, float, float);
template bool ExactlyContains(Boundary, const Corners<double>&, double, double);

}  // namespace pitbench
