// Ray and triangle by a transformation kept with the triangle (Baldwin & Weber
// 2016): it takes A, B and C to (0, 0), (1, 0) and (0, 1) of a plane, and the
// axis in which the normal is largest to the one across it.
//
//   N = (B − A) × (C − A), |N_z| the largest, E1 = B − A, E2 = C − A
//   t = −(N·O − N·A) / (N·D), with N over N_z;  p = O + t·D in x and y
//   u = ( E2y·p_x − E2x·p_y + (C × A)_z) / N_z
//   v = (−E1y·p_x + E1x·p_y − (B × A)_z) / N_z
//   hit iff u ≥ 0, v ≥ 0, u + v ≤ 1 and t in its range
//
// Set-up: the normal, two products of vertices, a division and 9 products with
// it; 9 numbers and which axis. Per ray: 10 multiplications, 12 additions, a
// change of sign, a division, 5 compares.
// Boundary: closed. Winding: any. Degenerate: missed. Parallel: N·D = 0 makes t
// infinite or NaN; but N over N_z rounds even where N is whole. Not finite: t
// is NaN or infinite, or N·D is.
// The axis is found without multiply-adds in the row `_fma` as well.
// Fails: the constants C × A, B × A and N·A grow with the distance from the
// origin of coordinates, and with them the errors of u, v and t.
// Worst known f32 inputs, A B C from O along D (tests/rays/worst_rays.csv has
// f64 and the other rows):
//   baldwin_weber, said hit, is miss, by 1.1e+07 ulps:
//     (-0x1.a96p-4, -0x1.f4753p-2, -0x1.c7b838p-1)
//     (-0x1.a9814p-4, 0x1.ca86p-3, -0x1.c7b838p-1)
//     (-0x1.a9814p-4, 0x1.dp-3, -0x1.c7b83ep-1)
//     from (0x1.45bcp-1, 0x1.b8p-1, -0x1.ce343p-1)
//     along (-0x1.7af8p-1, 0x1p-5, 0x1.9f04p-7)
//   baldwin_weber_fma, said hit, is miss, by 1.2e+06 ulps:
//     (-0x1.c3c8p-1, -0x1.618p-2, 0x1.7c9e64p-1)
//     (-0x1.c3c78p-1, 0x1.76eea2p-1, 0x1.7c9fp-1)
//     (-0x1.c3c78p-1, 0x1.79807ep-1, 0x1.7c9f2p-1)
//     from (0x1.b2424p-2, -0x1.a6p-2, 0x1.58d5cp-2)
//     along (-0x1.4e7234p-1, 0x1.3fp-1, 0x1.a066p-3)

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/rays/methods/baldwin_weber.cc"
#include <hwy/foreach_target.h>

#include "kernels/rays/plane-inl.h"
#include "kernels/rays/ray_rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

template <class D, bool kFma>
class BaldwinWeber {
  using T = TFromD<D>;

 public:
  static constexpr Turn kTurn = Turn::kNormal;

  template <class Triangle>
  HWY_INLINE BaldwinWeber(D d, const Triangle& t)
      : BaldwinWeber(d, t, Normal<kFma>(d, t)) {}

  template <class E, class Ray>
  HWY_INLINE Mask<E> Hit(E e, const Ray& ray, const Range<T>& range, Vec<E>& t,
                         Vec<E>& u, Vec<E>& v) const {
    const auto ox = ray.origin.x.In(e);
    const auto oy = ray.origin.y.In(e);
    const auto oz = ray.origin.z.In(e);
    const auto dx = ray.direction.x.In(e);
    const auto dy = ray.direction.y.In(e);
    const auto dz = ray.direction.z.In(e);
    const auto from = Add(Row(e, tx_, ty_, ox, oy, t0_.In(e)), oz);
    const auto along = Row(e, tx_, ty_, dx, dy, dz);
    t = Div(hn::Neg(from), along);
    const auto x = Along<kFma>(ox, t, dx);
    const auto y = Along<kFma>(oy, t, dy);
    u = Row(e, ux_, uy_, x, y, u0_.In(e));
    v = Row(e, vx_, vy_, x, y, v0_.In(e));
    const auto inside =
        AndInTriangle(e, IsFinite(e, along), u, v, Set(e, T{1}));
    return AndWithin(e, inside, t, range);
  }

 private:
  template <class Triangle>
  HWY_INLINE BaldwinWeber(D d, const Triangle& t, const PointLanes<Held<D>>& n)
      : BaldwinWeber(d, t, n, Held<D>(d, Div(Set(d, T{1}), n.z.In(d)))) {}

  template <class Triangle>
  HWY_INLINE BaldwinWeber(D d, const Triangle& t, const PointLanes<Held<D>>& n,
                          const Held<D>& inverse)
      : tx_(d, Mul(n.x.In(d), inverse.In(d))),
        ty_(d, Mul(n.y.In(d), inverse.In(d))),
        t0_(d, hn::Neg(Add(Row(d, tx_, ty_, t.a.x.In(d), t.a.y.In(d), Zero(d)),
                           t.a.z.In(d)))),
        ux_(d, Mul(Sub(t.c.y.In(d), t.a.y.In(d)), inverse.In(d))),
        uy_(d, Mul(Sub(t.a.x.In(d), t.c.x.In(d)), inverse.In(d))),
        u0_(d, Mul(CrossZ(d, t.c, t.a), inverse.In(d))),
        vx_(d, Mul(Sub(t.a.y.In(d), t.b.y.In(d)), inverse.In(d))),
        vy_(d, Mul(Sub(t.b.x.In(d), t.a.x.In(d)), inverse.In(d))),
        v0_(d, Mul(CrossZ(d, t.a, t.b), inverse.In(d))) {}

  // The z of p × q.
  template <class P, class Q>
  static HWY_INLINE Vec<D> CrossZ(D d, const P& p, const Q& q) {
    return DifferenceOfProducts<kFma>(p.x.In(d), q.y.In(d), p.y.In(d),
                                      q.x.In(d));
  }

  // rx·x + ry·y + constant
  template <class E>
  static HWY_INLINE Vec<E> Row(E e, const Held<D>& rx, const Held<D>& ry,
                               Vec<E> x, Vec<E> y, Vec<E> constant) {
    if constexpr (kFma) {
      return MulAdd(rx.In(e), x, MulAdd(ry.In(e), y, constant));
    } else {
      return Add(Add(Mul(rx.In(e), x), Mul(ry.In(e), y)), constant);
    }
  }

  Held<D> tx_, ty_, t0_;
  Held<D> ux_, uy_, u0_;
  Held<D> vx_, vy_, v0_;
};

template <class D>
using BaldwinWeberPlain = BaldwinWeber<D, false>;
template <class D>
using BaldwinWeberFma = BaldwinWeber<D, true>;

constexpr RayMethod kBaldwinWeber{
    .key = "baldwin_weber",
    .source = "Baldwin & Weber 2016",
    .formula = "(u, v, t) by the rows of a matrix kept with the triangle",
};
constexpr RayMethod kBaldwinWeberFma{
    .key = "baldwin_weber_fma",
    .source = kBaldwinWeber.source,
    .formula = kBaldwinWeber.formula,
    .fma = true,
};

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

PITBENCH_RAY_KERNELS(baldwin_weber,
                     RayRows<BaldwinWeberPlain>(kBaldwinWeber) +
                         RayFmaRows<BaldwinWeberFma>(kBaldwinWeberFma));
