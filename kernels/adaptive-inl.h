// Methods that ask a filter first and expansions where it cannot tell:
// Shewchuk's and Ozaki's. What a Filter is, is said in orient2d-inl.h.
#if defined(PITBENCH_KERNELS_ADAPTIVE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PITBENCH_KERNELS_ADAPTIVE_INL_H_
#undef PITBENCH_KERNELS_ADAPTIVE_INL_H_
#else
#define PITBENCH_KERNELS_ADAPTIVE_INL_H_
#endif

#include "kernels/orient2d-inl.h"
#include "kernels/triangle-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

// The coordinates of as many triangles and points as there are lanes, and what
// is asked of them.
template <class D>
struct Undecided {
  using T = TFromD<D>;
  HWY_ALIGN T ax[kMaxLanes<D>], ay[kMaxLanes<D>];
  HWY_ALIGN T bx[kMaxLanes<D>], by[kMaxLanes<D>];
  HWY_ALIGN T cx[kMaxLanes<D>], cy[kMaxLanes<D>];
  HWY_ALIGN T px[kMaxLanes<D>], py[kMaxLanes<D>];
  HWY_ALIGN T answer[kMaxLanes<D>];  // 0: not asked
};

// Replaces each answer that is asked for by 1 where the point is in the
// counter-clockwise triangle, by 0 where it is not.
template <class Filter, class D>
static HWY_NOINLINE void AnswerLanes(Undecided<D>& q, std::size_t lanes) {
  for (std::size_t i = 0; i < lanes; ++i) {
    if (q.answer[i] == 0) continue;
    const auto x = q.px[i];
    const auto y = q.py[i];
    q.answer[i] =
        Orient2d<Filter>(q.ax[i], q.ay[i], q.bx[i], q.by[i], x, y) >= 0 &&
        Orient2d<Filter>(q.bx[i], q.by[i], q.cx[i], q.cy[i], x, y) >= 0 &&
        Orient2d<Filter>(q.cx[i], q.cy[i], q.ax[i], q.ay[i], x, y) >= 0;
  }
}

// The sign of each determinant (v − P) × (w − P) by Filter, where that decides,
// and else by expansions. A point that is surely beyond one edge is decided
// whatever the others say.
template <class D, class Filter>
class Adaptive {
  using T = TFromD<D>;

 public:
  HWY_INLINE Adaptive(D d, const Triangles<D>& t)
      : vertices_(CounterClockwise(d, t, Area(d, t))) {}

  template <class E>
  HWY_INLINE Mask<E> Inside(E e, Vec<E> x, Vec<E> y) const {
    const auto& v = vertices_;
    const auto xa = Sub(v.ax.In(e), x);
    const auto ya = Sub(v.ay.In(e), y);
    const auto xb = Sub(v.bx.In(e), x);
    const auto yb = Sub(v.by.In(e), y);
    const auto xc = Sub(v.cx.In(e), x);
    const auto yc = Sub(v.cy.In(e), y);
    auto bound0 = x;
    auto bound1 = x;
    auto bound2 = x;
    const auto det0 = Filtered(e, xa, ya, xb, yb, bound0);
    const auto det1 = Filtered(e, xb, yb, xc, yc, bound1);
    const auto det2 = Filtered(e, xc, yc, xa, ya, bound2);
    const auto surely =
        Filter::kMayEqual
            ? AllAtLeast(det0, bound0, det1, bound1, det2, bound2)
            : AndLt(AndLt(Lt(bound0, det0), bound1, det1), bound2, det2);
    const auto maybe = AllAtLeast(det0, hn::Neg(bound0), det1, hn::Neg(bound1),
                                  det2, hn::Neg(bound2));
    const auto undecided = hn::AndNot(surely, maybe);
    if (HWY_LIKELY(hn::AllFalse(e, undecided))) return surely;
    return Or(surely, Resolved(e, x, y, undecided));
  }

 private:
  // The determinant of (ux, uy) and (vx, vy), and the bound of its error.
  template <class E>
  static HWY_INLINE Vec<E> Filtered(E e, Vec<E> ux, Vec<E> uy, Vec<E> vx,
                                    Vec<E> vy, Vec<E>& bound) {
    const auto left = Mul(ux, vy);
    const auto right = Mul(uy, vx);
    bound = Filter::BoundOf(e, left, right);
    return Sub(left, right);
  }

  template <class E>
  HWY_INLINE Mask<E> Resolved(E e, Vec<E> x, Vec<E> y,
                              Mask<E> undecided) const {
    Undecided<E> q;
    hn::Store(vertices_.ax.In(e), e, q.ax);
    hn::Store(vertices_.ay.In(e), e, q.ay);
    hn::Store(vertices_.bx.In(e), e, q.bx);
    hn::Store(vertices_.by.In(e), e, q.by);
    hn::Store(vertices_.cx.In(e), e, q.cx);
    hn::Store(vertices_.cy.In(e), e, q.cy);
    hn::Store(x, e, q.px);
    hn::Store(y, e, q.py);
    const auto one = Set(e, T{1});
    hn::Store(IfThenElse(undecided, one, Zero(e)), e, q.answer);
    AnswerLanes<Filter, E>(q, hn::Lanes(e));
    return Gt(hn::Load(e, q.answer), Zero(e));
  }

  // A number with the sign of the area.
  static HWY_INLINE Vec<D> Area(D d, const Triangles<D>& t) {
    auto bound = Zero(d);
    const auto area = Filtered(d, Sub(t.Ax(), t.Cx()), Sub(t.Ay(), t.Cy()),
                               Sub(t.Bx(), t.Cx()), Sub(t.By(), t.Cy()), bound);
    const auto decided =
        Filter::kMayEqual ? Ge(Abs(area), bound) : Gt(Abs(area), bound);
    if (HWY_LIKELY(hn::AllTrue(d, decided))) return area;
    HWY_ALIGN T exact[kMaxLanes<D>];
    for (std::size_t i = 0; i < hn::Lanes(d); ++i) {
      exact[i] = Orient2d<Filter>(t.ax[i], t.ay[i], t.bx[i], t.by[i], t.cx[i],
                                  t.cy[i]);
    }
    return hn::Load(d, exact);
  }

  Vertices<D> vertices_;
};

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

#endif  // include guard that Highway toggles
