// Ray and triangle, right for every finite input: a filter decides by floating-
// point arithmetic, and what it cannot decide goes to exact integer arithmetic.
//
//   S = O − A, E1 = B − A, E2 = C − A, n = E1 × E2, R = D × S
//   δ = D·n, u = E2·R/δ, v = −E1·R/δ, t = −S·n/δ, compared without dividing
//
// Set-up: the edges, the normal, and how large they are for the bounds. Per
// ray: 32 products, 18 sums with them, 11 sums, 8 maxima or minima, 5 compares,
// of which the bounds take 10 products, 10 sums and 4 maxima; no division
// unless t, u and v are asked for. The few rays that a filter in f32 leaves are
// asked again in f64; those that are then left cost three determinants in
// integers of as many bits as the exponents need, about half a microsecond.
// t, u, v: of what the filter has decided t is within 2^-32 of itself and u and
// v within 2^-32, and f32 is computed in f64, so it is then rounded once; of
// the others they are rounded from exact values. Without contraction, so that
// ISAs give the same. The nearest triangle is that of the least exact t.
// Boundary: closed (exact); or (exact_perturbed) an edge belongs to the
// triangle that a ray hits whose direction is turned by (ε, ε², ε³) with ε as
// small as need be (Edelsbrunner & Mücke 1990), so that of the triangles of a
// closed surface exactly one is hit wherever a ray crosses it, edges and
// vertices included. A ray that starts on the line of an edge does not hit that
// edge. Winding: any. Degenerate, parallel, no direction, not finite: missed,
// exactly. Fails: never. Slowest where all rays are near edges, or graze: then
// each goes to integers. The proofs are in exact/ray_filter-inl.h.
// Worst known inputs: none found.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/rays/methods/exact.cc"
#include <hwy/foreach_target.h>

#include "kernels/rays/exact/exact_nearest-inl.h"
#include "kernels/rays/ray_rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

template <class D>
using Closed = Exact<D, Boundary::kClosed>;
template <class D>
using Perturbed = Exact<D, Boundary::kPerturbed>;

template <template <class> class M, Boundary kBoundary>
constexpr auto ExactRows(std::string_view key) {
  const RayMethod method{
      .key = key,
      .source = kBoundary == Boundary::kClosed
                    ? "pitbench; filter after Shewchuk 1997"
                    : "pitbench; ties after Edelsbrunner & Mücke 1990",
      .formula =
          "u, v, t by D × (O − A) and the normal, with error bounds; "
          "exact integers for what they cannot decide",
      .boundary = kBoundary,
  };
  return RayLoopRows<M, float>(method, OneRayExactly<float, kBoundary>) +
         RayLoopRows<M, double>(method, OneRayExactly<double, kBoundary>);
}

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

PITBENCH_RAY_KERNELS(
    exact, ExactRows<Closed, Boundary::kClosed>("exact") +
               ExactRows<Perturbed, Boundary::kPerturbed>("exact_perturbed"));
