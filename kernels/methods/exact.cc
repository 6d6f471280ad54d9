// Point in triangle, right for every finite input: a float filter decides, and
// what it cannot decide goes to exact integer arithmetic.
//
//   y above the lines of the lower edges by more than t, and below those of the
//   upper ones: inside; beyond one of them by more than t: outside;
//   between, the signs of three determinants, exactly
//
// Set-up: three lines and the bound t. Per point: 3 MulAdd, 2 subtractions, 2
// Max or Min, and what tells whether all of a thousand points or two are
// decided: the least of them; on AVX-512 a permutation and a compare for two
// vectors, before it a multiply-add. (Arm: 5 MulAdd, 2 Max or Min, And,
// compare.)
// The few in 10^6 uniform f32 points that are not decided (2 or 3 of most
// triangles, 13 of a steep one) cost 3 determinants in double precision, and,
// where these cannot tell either, in integers of as many bits as the exponents
// need; those around them are looked at again. Where a line would be too steep
// for a small t, lines over y or edge functions take the place of lines over x.
// Boundary: closed (exact), open (exact_open) or top-left (exact_top_left):
// with that every point of a mesh is in exactly one triangle. Winding: any.
// Degenerate: contains nothing. Fails: never. Slowest where all points are
// near edges, or where a triangle is so thin or so far from the origin that no
// bound known for a triangle says anything: then each determinant has its own.
// The proofs are in loops/filters-inl.h.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/methods/exact.cc"
#include <hwy/foreach_target.h>

#include "kernels/loops/filtered-inl.h"
#include "kernels/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

template <class T, Boundary kBoundary>
static void ExactOneTriangle(const Batch<T>& batch, const Result<T>& result) {
  FilteredOneTriangle<T, PointsInTwoArrays>(batch, result, kBoundary);
}
template <class T, Boundary kBoundary>
static void ExactOnePoint(const Batch<T>& batch, const Result<T>& result) {
  FilteredManyTriangles<T, true>(batch, result, kBoundary);
}
template <class T, Boundary kBoundary>
static void ExactPairs(const Batch<T>& batch, const Result<T>& result) {
  FilteredManyTriangles<T, false>(batch, result, kBoundary);
}

template <class T, Boundary kBoundary>
constexpr Rows<3> ExactLoopRows(const Method& method) {
  return {MakeKernel<T>(method, Loop::kOneTriangle, Output::kInside,
                        ExactOneTriangle<T, kBoundary>),
          MakeKernel<T>(method, Loop::kOnePoint, Output::kInside,
                        ExactOnePoint<T, kBoundary>),
          MakeKernel<T>(method, Loop::kPairs, Output::kInside,
                        ExactPairs<T, kBoundary>)};
}

#if defined(PITBENCH_COUNTING)
// The arithmetic is that of loop one_triangle: it is counted there.
template <Boundary kBoundary>
constexpr Rows<0> ExactAosRows(const Method&) {
  return {};
}
#else
template <class T, Boundary kBoundary>
static void ExactOneTriangleAos(const Batch<T>& batch,
                                const Result<T>& result) {
  FilteredOneTriangle<T, PointsSideBySide>(batch, result, kBoundary);
}
template <Boundary kBoundary>
constexpr Rows<2> ExactAosRows(const Method& method) {
  return {MakeKernel<float>(method, Loop::kOneTriangleAos, Output::kInside,
                            ExactOneTriangleAos<float, kBoundary>),
          MakeKernel<double>(method, Loop::kOneTriangleAos, Output::kInside,
                             ExactOneTriangleAos<double, kBoundary>)};
}
#endif

template <Boundary kBoundary>
constexpr auto ExactRows(std::string_view key) {
  const Method method{
      .key = key,
      .source = "pitbench; filters after Shewchuk 1997",
      .formula =
          "edges as lines with an error bound; exact integers for what "
          "they cannot decide",
      .boundary = kBoundary,
  };
  return ExactLoopRows<float, kBoundary>(method) +
         ExactLoopRows<double, kBoundary>(method) +
         ExactAosRows<kBoundary>(method);
}

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

PITBENCH_KERNELS(exact, ExactRows<Boundary::kClosed>("exact") +
                            ExactRows<Boundary::kOpen>("exact_open") +
                            ExactRows<Boundary::kTopLeft>("exact_top_left"));
