// Point in triangle by three cross products with a fixed tolerance, the common
// advice against rounding.
//
//   ex·(y − vy) − ey·(x − vx) ≥ −ε for each edge e from its vertex v
//
// ε = 1e-9 in f64, as in the geometry of S. and F. Halim's "Competitive
// Programming" (collinear: |cross| < EPS, EPS 1e-9), and 1e-6 in f32, the
// EPSILON to which Möller and Trumbore (1997) hold their determinant.
// Set-up: 3 edges. Per point: 9 subtractions, 6 multiplications, 3 compares.
// Boundary: closed, and more. Winding: fixed by the set-up. Degenerate:
// contains nothing.
// Right where every cross product is exact and a multiple of a power of two
// above ε: whole coordinates up to 10 bits in f32, 25 in f64.
// Fails: ε is an area, compared with one: a triangle whose size squared is
// below ε contains all points near it, and where the products are so large that
// their rounding exceeds ε it changes nothing.
// Worst known f32 inputs, A B C p (tests/worst_inputs.csv has f64 as well):
//   epsilon, said inside, is 4.7e+07 ulps outside:
//     (0x1.f0898p-1, -0x1.fd882p-1) (0x1.f089ap-1, -0x1.fd884p-1)
//     (0x1.f089ap-1, -0x1.fd8848p-1) (-0x1.fffp-1, 0x1.ffffp-1)
//   epsilon_fma, said inside, is 4.7e+07 ulps outside:
//     (0x1.f0898p-1, -0x1.fd882p-1) (0x1.f089ap-1, -0x1.fd884p-1)
//     (0x1.f089ap-1, -0x1.fd8848p-1) (-0x1.fffp-1, 0x1.ffffp-1)

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/methods/epsilon.cc"
#include <hwy/foreach_target.h>

#include "kernels/rows-inl.h"
#include "kernels/triangle-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

template <class T>
inline constexpr T kEpsilon = std::is_same_v<T, float> ? T(1e-6) : T(1e-9);

template <class D, bool kFma>
class Epsilon {
 public:
  HWY_INLINE Epsilon(D d, const Triangles<D>& t) : edges_(d, t) {}

  template <class E>
  HWY_INLINE Mask<E> Inside(E e, Vec<E> x, Vec<E> y) const {
    const auto least = Set(e, -kEpsilon<TFromD<E>>);
    return AllAtLeast(EdgeCross<kFma>(edges_.ab, e, x, y), least,
                      EdgeCross<kFma>(edges_.bc, e, x, y), least,
                      EdgeCross<kFma>(edges_.ca, e, x, y), least);
  }

 private:
  Edges<D> edges_;
};

template <class D>
using EpsilonPlain = Epsilon<D, false>;
template <class D>
using EpsilonFma = Epsilon<D, true>;

template <class T>
constexpr Method kEpsilonMethod{
    .key = "epsilon",
    .source = "common advice; Halim and Halim, Möller and Trumbore 1997",
    .formula =
        "ex·(y − vy) − ey·(x − vx) ≥ −ε for each edge e from its vertex "
        "v",
    .tolerance = kEpsilon<T>,
};

template <class T>
constexpr Method kEpsilonFmaMethod{
    .key = "epsilon_fma",
    .source = kEpsilonMethod<T>.source,
    .formula = kEpsilonMethod<T>.formula,
    .fma = true,
    .tolerance = kEpsilon<T>,
};

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

PITBENCH_KERNELS(
    epsilon,
    (LoopRows<EpsilonPlain, float, Output::kInside>(kEpsilonMethod<float>) +
     LoopRows<EpsilonPlain, double, Output::kInside>(kEpsilonMethod<double>) +
     FmaOnly<EpsilonFma>(kEpsilonFmaMethod<float>, kEpsilonFmaMethod<double>)));
