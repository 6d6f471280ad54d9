// Ray and triangle by Cramer's rule (Möller & Trumbore 1997).
//
//   E1 = B − A, E2 = C − A, S = O − A, P = D × E2, Q = S × E1, δ = E1·P
//   u = S·P / δ,  v = D·Q / δ,  t = E2·Q / δ
//   hit iff δ ≠ 0, u ≥ 0, v ≥ 0, u + v ≤ 1 and t in its range
//
// Set-up: 2 edges; nothing else is kept of a triangle. Per ray: 3
// subtractions, 27 multiplications of which 3 by 1/δ, 15 additions and
// subtractions, a division, 5 compares.
// Three rows, and each with multiply-adds: the branchless one; `_early_out`
// with a way out after u, and after v, where no lane is left, and the same
// answers; `_culled`, which hits from the front only and there, as in the
// paper, asks δ > 0, S·P ≥ 0, D·Q ≥ 0, S·P + D·Q ≤ δ before it divides.
// Boundary: closed. Winding: any, or front-facing: δ = −D·(E1 × E2).
// Degenerate: missed, by the set-up. Parallel: δ = 0 makes u infinite or NaN
// wherever δ is computed exactly. Not finite: u or v is then infinite or NaN
// (every coordinate is in a product of both S·P and δ, or of both D·Q and δ).
// Fails: δ near 0, where the ray grazes the plane, and S long, where the
// origin is far: the products of u and v cancel. The edge that two triangles
// share is computed from another vertex in each: rays fall between them.
// Worst known f32 inputs, A B C from O along D (tests/rays/worst_rays.csv has
// f64 and the other rows):
//   moller_trumbore, said hit, is miss, by 4.3e+07 ulps:
//     (0x1.c774d4p-1, 0x1.7dp-1, 0x1.bdffcp-1)
//     (0x1.c774d8p-1, 0x1.2p-1, 0x1.bdffc2p-1)
//     (0x1.c774d8p-1, 0x1.1p-1, 0x1.bdffc2p-1)
//     from (-0x1.ed34acp-1, -0x1.ff8p-1, -0x1.d5d24p-4)
//     along (0x1.da54cp-1, -0x1p+0, 0x1.f8ba06p-2)
//   moller_trumbore_fma, said hit, is miss, by 2.2e+07 ulps:
//     (0x1.d57b14p-1, 0x1.5p-5, -0x1.bea5a4p-1)
//     (0x1.d57b18p-1, -0x1.4p-1, -0x1.bea5aep-1)
//     (0x1.d57af6p-1, -0x1.2p-1, -0x1.bea578p-1)
//     from (-0x1.cc775p-3, 0x1.fffff8p-1, 0x1.99a9dp-1)
//     along (0x1.244c76p-1, 0x1.98p-3, -0x1.ac27bcp-1)
//   moller_trumbore_culled, said hit, is miss, by 3.5e+07 ulps:
//     (-0x1.fe64p-1, -0x1.4151f6p-1, -0x1.39c6fap-1)
//     (-0x1.febcp-1, -0x1.4151f8p-1, -0x1.39c6f8p-1)
//     (-0x1.fep-1, -0x1.4151f8p-1, -0x1.39c6f8p-1)
//     from (0x1.fff8p-1, -0x1.168ba8p-2, -0x1.efd266p-1)
//     along (0x1p-2, -0x1.6c1848p-1, 0x1.6c16dcp-1)

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/rays/methods/moller_trumbore.cc"
#include <hwy/foreach_target.h>

#include "kernels/rays/ray_rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

enum class Rays { kAll, kAllWithWayOut, kFrontFacing };

template <class D, Rays kRays, bool kFma>
class MollerTrumbore {
  using T = TFromD<D>;

 public:
  static constexpr Turn kTurn = Turn::kNone;

  template <class Triangle>
  HWY_INLINE MollerTrumbore(D d, const Triangle& t)
      : ax_(d, t.a.x.In(d)),
        ay_(d, t.a.y.In(d)),
        az_(d, t.a.z.In(d)),
        e1x_(d, Sub(t.b.x.In(d), t.a.x.In(d))),
        e1y_(d, Sub(t.b.y.In(d), t.a.y.In(d))),
        e1z_(d, Sub(t.b.z.In(d), t.a.z.In(d))),
        e2x_(d, Sub(t.c.x.In(d), t.a.x.In(d))),
        e2y_(d, Sub(t.c.y.In(d), t.a.y.In(d))),
        e2z_(d, Sub(t.c.z.In(d), t.a.z.In(d))) {}

