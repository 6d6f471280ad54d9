// Point in triangle by barycentric weights from the inverse of a 3×3 matrix
// (qTriangle).
//
//   (w_a, w_b, w_c) = [A B C; 1 1 1]⁻¹ · (x, y, 1),   inside iff every w ≥ 0
//
// Set-up: a matrix inverse by Eigen (cofactors over the determinant), triangle
// by triangle also where a vector of them is asked for (with FMA the same
// cofactors, written out for all lanes at once); the contract's check for a
// degenerate triangle, whose determinant may round to more than 0. Per point: 6
// multiplications, 6 additions, 3 compares: the third column is times 1; with
// FMA 3 multiplications, 3 multiply-adds, 3 additions.
// Boundary: closed. Winding: any. Degenerate: contains nothing.
// Fails: the determinant is formed from the coordinates themselves, not from
// their differences, so it loses everything far from the origin: f32
// (4096, 4096) (4096.5, 4096) (4096, 4096.5) has determinant 0.
// Worst known f32 inputs, A B C p (tests/worst_inputs.csv has f64 as well):
//   barycentric_inverse, said inside, is 3.36e+07 ulps outside:
//     (0x1.f6102ap-1, -0x1.af5416p-2) (0x1.f61014p-1, -0x1.af541ep-2)
//     (0x1.f6100ap-1, -0x1.af5422p-2) (-0x1.f8p-1, -0x1.9cp-1)
//   barycentric_inverse_fma, said inside, is 3.39e+07 ulps outside:
//     (-0x1.e9449ep-1, 0x1.c417d2p-1) (-0x1.e94496p-1, 0x1.c417dp-1)
//     (-0x1.e9449cp-1, 0x1.c417d2p-1) (0x1.ffcp-1, 0x1.8p-2)

#include <Eigen/Core>
#include <Eigen/LU>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/methods/barycentric_inverse.cc"
#include <hwy/foreach_target.h>

#include "kernels/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

template <class D, bool kFma>
class BarycentricInverse {
  using T = TFromD<D>;
  // Nine coefficients, each a vector of lanes; row-major in the inverse.
  struct Inverse {
    HWY_ALIGN T at[9][kMaxLanes<D>];
  };

 public:
  HWY_INLINE BarycentricInverse(D d, const Triangles<D>& t)
      : BarycentricInverse(d, kFma ? InvertByFma(d, t) : Invert(d, t),
                           DoubleArea(t)) {}

  template <class E>
  HWY_INLINE Mask<E> Inside(E e, Vec<E> x, Vec<E> y) const {
    auto wa = x;
    auto wb = x;
    auto wc = x;
    Weights(e, x, y, wa, wb, wc);
    return AllNonNegative(e, wa, wb, wc);
  }

  template <class E>
  HWY_INLINE void Weights(E e, Vec<E> x, Vec<E> y, Vec<E>& wa, Vec<E>& wb,
                          Vec<E>& wc) const {
    wa = Add(SumOfProducts<kFma>(ax_.In(e), x, ay_.In(e), y), a1_.In(e));
    wb = Add(SumOfProducts<kFma>(bx_.In(e), x, by_.In(e), y), b1_.In(e));
    wc = Add(SumOfProducts<kFma>(cx_.In(e), x, cy_.In(e), y), c1_.In(e));
  }

 private:
  HWY_INLINE BarycentricInverse(D d, const Inverse& inverse, Vec<D> area)
      : ax_(d, hn::Load(d, inverse.at[0])),
        ay_(d, hn::Load(d, inverse.at[1])),
        a1_(d, ValidOrNaN(d, area, hn::Load(d, inverse.at[2]))),
        bx_(d, hn::Load(d, inverse.at[3])),
        by_(d, hn::Load(d, inverse.at[4])),
        b1_(d, ValidOrNaN(d, area, hn::Load(d, inverse.at[5]))),
        cx_(d, hn::Load(d, inverse.at[6])),
        cy_(d, hn::Load(d, inverse.at[7])),
        c1_(d, ValidOrNaN(d, area, hn::Load(d, inverse.at[8]))) {}

