// Ray and triangle such that none slips through an edge that two triangles
// share (Woop, Benthin & Wald 2013): space sheared until the ray goes along
// its largest axis from the origin, then the edge functions of the triangle.
//
//   |D_z| the largest, S = (D_x/D_z, D_y/D_z, 1/D_z);  for each vertex, less O:
//   x ← x − S_x·z,  y ← y − S_y·z,  z ← S_z·z
//   U = C_x·B_y − C_y·B_x,  V = A_x·C_y − A_y·C_x,  W = B_x·A_y − B_y·A_x
//   δ = U + V + W,  t = (U·A_z + V·B_z + W·C_z)/δ,  u = V/δ,  v = W/δ
//   hit iff U, V, W are all ≥ 0 or all ≤ 0, δ ≠ 0 and t in its range
//
// A vertex is sheared in the same way whichever triangle it belongs to, and
// the rounded difference of two rounded products has never the wrong sign: it
// may only be 0. Where one of U, V, W is 0 all three are computed again, f32
// in f64, where the products are exact; f64 with what its products round off
// (Dekker's, so right while no coordinate exceeds 2^995 and no product falls
// below 2^-967).
//
// Set-up: none. Per ray: 3 divisions for S, and 3 compares and 30 selections
// to find its largest axis unless all triangles have one ray; then 9 + 6
// subtractions, 21 multiplications, 7 additions, a division, 9 compares.
// Boundary: closed. Winding: any; the row `_culled` hits where U, V, W are ≥ 0
// once multiplied by the sign of D_z, which is what exchanging x and y does in
// the paper. Degenerate: missed, by the set-up. Parallel: δ = 0 makes t NaN or
// infinite where U, V and W are exact. Not finite: δ is NaN, or D_z infinite.
// Fails: in the rows `_fma`, where U, V and W are contracted: a wrong sign and
// not 0 is then what rounding leaves, and rays fall between triangles.
// Worst known f32 inputs, A B C from O along D (tests/rays/worst_rays.csv has
// f64 and the other rows):
//   watertight, said miss, is hit, by 3.5 ulps:
//     (0x1.789eep-1, -0x1.fa9438p-1, 0x1.f42b52p-1)
//     (0x1.789f36p-1, -0x1.fa6556p-1, 0x1.f42b32p-1)
//     (0x1.8p-1, 0x1.fp-1, 0x1.fp-1)
//     from (-0x1.74f868p-1, 0x1.f4552p-1, -0x1.8f90dp-2)
//     along (0x1.76cbdp-1, -0x1.f75e6cp-1, 0x1.5df9ccp-1)
//   watertight_fma, said hit, is miss, by 5.6e+07 ulps:
//     (-0x1.b45668p-1, -0x1.f534a8p-1, -0x1.ed0c8p-1)
//     (-0x1.b4566ap-1, -0x1.f534a8p-1, -0x1.ed0c8p-1)
//     (-0x1.b45668p-1, -0x1.f534a8p-1, -0x1.ed0c84p-1)
//     from (0x1.ffp-1, 0x1.ffp-1, 0x1.fff8bep-1)
//     along (-0x1p+0, -0x1p-6, 0x1p+0)
//   watertight_culled, said hit, is miss, by 3.5 ulps:
//     (-0x1.a5545p-2, 0x1.a3911p-1, 0x1.eeb12ep-1)
//     (-0x1p-1, 0x1.8p-1, 0x1.fp-1) (-0x1.a94p-2, 0x1.a15p-1, -0x1.3p-1)
//     from (0x1.6f6912p-1, -0x1.0255e6p-1, -0x1.1288fcp-1)
//     along (-0x1.21099cp-1, 0x1.52f37cp-1, 0x1.809ae2p-1)

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/rays/methods/watertight.cc"
#include <hwy/foreach_target.h>

#include "kernels/orient2d-inl.h"
#include "kernels/rays/ray_rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

// a·b − c·d with the sign of the exact value.
HWY_INLINE float SignedDifference(float a, float b, float c, float d) {
  return static_cast<float>(double{a} * b - double{c} * d);
}
HWY_INLINE double SignedDifference(double a, double b, double c, double d) {
  const Pair<double> ab = TwoProduct(a, b);
  const Pair<double> cd = TwoProduct(c, d);
  return (ab.high - cd.high) + (ab.low - cd.low);
}

// x and y of the sheared vertices, and U, V and W, as numbers.
template <class D>
struct Sheared {
  static constexpr std::size_t kLanes = kMaxLanes<D>;
  using Numbers = TFromD<D>[kLanes];
  HWY_ALIGN Numbers ax, ay, bx, by, cx, cy, u, v, w;
};

// Computes U, V and W of those lanes again in which one of them is 0.
template <class D>
static HWY_NOINLINE void ComputeZerosAgain(D d, Sheared<D>& s) {
  for (std::size_t k = 0; k < hn::Lanes(d); ++k) {
    if (s.u[k] != 0 && s.v[k] != 0 && s.w[k] != 0) continue;
    s.u[k] = SignedDifference(s.cx[k], s.by[k], s.cy[k], s.bx[k]);
    s.v[k] = SignedDifference(s.ax[k], s.cy[k], s.ay[k], s.cx[k]);
    s.w[k] = SignedDifference(s.bx[k], s.ay[k], s.by[k], s.ax[k]);
  }
}

template <class D, bool kCulled, bool kFma>
class Watertight {
  using T = TFromD<D>;

 public:
  static constexpr Turn kTurn = Turn::kDirection;

