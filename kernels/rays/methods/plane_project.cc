// Ray and triangle by the plane and a test in 2D (Badouel 1990): where the ray
// meets the plane, seen along the axis in which the normal is largest.
//
//   N = (B − A) × (C − A),  t = (A·N − O·N) / (D·N);  |N_z| the largest:
//   q = O + t·D − A in x and y,  u = q × (C − A) / N_z,  v = (B − A) × q / N_z
//   hit iff u ≥ 0, v ≥ 0, u + v ≤ 1 and t in its range
//
// Set-up: the normal, which axis is dropped, the edges over N_z, with one
// division. Per ray: 12 multiplications, 12 additions and subtractions, a
// division, 5 compares.
// Boundary: closed. Winding: any. Degenerate: missed. Parallel: D·N = 0 makes t
// infinite or NaN. Not finite: t is NaN or infinite, or D·N is.
// The axis is found without multiply-adds in the row `_fma` as well.
// Fails: |A·N| and |O·N| grow with the distance from the origin of coordinates
// and with them the error of t, and |O + t·D| with the distance of the ray's
// start and with it the error of q.
// Worst known f32 inputs, A B C from O along D (tests/rays/worst_rays.csv has
// f64 and the other rows):
//   plane_project, said hit, is miss, by 1.9e+06 ulps:
//     (-0x1.b2d4ecp-3, 0x1.cp-1, -0x1.71cdp-1)
//     (0x1.5556b6p-2, 0x1.ce1e6ap-1, 0x1.d6cb98p-1)
//     (0x1.5556ccp-2, 0x1.ce1e58p-1, 0x1.d6cb8p-1)
//     from (-0x1.b2d4fp-3, 0x1.78p-10, -0x1.71cdp-1)
//     along (0x1.1760ap-2, 0x1.8c8p-2, 0x1.a44c42p-1)
//   plane_project_fma, said hit, is miss, by 8.1e+05 ulps:
//     (-0x1.fb1048p-2, -0x1.ep-1, -0x1.6d28ep-1)
//     (0x1.a3ec7cp-1, -0x1.d3ad78p-1, 0x1.732b34p-1)
//     (0x1.a3ec8p-1, -0x1.d3ad8p-1, 0x1.732aa8p-1)
//     from (-0x1.fb102p-2, 0x1.913p-4, -0x1.6d2ap-1)
//     along (0x1.50baap-1, -0x1.ea3b4p-2, 0x1.702abp-1)

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/rays/methods/plane_project.cc"
#include <hwy/foreach_target.h>

#include "kernels/rays/plane-inl.h"
#include "kernels/rays/ray_rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

template <class D, bool kFma>
class PlaneProject {
  using T = TFromD<D>;

 public:
  static constexpr Turn kTurn = Turn::kNormal;

  template <class Triangle>
  HWY_INLINE PlaneProject(D d, const Triangle& t)
      : plane_(d, t),
        ax_(d, t.a.x.In(d)),
        ay_(d, t.a.y.In(d)),
        inverse_(d, Div(Set(d, T{1}), plane_.NormalZ(d))),
        bx_(d, Mul(Sub(t.b.x.In(d), ax_.In(d)), inverse_.In(d))),
        by_(d, Mul(Sub(t.b.y.In(d), ay_.In(d)), inverse_.In(d))),
        cx_(d, Mul(Sub(t.c.x.In(d), ax_.In(d)), inverse_.In(d))),
        cy_(d, Mul(Sub(t.c.y.In(d), ay_.In(d)), inverse_.In(d))) {}

  template <class E, class Ray>
  HWY_INLINE Mask<E> Hit(E e, const Ray& ray, const Range<T>& range, Vec<E>& t,
                         Vec<E>& u, Vec<E>& v) const {
    const auto meets = plane_.Meet(e, ray, t);
    const auto x = Sub(
        Along<kFma>(ray.origin.x.In(e), t, ray.direction.x.In(e)), ax_.In(e));
    const auto y = Sub(
        Along<kFma>(ray.origin.y.In(e), t, ray.direction.y.In(e)), ay_.In(e));
    u = DifferenceOfProducts<kFma>(x, cy_.In(e), y, cx_.In(e));
    v = DifferenceOfProducts<kFma>(bx_.In(e), y, by_.In(e), x);
    const auto inside = AndInTriangle(e, meets, u, v, Set(e, T{1}));
    return AndWithin(e, inside, t, range);
  }

 private:
  Plane<D, kFma> plane_;
  Held<D> ax_, ay_;
  Held<D> inverse_;
  Held<D> bx_, by_, cx_, cy_;  // B − A and C − A over N_z
};

template <class D>
using PlaneProjectPlain = PlaneProject<D, false>;
template <class D>
using PlaneProjectFma = PlaneProject<D, true>;

constexpr RayMethod kPlaneProject{
    .key = "plane_project",
    .source = "Badouel 1990",
    .formula = "t by the plane; u = q×(C−A)/N_z, v = (B−A)×q/N_z in 2D",
};
constexpr RayMethod kPlaneProjectFma{
    .key = "plane_project_fma",
    .source = kPlaneProject.source,
    .formula = kPlaneProject.formula,
    .fma = true,
};

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

PITBENCH_RAY_KERNELS(plane_project,
                     RayRows<PlaneProjectPlain>(kPlaneProject) +
                         RayFmaRows<PlaneProjectFma>(kPlaneProjectFma));