  static HWY_INLINE Inverse Invert(D d, const Triangles<D>& t) {
    Inverse inverse;
    for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane) {
      using std::abs;
      Eigen::Matrix<Number<T>, 3, 3, Eigen::RowMajor> m;
      const T entries[9] = {t.ax[lane], t.bx[lane], t.cx[lane],
                            t.ay[lane], t.by[lane], t.cy[lane],
                            T{1},       T{1},       T{1}};
      for (int k = 0; k < 9; ++k) m.data()[k] = entries[k];
      Eigen::Matrix<Number<T>, 3, 3, Eigen::RowMajor> inverted;
      Number<T> determinant;
      bool invertible;
      m.computeInverseAndDetWithCheck(inverted, determinant, invertible, T{0});
      invertible =
          invertible && abs(determinant) < std::numeric_limits<T>::infinity();
      for (int k = 0; k < 9; ++k) {
        inverse.at[k][lane] = invertible ? static_cast<T>(inverted.data()[k])
                                         : std::numeric_limits<T>::quiet_NaN();
      }
    }
    return inverse;
  }

  // What Eigen computes, contracted as a compiler would.
  static HWY_INLINE Inverse InvertByFma(D d, const Triangles<D>& t) {
    const auto ax = t.Ax();
    const auto ay = t.Ay();
    const auto bx = t.Bx();
    const auto by = t.By();
    const auto cx = t.Cx();
    const auto cy = t.Cy();
    const auto a1 = MulSub(bx, cy, Mul(cx, by));
    const auto determinant =
        MulAdd(Sub(by, cy), ax, MulAdd(Sub(cx, bx), ay, a1));
    const auto scale =
        ValidOrNaN(d, determinant, Div(Set(d, T{1}), determinant));
    Inverse inverse;
    hn::Store(Mul(Sub(by, cy), scale), d, inverse.at[0]);
    hn::Store(Mul(Sub(cx, bx), scale), d, inverse.at[1]);
    hn::Store(Mul(a1, scale), d, inverse.at[2]);
    hn::Store(Mul(Sub(cy, ay), scale), d, inverse.at[3]);
    hn::Store(Mul(Sub(ax, cx), scale), d, inverse.at[4]);
    hn::Store(Mul(MulSub(cx, ay, Mul(ax, cy)), scale), d, inverse.at[5]);
    hn::Store(Mul(Sub(ay, by), scale), d, inverse.at[6]);
    hn::Store(Mul(Sub(bx, ax), scale), d, inverse.at[7]);
    hn::Store(Mul(MulSub(ax, by, Mul(bx, ay)), scale), d, inverse.at[8]);
    return inverse;
  }

  Held<D> ax_, ay_, a1_;
  Held<D> bx_, by_, b1_;
  Held<D> cx_, cy_, c1_;
};

template <class D>
using BarycentricInversePlain = BarycentricInverse<D, false>;
template <class D>
using BarycentricInverseFma = BarycentricInverse<D, true>;

constexpr Method kBarycentricInverse{
    .key = "barycentric_inverse",
    .source = "qTriangle, 2018 and 2019 texts",
    .formula = "[A B C; 1 1 1]⁻¹ · (x, y, 1) ≥ 0",
};
constexpr Method kBarycentricInverseFma{
    .key = "barycentric_inverse_fma",
    .source = kBarycentricInverse.source,
    .formula = kBarycentricInverse.formula,
    .fma = true,
};

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

PITBENCH_KERNELS(barycentric_inverse,
                 FloatRows<BarycentricInversePlain>(kBarycentricInverse) +
                     FmaRows<BarycentricInverseFma>(kBarycentricInverseFma));