  template <class Triangle>
  HWY_INLINE Watertight(D d, const Triangle& t)
      : ax_(d, t.a.x.In(d)),
        ay_(d, t.a.y.In(d)),
        az_(d, t.a.z.In(d)),
        bx_(d, t.b.x.In(d)),
        by_(d, t.b.y.In(d)),
        bz_(d, t.b.z.In(d)),
        cx_(d, t.c.x.In(d)),
        cy_(d, t.c.y.In(d)),
        cz_(d, t.c.z.In(d)) {}

  template <class Ray>
  HWY_INLINE Mask<D> Hit(D d, const Ray& ray, const Range<T>& range, Vec<D>& t,
                         Vec<D>& u, Vec<D>& v) const {
    const auto zero = Zero(d);
    const auto one = Set(d, T{1});
    const auto dz = ray.direction.z.In(d);
    const auto shear_x = Div(ray.direction.x.In(d), dz);
    const auto shear_y = Div(ray.direction.y.In(d), dz);
    const auto shear_z = Div(one, dz);
    const auto ox = ray.origin.x.In(d);
    const auto oy = ray.origin.y.In(d);
    const auto oz = ray.origin.z.In(d);
    const auto az = Sub(az_.In(d), oz);
    const auto bz = Sub(bz_.In(d), oz);
    const auto cz = Sub(cz_.In(d), oz);
    const auto ax = Shear(Sub(ax_.In(d), ox), shear_x, az);
    const auto ay = Shear(Sub(ay_.In(d), oy), shear_y, az);
    const auto bx = Shear(Sub(bx_.In(d), ox), shear_x, bz);
    const auto by = Shear(Sub(by_.In(d), oy), shear_y, bz);
    const auto cx = Shear(Sub(cx_.In(d), ox), shear_x, cz);
    const auto cy = Shear(Sub(cy_.In(d), oy), shear_y, cz);
    auto wa = DifferenceOfProducts<kFma>(cx, by, cy, bx);
    auto wb = DifferenceOfProducts<kFma>(ax, cy, ay, cx);
    auto wc = DifferenceOfProducts<kFma>(bx, ay, by, ax);
    const auto is_zero =
        Or(Or(hn::Eq(wa, zero), hn::Eq(wb, zero)), hn::Eq(wc, zero));
    if (HWY_UNLIKELY(!hn::AllFalse(d, is_zero))) {
      Sheared<D> s;
      hn::Store(ax, d, s.ax);
      hn::Store(ay, d, s.ay);
      hn::Store(bx, d, s.bx);
      hn::Store(by, d, s.by);
      hn::Store(cx, d, s.cx);
      hn::Store(cy, d, s.cy);
      hn::Store(wa, d, s.u);
      hn::Store(wb, d, s.v);
      hn::Store(wc, d, s.w);
      ComputeZerosAgain(d, s);
      wa = hn::Load(d, s.u);
      wb = hn::Load(d, s.v);
      wc = hn::Load(d, s.w);
    }
    const auto det = Add(Add(wa, wb), wc);
    const auto inverse = Div(one, det);
    t = Mul(Dot<kFma>(wa, wb, wc, Mul(shear_z, az), Mul(shear_z, bz),
                      Mul(shear_z, cz)),
            inverse);
    u = Mul(wb, inverse);
    v = Mul(wc, inverse);
    // What is NaN shows in t, and what has overflowed in 1/δ.
    const auto inside = And(And(SameSigns(d, wa, wb, wc, dz), IsFinite(d, dz)),
                            hn::Ne(inverse, zero));
    return AndWithin(d, inside, t, range);
  }

 private:
  static HWY_INLINE Vec<D> Shear(Vec<D> x, Vec<D> by, Vec<D> z) {
    if constexpr (kFma) {
      return NegMulAdd(by, z, x);
    } else {
      return Sub(x, Mul(by, z));
    }
  }

  static HWY_INLINE Mask<D> SameSigns(D d, Vec<D> u, Vec<D> v, Vec<D> w,
                                      Vec<D> dz) {
    const auto zero = Zero(d);
    if constexpr (kCulled) {
      const auto sign = hn::And(dz, hn::SignBit(d));
      return AllNonNegative(d, hn::Xor(u, sign), hn::Xor(v, sign),
                            hn::Xor(w, sign));
    } else {
      return Or(Ge(MinOrSecond(MinOrSecond(u, v), w), zero),
                Le(MaxOrSecond(MaxOrSecond(u, v), w), zero));
    }
  }

  Held<D> ax_, ay_, az_;
  Held<D> bx_, by_, bz_;
  Held<D> cx_, cy_, cz_;
};

template <class D>
using TwoSided = Watertight<D, false, false>;
template <class D>
using TwoSidedFma = Watertight<D, false, true>;
template <class D>
using Culled = Watertight<D, true, false>;
template <class D>
using CulledFma = Watertight<D, true, true>;

constexpr RayMethod kWatertight{
    .key = "watertight",
    .source = "Woop, Benthin & Wald 2013",
    .formula = "edge functions of the sheared triangle, again in f64 where 0",
};
constexpr RayMethod kWatertightFma{
    .key = "watertight_fma",
    .source = kWatertight.source,
    .formula = kWatertight.formula,
    .fma = true,
};
constexpr RayMethod kCulled{
    .key = "watertight_culled",
    .source = kWatertight.source,
    .formula = kWatertight.formula,
    .culls_backface = true,
};
constexpr RayMethod kCulledFma{
    .key = "watertight_culled_fma",
    .source = kWatertight.source,
    .formula = kWatertight.formula,
    .fma = true,
    .culls_backface = true,
};

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

PITBENCH_RAY_KERNELS(watertight, RayRows<TwoSided>(kWatertight) +
                                     RayFmaRows<TwoSidedFma>(kWatertightFma) +
                                     RayRows<Culled>(kCulled) +
                                     RayFmaRows<CulledFma>(kCulledFma));
