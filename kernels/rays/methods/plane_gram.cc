// Ray and triangle by the plane and the normal equations: where the ray meets
// the plane, and the coordinates of that point along the triangle's edges by
// least squares, as courses on ray tracing have it.
//
//   a = B − A, b = C − A, N = a × b,  t = (A·N − O·N) / (D·N)
//   x = O + t·D − A,  (α, β)ᵀ = G⁻¹·(a·x, b·x)ᵀ,  G = [a·a a·b; a·b b·b]
//   hit iff α ≥ 0, β ≥ 0, α + β ≤ 1 and t in its range;  u = α, v = β
//
// Set-up: the normal and the inverse of the Gram matrix G, with one division.
// Per ray: 19 multiplications, 18 additions and subtractions, a division, 5
// compares.
// Boundary: closed. Winding: any. Degenerate: missed. Parallel: D·N = 0 makes t
// infinite or NaN. Not finite: t is NaN or infinite, or D·N is.
// Fails: |A·N| and |O·N| grow with the distance from the origin of coordinates
// and with them the error of t; det G = |N|² is the difference of two products
// that are alike in a needle, which loses twice the digits that N loses.
// Worst known f32 inputs, A B C from O along D (tests/rays/worst_rays.csv has
// f64 and the other rows):
//   plane_gram, said hit, is miss, by 4.8e+07 ulps:
//     (0x1.2c88bep-2, -0x1.d21d92p-1, 0x1.83914ap-1)
//     (0x1.3d41ep-1, -0x1.cab1cep-1, 0x1.2ef6fep-1)
//     (0x1.3d58e8p-3, -0x1.d5448p-1, 0x1.a780dp-1)
//     from (-0x1.ffcp-1, 0x1.e4p-1, -0x1.fff94p-1)
//     along (-0x1.f8p-1, -0x1p-5, 0x1.27c4p-1)
//   plane_gram_fma, said hit, is miss, by 4.5e+07 ulps:
//     (-0x1.e36bcp-1, 0x1.78f5cp-4, 0x1.10fed4p-1)
//     (-0x1.e107c6p-1, 0x1.87d306p-1, -0x1.83773p-3)
//     (-0x1.e064bp-1, 0x1.e3af8ap-1, -0x1.86dd38p-2)
//     from (0x1.f9df5p-1, -0x1.fc8e2p-1, -0x1.f3868p-1)
//     along (-0x1.5da04p-2, 0x1.243bcp-5, -0x1.39af6p-1)

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/rays/methods/plane_gram.cc"
#include <hwy/foreach_target.h>

#include "kernels/rays/plane-inl.h"
#include "kernels/rays/ray_rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

template <class D, bool kFma>
class PlaneGram {
  using T = TFromD<D>;

 public:
  static constexpr Turn kTurn = Turn::kNone;

  template <class Triangle>
  HWY_INLINE PlaneGram(D d, const Triangle& t)
      : plane_(d, t),
        vx_(d, t.a.x.In(d)),
        vy_(d, t.a.y.In(d)),
        vz_(d, t.a.z.In(d)),
        ax_(d, Sub(t.b.x.In(d), vx_.In(d))),
        ay_(d, Sub(t.b.y.In(d), vy_.In(d))),
        az_(d, Sub(t.b.z.In(d), vz_.In(d))),
        bx_(d, Sub(t.c.x.In(d), vx_.In(d))),
        by_(d, Sub(t.c.y.In(d), vy_.In(d))),
        bz_(d, Sub(t.c.z.In(d), vz_.In(d))),
        aa_(d, Dot<kFma>(ax_.In(d), ay_.In(d), az_.In(d), ax_.In(d), ay_.In(d),
                         az_.In(d))),
        ab_(d, Dot<kFma>(ax_.In(d), ay_.In(d), az_.In(d), bx_.In(d), by_.In(d),
                         bz_.In(d))),
        bb_(d, Dot<kFma>(bx_.In(d), by_.In(d), bz_.In(d), bx_.In(d), by_.In(d),
                         bz_.In(d))) {
    const auto det =
        DifferenceOfProducts<kFma>(aa_.In(d), bb_.In(d), ab_.In(d), ab_.In(d));
    const auto inverse = ValidOrNaN(d, det, Div(Set(d, T{1}), det));
    aa_ = Held<D>(d, Mul(aa_.In(d), inverse));
    ab_ = Held<D>(d, Mul(ab_.In(d), inverse));
    bb_ = Held<D>(d, Mul(bb_.In(d), inverse));
  }

  template <class E, class Ray>
  HWY_INLINE Mask<E> Hit(E e, const Ray& ray, const Range<T>& range, Vec<E>& t,
                         Vec<E>& u, Vec<E>& v) const {
    const auto meets = plane_.Meet(e, ray, t);
    const auto x = Sub(
        Along<kFma>(ray.origin.x.In(e), t, ray.direction.x.In(e)), vx_.In(e));
    const auto y = Sub(
        Along<kFma>(ray.origin.y.In(e), t, ray.direction.y.In(e)), vy_.In(e));
    const auto z = Sub(
        Along<kFma>(ray.origin.z.In(e), t, ray.direction.z.In(e)), vz_.In(e));
    const auto ax = Dot<kFma>(ax_.In(e), ay_.In(e), az_.In(e), x, y, z);
    const auto bx = Dot<kFma>(bx_.In(e), by_.In(e), bz_.In(e), x, y, z);
    u = DifferenceOfProducts<kFma>(bb_.In(e), ax, ab_.In(e), bx);
    v = DifferenceOfProducts<kFma>(aa_.In(e), bx, ab_.In(e), ax);
    const auto inside = AndInTriangle(e, meets, u, v, Set(e, T{1}));
    return AndWithin(e, inside, t, range);
  }

 private:
  Plane<D, kFma> plane_;
  Held<D> vx_, vy_, vz_;
  Held<D> ax_, ay_, az_;
  Held<D> bx_, by_, bz_;
  Held<D> aa_, ab_, bb_;  // over det G
};

template <class D>
using PlaneGramPlain = PlaneGram<D, false>;
template <class D>
using PlaneGramFma = PlaneGram<D, true>;

constexpr RayMethod kPlaneGram{
    .key = "plane_gram",
    .source = "course notes on ray tracing",
    .formula = "t by the plane; (α, β) = G⁻¹·(a·x, b·x); α, β ≥ 0, α + β ≤ 1",
};
constexpr RayMethod kPlaneGramFma{
    .key = "plane_gram_fma",
    .source = kPlaneGram.source,
    .formula = kPlaneGram.formula,
    .fma = true,
};

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

PITBENCH_RAY_KERNELS(plane_gram, RayRows<PlaneGramPlain>(kPlaneGram) +
                                     RayFmaRows<PlaneGramFma>(kPlaneGramFma));
