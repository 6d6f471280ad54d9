// The determinants that kernels are made of, on the first figure of Kettner,
// Mehlhorn, Pion, Schirra, Yap, "Classroom examples of robustness problems in
// geometric computations" (2008): p steps by ulps around (0.5, 0.5), nearly on
// the line through q and r. The counts were made apart from this code.
//
// No kernel gives such a determinant away, and p is on the line but between no
// two vertices; so this is compiled as a kernel is, for each ISA.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/kettner_test.cc"
#include <hwy/foreach_target.h>

#include "kernels/triangle-inl.h"

#ifndef PITBENCH_TESTS_KETTNER_TEST_ONCE_
#define PITBENCH_TESTS_KETTNER_TEST_ONCE_

#include <gtest/gtest.h>

#include <vector>

#include "harness/truth/orientation.h"

namespace pitbench {

using Determinant = double (*)(const Point<double>& p, const Point<double>& q,
                               const Point<double>& r);

// One ISA's: the difference is seen from p, from q and from r.
struct Determinants {
  Isa isa;
  bool fma;
  Determinant pivot_p, pivot_q, pivot_r;
};

inline std::vector<Determinants>& EveryDeterminant() {
  static std::vector<Determinants> all;
  return all;
}
inline bool Register(const Determinants& determinants) {
  EveryDeterminant().push_back(determinants);
  return true;
}

}  // namespace pitbench

#endif  // once

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

using D = OneLane<double>;

// As of the edge qr in cross_product_centered.
template <bool kFma>
double PivotP(const Point<double>& p, const Point<double>& q,
              const Point<double>& r) {
  const D d;
  const auto held = [d](double x) HWY_ATTR { return Held<D>(d, Set(d, x)); };
  const Vertices<D> vertices{held(q.x), held(q.y), held(r.x),
                             held(r.y), held(0),   held(0)};
  auto on_bc = Zero(d);
  auto on_ca = Zero(d);
  auto on_ab = Zero(d);
  CrossFromPoint<kFma>(vertices, d, Set(d, p.x), Set(d, p.y), on_bc, on_ca,
                       on_ab);
  return hn::GetLane(on_ab);
}

// As of the edge vw in cross_product_det.
template <bool kFma>
double SeenFrom(const Point<double>& v, const Point<double>& w,
                const Point<double>& p) {
  const D d;
  const Edge<D> edge(d, Set(d, v.x), Set(d, v.y), Set(d, w.x), Set(d, w.y),
                     Set(d, 1.0));
  return hn::GetLane(EdgeCross<kFma>(edge, d, Set(d, p.x), Set(d, p.y)));
}
template <bool kFma>
double PivotQ(const Point<double>& p, const Point<double>& q,
              const Point<double>& r) {
  return SeenFrom<kFma>(q, r, p);
}
template <bool kFma>
double PivotR(const Point<double>& p, const Point<double>& q,
              const Point<double>& r) {
  return -SeenFrom<kFma>(r, q, p);
}

[[maybe_unused]] const bool kPlain =
    Register({kIsa, false, PivotP<false>, PivotQ<false>, PivotR<false>});
#if HWY_NATIVE_FMA
[[maybe_unused]] const bool kContracted =
    Register({kIsa, true, PivotP<true>, PivotQ<true>, PivotR<true>});
#endif

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pitbench {
namespace {

// Determinants whose sign is not the exact one: opposite to it, 0, or any where
// that is 0.
struct Mistakes {
  int flips = 0;
  int false_zeros = 0;
  int false_sides = 0;
  bool operator==(const Mistakes&) const = default;
};

std::ostream& operator<<(std::ostream& out, const Mistakes& mistakes) {
  return out << mistakes.flips << " flips, " << mistakes.false_zeros
             << " false zeros, " << mistakes.false_sides << " false sides";
}

Mistakes Count(Determinant determinant) {
  const Point<double> q = {12, 12};
  const Point<double> r = {24, 24};
  Mistakes mistakes;
  for (int i = 0; i < 256; ++i) {
    for (int j = 0; j < 256; ++j) {
      const Point<double> p = {0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53};
      const double value = determinant(p, q, r);
      const int sign = (value > 0) - (value < 0);
      const int exact = OrientationExactly(p, q, r);
      if (sign == exact) continue;
      ++(sign == 0    ? mistakes.false_zeros
         : exact == 0 ? mistakes.false_sides
                      : mistakes.flips);
    }
  }
  return mistakes;
}

TEST(KettnerTest, EveryDeterminantMakesItsKnownMistakes) {
  int asked = 0;
  for (const Determinants& one : EveryDeterminant()) {
    if (!RunsHere(one.isa) || one.fma) continue;
    ++asked;
    SCOPED_TRACE(Name(one.isa));
    EXPECT_EQ(Count(one.pivot_p), (Mistakes{672, 11300, 0}));
    EXPECT_EQ(Count(one.pivot_q), (Mistakes{0, 5752, 0}));
    EXPECT_EQ(Count(one.pivot_r), (Mistakes{0, 11492, 0}));
  }
  EXPECT_GT(asked, 0);
}

// As often as 4592 times it says the other side, and of points on the line
// mostly that they are beside it.
TEST(KettnerTest, ContractedItHasAllKindsOfMistakes) {
  int asked = 0;
  for (const Determinants& one : EveryDeterminant()) {
    if (!RunsHere(one.isa) || !one.fma) continue;
    ++asked;
    const Mistakes mistakes = Count(one.pivot_p);
    EXPECT_EQ(mistakes.flips, 4592) << Name(one.isa);
    EXPECT_EQ(mistakes.false_zeros, 72) << Name(one.isa);
    EXPECT_GT(mistakes.false_sides, 128) << Name(one.isa);
  }
  if (asked == 0) GTEST_SKIP() << "no ISA with FMA runs here";
}

}  // namespace
}  // namespace pitbench
#endif  // HWY_ONCE
