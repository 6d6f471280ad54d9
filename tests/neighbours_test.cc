// Two triangles that share an edge, and points near it: which methods leave
// holes, which own every point once, and what contraction does to them.
#include <gtest/gtest.h>

#include <cmath>
#include <string_view>
#include <vector>

#include "harness/scenes/random.h"
#include "harness/truth/orientation.h"
#include "kernels/kernels.h"
#include "tests/kernel_answers.h"

namespace pitbench {
namespace {

#if PITBENCH_SLOW
constexpr int kPairs = 3'000;
#else
constexpr int kPairs = 30'000;
#endif

// How many points of the inner part of a shared edge, rounded or a few ulps
// beside it, neither or both triangles claim.
struct Claims {
  std::size_t none = 0;
  std::size_t both = 0;
};

template <class T>
Claims AskNeighbours(const Kernel& kernel) {
  Random random(23);
  const auto draw = [&]() -> Point<T> {
    const auto x = static_cast<T>(random.In(1, 10));
    return {x, static_cast<T>(random.In(1, 10))};
  };
  Scene<T> scene{.name = "", .loop = Loop::kPairs};
  for (int k = 0; k < kPairs; ++k) {
    const Point<T> a = draw();
    const Point<T> b = draw();
    const auto way = static_cast<T>(random.In(0.3, 0.7));
    Point<T> p{a.x + way * (b.x - a.x), a.y + way * (b.y - a.y)};
    for (std::uint64_t n = random.Below(3); n > 0; --n) {
      p.x = std::nextafter(p.x, T{random.Below(2) == 0 ? -100.f : 100.f});
    }
    // One to each side, as far off as the edge is long, and in any order.
    const Point<T> left{p.x - (b.y - a.y), p.y + (b.x - a.x)};
    const Point<T> right{p.x + (b.y - a.y), p.y - (b.x - a.x)};
    const bool turn = random.Below(2) == 0;
    scene.Add(turn ? Triangle<T>{a, b, left} : Triangle<T>{left, a, b});
    scene.Add(p);
    scene.Add(turn ? Triangle<T>{right, a, b} : Triangle<T>{b, a, right});
    scene.Add(p);
  }
  const std::size_t n = scene.px.size();
  scene.calls.push_back({0, 0, n});
  std::vector<std::uint8_t> bits(BitBytes(n));
  FunctionOf<T>(kernel)(scene.BatchOf(scene.calls[0]), {.bits = bits.data()});
  Claims claims;
  for (std::size_t i = 0; i < n; i += 2) {
    const unsigned said = bits[i / 8] >> (i % 8) & 3u;
    claims.none += said == 0 ? 1u : 0u;
    claims.both += said == 3 ? 1u : 0u;
  }
  return claims;
}

// Calls test(claims) for every kernel for pairs of the method.
template <class Test>
void ForClaims(std::string_view method, const Test& test) {
  for (const Kernel& kernel : AllKernels()) {
    if (!RunsHere(kernel.isa) || kernel.method.key != method ||
        kernel.loop != Loop::kPairs || kernel.output != Output::kInside) {
      continue;
    }
    SCOPED_TRACE(NameOf(kernel));
    WithFloatOf(kernel, [&]<class T>(T) { test(AskNeighbours<T>(kernel)); });
  }
}

TEST(NeighboursTest, MethodsThatLookFromThePointLeaveNoHole) {
  for (const char* method :
       {"cross_product_centered", "cross_product_kahan", "cross_solve",
        "promoted_f64", "promoted_f64_kahan", "shewchuk_adaptive",
        "ozaki_adaptive"}) {
    ForClaims(method, [](const Claims& claims) { EXPECT_EQ(claims.none, 0u); });
  }
}

TEST(NeighboursTest, TopLeftFromThePointOwnsEveryPointOnce) {
  ForClaims("cross_product_centered_top_left", [](const Claims& claims) {
    EXPECT_EQ(claims.none, 0u);
    EXPECT_EQ(claims.both, 0u);
  });
}

TEST(NeighboursTest, TopLeftEdgeFunctionsDoNot) {
  ForClaims("edge_function_top_left", [](const Claims& claims) {
    EXPECT_GT(claims.none, 0u);
    EXPECT_GT(claims.both, 0u);
  });
}

TEST(NeighboursTest, ContractionMakesHoles) {
  for (const char* method :
       {"cross_product_centered_fma", "cross_solve_fma",
        "cross_product_det_fma", "barycentric_inverse_fma",
        "barycentric_determinant_closed_fma", "uv_projection_fma"}) {
    ForClaims(method, [](const Claims& claims) {
      EXPECT_GT(claims.none, static_cast<std::size_t>(kPairs) / 1000);
    });
  }
}

// The source is that of cross_product_det, which on its own vertex is 0.
TEST(NeighboursTest, FastMathContractsWhatIsWrittenWithoutFma) {
  Random random(29);
  std::size_t lost = 0;
  for (int k = 0; k < 300; ++k) {
    const auto draw = [&] { return static_cast<float>(random.In(-1, 1)); };
    const Point<float> b{draw(), draw()};
    const Triangle<float> t{{0, 0}, b, {draw(), draw()}};
    if (Orientation(t.a, t.b, t.c) == 0) continue;
    for (const Kernel& kernel : AllKernels()) {
      if (!RunsHere(kernel.isa) || kernel.scalar != Scalar::kF32 ||
          kernel.loop != Loop::kPairs || kernel.output != Output::kInside) {
        continue;
      }
      if (kernel.method.key == "cross_product_det") {
        EXPECT_TRUE(Says(kernel, t, b)) << b << " in " << t;
      } else if (kernel.method.key == "cross_product_fast_math") {
        EXPECT_FALSE(kernel.method.warning.empty());
        lost += Says(kernel, t, b) ? 0u : 1u;
      }
    }
  }
#if !defined(__SANITIZE_ADDRESS__)  // what is checked is not contracted
  if (RunsHere(Isa::kAutovecV3)) {
    EXPECT_GT(lost, 50u);
  }
#endif
}

}  // namespace
}  // namespace pitbench