  template <class E, class Ray>
  HWY_INLINE Mask<E> Hit(E e, const Ray& ray, const Range<T>& range, Vec<E>& t,
                         Vec<E>& u, Vec<E>& v) const {
    const auto zero = Zero(e);
    const auto one = Set(e, T{1});
    const auto dx = ray.direction.x.In(e);
    const auto dy = ray.direction.y.In(e);
    const auto dz = ray.direction.z.In(e);
    auto px = zero;
    auto py = zero;
    auto pz = zero;
    Cross<kFma>(dx, dy, dz, e2x_.In(e), e2y_.In(e), e2z_.In(e), px, py, pz);
    const auto det = Dot<kFma>(e1x_.In(e), e1y_.In(e), e1z_.In(e), px, py, pz);
    const auto inverse = Div(one, det);
    const auto sx = Sub(ray.origin.x.In(e), ax_.In(e));
    const auto sy = Sub(ray.origin.y.In(e), ay_.In(e));
    const auto sz = Sub(ray.origin.z.In(e), az_.In(e));
    const auto u_det = Dot<kFma>(sx, sy, sz, px, py, pz);
    u = Mul(u_det, inverse);
    if constexpr (kRays == Rays::kAllWithWayOut) {
      const auto left = AndLe(Ge(u, zero), u, one);
      if (hn::AllFalse(e, left)) return left;
    }
    auto qx = zero;
    auto qy = zero;
    auto qz = zero;
    Cross<kFma>(sx, sy, sz, e1x_.In(e), e1y_.In(e), e1z_.In(e), qx, qy, qz);
    const auto v_det = Dot<kFma>(dx, dy, dz, qx, qy, qz);
    v = Mul(v_det, inverse);
    // 1/δ is 0 where δ has overflowed; u and v then say nothing.
    const auto inside = [&]() HWY_ATTR {
      if constexpr (kRays == Rays::kFrontFacing) {
        return AndInTriangle(e, Gt(inverse, zero), u_det, v_det, det);
      } else {
        return AndInTriangle(e, hn::Ne(inverse, zero), u, v, one);
      }
    }();
    if constexpr (kRays == Rays::kAllWithWayOut) {
      if (hn::AllFalse(e, inside)) return inside;
    }
    t = Mul(Dot<kFma>(e2x_.In(e), e2y_.In(e), e2z_.In(e), qx, qy, qz), inverse);
    return AndWithin(e, inside, t, range);
  }

 private:
  Held<D> ax_, ay_, az_;
  Held<D> e1x_, e1y_, e1z_;
  Held<D> e2x_, e2y_, e2z_;
};

template <class D>
using TwoSided = MollerTrumbore<D, Rays::kAll, false>;
template <class D>
using TwoSidedFma = MollerTrumbore<D, Rays::kAll, true>;
template <class D>
using Culled = MollerTrumbore<D, Rays::kFrontFacing, false>;
template <class D>
using CulledFma = MollerTrumbore<D, Rays::kFrontFacing, true>;
template <class D>
using EarlyOut = MollerTrumbore<D, Rays::kAllWithWayOut, false>;
template <class D>
using EarlyOutFma = MollerTrumbore<D, Rays::kAllWithWayOut, true>;

constexpr RayMethod kMollerTrumbore{
    .key = "moller_trumbore",
    .source = "Möller & Trumbore 1997",
    .formula = "u = S·(D×E2)/δ, v = D·(S×E1)/δ; u ≥ 0, v ≥ 0, u + v ≤ 1",
};
constexpr RayMethod kMollerTrumboreFma{
    .key = "moller_trumbore_fma",
    .source = kMollerTrumbore.source,
    .formula = kMollerTrumbore.formula,
    .fma = true,
};
constexpr RayMethod kCulled{
    .key = "moller_trumbore_culled",
    .source = kMollerTrumbore.source,
    .formula = "δ > 0, S·(D×E2) ≥ 0, D·(S×E1) ≥ 0, their sum ≤ δ",
    .culls_backface = true,
};
constexpr RayMethod kCulledFma{
    .key = "moller_trumbore_culled_fma",
    .source = kCulled.source,
    .formula = kCulled.formula,
    .fma = true,
    .culls_backface = true,
};
constexpr RayMethod kEarlyOut{
    .key = "moller_trumbore_early_out",
    .source = kMollerTrumbore.source,
    .formula = "as moller_trumbore, condition by condition until one fails",
};
constexpr RayMethod kEarlyOutFma{
    .key = "moller_trumbore_early_out_fma",
    .source = kEarlyOut.source,
    .formula = kEarlyOut.formula,
    .fma = true,
};

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

PITBENCH_RAY_KERNELS(moller_trumbore,
                     RayRows<TwoSided>(kMollerTrumbore) +
                         RayFmaRows<TwoSidedFma>(kMollerTrumboreFma) +
                         RayRows<Culled>(kCulled) +
                         RayFmaRows<CulledFma>(kCulledFma) +
                         RayRows<EarlyOut>(kEarlyOut) +
                         RayFmaRows<EarlyOutFma>(kEarlyOutFma));
