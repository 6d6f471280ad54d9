// What several methods keep of a triangle: its vertices as seen from the point,
// its edges, and which of them it owns.
#if defined(PITBENCH_KERNELS_TRIANGLE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PITBENCH_KERNELS_TRIANGLE_INL_H_
#undef PITBENCH_KERNELS_TRIANGLE_INL_H_
#else
#define PITBENCH_KERNELS_TRIANGLE_INL_H_
#endif

#include "kernels/method-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

template <class D>
struct Vertices {
  Held<D> ax, ay, bx, by, cx, cy;
};

template <class D>
HWY_INLINE Vertices<D> AsTheyAre(D d, const Triangles<D>& t) {
  return {Held<D>(d, t.Ax()), Held<D>(d, t.Ay()), Held<D>(d, t.Bx()),
          Held<D>(d, t.By()), Held<D>(d, t.Cx()), Held<D>(d, t.Cy())};
}

// The vertices in their order; A is NaN where the triangle contains nothing.
template <class D>
HWY_INLINE Vertices<D> ValidVertices(D d, const Triangles<D>& t) {
  const auto area = DoubleArea(t);
  return {Held<D>(d, ValidOrNaN(d, area, t.Ax())),
          Held<D>(d, ValidOrNaN(d, area, t.Ay())),
          Held<D>(d, t.Bx()),
          Held<D>(d, t.By()),
          Held<D>(d, t.Cx()),
          Held<D>(d, t.Cy())};
}

// The vertices with this A, and with B and C exchanged in the triangles that
// are clockwise.
template <class D>
HWY_INLINE Vertices<D> Exchanged(D d, const Triangles<D>& t, Vec<D> ax,
                                 Vec<D> ay, Mask<D> clockwise) {
  return {Held<D>(d, ax),
          Held<D>(d, ay),
          Held<D>(d, IfThenElse(clockwise, t.Cx(), t.Bx())),
          Held<D>(d, IfThenElse(clockwise, t.Cy(), t.By())),
          Held<D>(d, IfThenElse(clockwise, t.Bx(), t.Cx())),
          Held<D>(d, IfThenElse(clockwise, t.By(), t.Cy()))};
}

// The vertices counter-clockwise; A is NaN in the triangles that are not valid.
template <class D>
HWY_INLINE Vertices<D> CounterClockwise(D d, const Triangles<D>& t,
                                        Mask<D> valid, Mask<D> clockwise) {
  const auto nan = Set(d, std::numeric_limits<TFromD<D>>::quiet_NaN());
  return Exchanged(d, t, IfThenElse(valid, t.Ax(), nan),
                   IfThenElse(valid, t.Ay(), nan), clockwise);
}

// The same by the sign of `area`, which is DoubleArea or better.
template <class D>
HWY_INLINE Vertices<D> CounterClockwise(D d, const Triangles<D>& t,
                                        Vec<D> area) {
  return Exchanged(d, t, ValidOrNaN(d, area, t.Ax()),
                   ValidOrNaN(d, area, t.Ay()), Lt(area, Zero(d)));
}

// The three cross products (v − P) × (w − P) of the edges vw: of BC, CA, AB.
// Each is the weight of the vertex across from its edge, times twice the area.
// Without FMA exchanging v and w negates it exactly, so that two triangles
// never disagree on an edge that they share.
template <bool kFma, class D, class E>
HWY_INLINE void CrossFromPoint(const Vertices<D>& v, E e, Vec<E> x, Vec<E> y,
                               Vec<E>& sa, Vec<E>& sb, Vec<E>& sc) {
  const auto xa = Sub(v.ax.In(e), x);
  const auto ya = Sub(v.ay.In(e), y);
  const auto xb = Sub(v.bx.In(e), x);
  const auto yb = Sub(v.by.In(e), y);
  const auto xc = Sub(v.cx.In(e), x);
  const auto yc = Sub(v.cy.In(e), y);
  sa = DifferenceOfProducts<kFma>(xb, yc, xc, yb);
  sb = DifferenceOfProducts<kFma>(xc, ya, xa, yc);
  sc = DifferenceOfProducts<kFma>(xa, yb, xb, ya);
}

// An edge: the vertex v that it starts from and the vector e to the next one,
// turned so that the triangle is on its left; NaN where that contains nothing.
template <class D>
struct Edge {
  Held<D> vx, vy, ex, ey;

  HWY_INLINE Edge(D d, Vec<D> from_x, Vec<D> from_y, Vec<D> to_x, Vec<D> to_y,
                  Vec<D> winding)
      : vx(d, from_x),
        vy(d, from_y),
        ex(d, Mul(Sub(to_x, from_x), winding)),
        ey(d, Mul(Sub(to_y, from_y), winding)) {}
};

template <class D>
struct Edges {
  Edge<D> ab, bc, ca;

  HWY_INLINE Edges(D d, const Triangles<D>& t)
      : Edges(d, t, Winding(d, DoubleArea(t))) {}

 private:
  HWY_INLINE Edges(D d, const Triangles<D>& t, Vec<D> winding)
      : ab(d, t.Ax(), t.Ay(), t.Bx(), t.By(), winding),
        bc(d, t.Bx(), t.By(), t.Cx(), t.Cy(), winding),
        ca(d, t.Cx(), t.Cy(), t.Ax(), t.Ay(), winding) {}
};

// e × (P − v)
template <bool kFma, class D, class E>
HWY_INLINE Vec<E> EdgeCross(const Edge<D>& edge, E e, Vec<E> x, Vec<E> y) {
  return DifferenceOfProducts<kFma>(edge.ex.In(e), Sub(y, edge.vy.In(e)),  //
                                    edge.ey.In(e), Sub(x, edge.vx.In(e)));
}

// What an edge's determinant must at least be for the point to be inside: 0, or
// where the rule gives the edge's points away the smallest number above it, so
// that one comparison serves both kinds of edge.
template <class D, Boundary kBoundary>
class Least {
  static_assert(kBoundary == Boundary::kClosed);

 public:
  HWY_INLINE Least(D, Vec<D>, Vec<D>) {}
  template <class E>
  HWY_INLINE Vec<E> In(E e) const {
    return Zero(e);
  }
};

template <class D>
class Least<D, Boundary::kTopLeft> {
 public:
  // (ex, ey) is the edge with the triangle on its left: left edges go down and
  // top edges to the left, y being upwards.
  HWY_INLINE Least(D d, Vec<D> ex, Vec<D> ey)
      : least_(d, IfThenElse(
                      Or(Lt(ey, Zero(d)),
                         And(hn::Eq(ey, Zero(d)), Lt(ex, Zero(d)))),
                      Zero(d),
                      Set(d, std::numeric_limits<TFromD<D>>::denorm_min()))) {}
  template <class E>
  HWY_INLINE Vec<E> In(E e) const {
    return least_.In(e);
  }

 private:
  Held<D> least_;
};

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

#endif  // include guard that Highway toggles
