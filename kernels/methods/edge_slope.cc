// Point in triangle by the three edges as lines over x.
//
//   y ≥ s·x + c for an edge below the triangle, y ≤ s·x + c for one above it
//
// A triangle without a vertical edge has two edges below and one above, or one
// below and two above; which it is, is known once for a triangle. A vertical
// edge bounds x itself, on one side; on the other the lines meet.
//
// Set-up: three divisions, in double precision. Per point: 3 multiplications,
// 3 additions, 1 Max or Min, 1 subtraction, 2 compares; with FMA 3 MulAdd, 1
// Max or Min, 2 compares. With a vertical edge a third less arithmetic and a
// compare more. For one triangle only: a division an answer would not pay.
// Boundary: closed. Winding: any. Degenerate: contains nothing.
// Fails: near an edge as far as s·x + c rounds, which for a steep edge is s
// times as far in y, but as far across the edge as for a flat one. Both
// triangles at an edge compute the same line, from its left vertex, and without
// FMA compare y with the same number: no point near one shared edge is lost
// between them. An edge so steep that s overflows loses the triangle.
// Worst known f32 inputs, A B C p (tests/worst_inputs.csv has f64 as well):
//   edge_slope, said inside, is 1.26e+07 ulps outside:
//     (0x1.bp-1, 0x1.e97f56p-1) (0x1.a8p-1, 0x1.e97f56p-1)
//     (0x1.9p-2, 0x1.e97f5cp-1) (-0x1.7p-2, 0x1.e97f66p-1)
//   edge_slope_fma, said inside, is 1.53e+07 ulps outside:
//     (-0x1.f4p-1, 0x1.4d2d32p-1) (-0x1.b38p-1, 0x1.4d2d3p-1)
//     (-0x1.f2p-1, 0x1.4d2d32p-1) (0x1.fp-5, 0x1.4d2d22p-1)

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/methods/edge_slope.cc"
#include <hwy/foreach_target.h>

#include "kernels/edge_lines-inl.h"
#include "kernels/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

// y = s·x + c
template <class T, bool kFma>
struct Line {
  Number<T> s, c;

  HWY_INLINE explicit Line(const typename EdgeLines<T>::Line& line)
      : s(line.s), c(static_cast<Number<T>>(line.c)) {}

  template <class E>
  HWY_INLINE Vec<E> At(E e, Vec<E> x) const {
    if constexpr (kFma) {
      return MulAdd(Set(e, s), x, Set(e, c));
    } else {
      return Add(Mul(Set(e, s), x), Set(e, c));
    }
  }
};

// The forms. A point with an infinite x has to be outside: there the lines are
// infinite, and those below and above are so the wrong way round, since they
// meet; but where both coordinates are infinite, y may equal a line on both
// sides. So on the side where one line is alone y is subtracted from it before
// anything is compared, which then gives NaN. Without FMA that is its distance,
// of which the sign is that of the comparison, for finite numbers; with FMA y
// takes the place of c in the multiply-add, and −c is what it is compared with.
template <class T, bool kFma, bool kTwoBelow>
struct ThreeLines {
  Line<T, kFma> pair0, pair1, alone;

  template <class E>
  HWY_INLINE Mask<E> Inside(E e, Vec<E> x, Vec<E> y) const {
    const auto line0 = pair0.At(e, x);
    const auto line1 = pair1.At(e, x);
    const auto in = kTwoBelow ? Ge(y, MaxOrSecond(line0, line1))
                              : Le(y, MinOrSecond(line0, line1));
    if constexpr (kFma) {
      const auto way = MulSub(Set(e, alone.s), x, y);
      const auto bound = Set(e, -alone.c);
      return kTwoBelow ? AndGe(in, way, bound) : AndLe(in, way, bound);
    } else {
      const auto line = alone.At(e, x);
      return AndGe(in, kTwoBelow ? Sub(line, y) : Sub(y, line), Zero(e));
    }
  }
};

// The lines meet in the vertex opposite the vertical edge, so that x is bounded
// on one side by the edge and on the other by y.
template <class T, bool kFma>
struct OneVertical {
  Line<T, kFma> below, above;
  Number<T> turn;  // −0 where the triangle lies to the left of the edge, else 0
  Number<T> least;  // what x is compared with, once turned

  template <class E>
  HWY_INLINE Mask<E> Inside(E e, Vec<E> x, Vec<E> y) const {
    const auto in_x = Ge(hn::Xor(x, Set(e, turn)), Set(e, least));
    const auto in = AndGe(in_x, y, below.At(e, x));
    return AndGe(in, Sub(above.At(e, x), y), Zero(e));
  }
};

template <class D, bool kFma>
class EdgeSlope {
  using T = TFromD<D>;
  using Form = Line<T, kFma>;

 public:
  HWY_INLINE EdgeSlope(D d, const Triangles<D>& t)
      : EdgeSlope(d, t, DoubleArea(t)) {}

  // Where the triangle contains nothing, x is compared with NaN.
  template <class Walk>
  HWY_INLINE void Choose(const Walk& walk) const {
    using Edge = typename EdgeLines<T>::Line;
    lines_.Choose(
        [&](const Edge& pair0, const Edge& pair1, const Edge& above) HWY_ATTR {
          walk(
              ThreeLines<T, kFma, true>{Form(pair0), Form(pair1), Form(above)});
        },
        [&](const Edge& pair0, const Edge& pair1, const Edge& below) HWY_ATTR {
          walk(ThreeLines<T, kFma, false>{Form(pair0), Form(pair1),
                                          Form(below)});
        },
        [&](const Edge& below, const Edge& above, Number<T> x, bool right)
            HWY_ATTR {
              walk(OneVertical<T, kFma>{Form(below), Form(above),
                                        right ? T{0} : -T{0}, right ? x : -x});
            });
  }

 private:
  HWY_INLINE EdgeSlope(D d, const Triangles<D>& t, Vec<D> area)
      : lines_(Corners<T>{*t.ax, *t.ay, *t.bx, *t.by, *t.cx, *t.cy},
               hn::GetLane(area) < 0, hn::AllTrue(d, IsValidArea(d, area))) {}

  EdgeLines<T> lines_;
};

template <class D>
using EdgeSlopePlain = EdgeSlope<D, false>;
template <class D>
using EdgeSlopeFma = EdgeSlope<D, true>;

constexpr Method kEdgeSlope{
    .key = "edge_slope",
    .source = "slope-intercept form of Pineda's edges",
    .formula = "y ≥ s·x + c for edges below, y ≤ s·x + c for edges above",
};
constexpr Method kEdgeSlopeFma{
    .key = "edge_slope_fma",
    .source = kEdgeSlope.source,
    .formula = kEdgeSlope.formula,
    .fma = true,
};

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

PITBENCH_KERNELS(edge_slope,
                 OneTriangleRows<EdgeSlopePlain>(kEdgeSlope) +
                     AosRows<EdgeSlopePlain>(kEdgeSlope) +
                     OneTriangleFmaRows<EdgeSlopeFma>(kEdgeSlopeFma) +
                     AosFmaRows<EdgeSlopeFma>(kEdgeSlopeFma));
