// The recipes that people call exact: each is right for hard inputs inside the
// domain that its file states, and wrong for one just outside. Truth is exact
// arithmetic.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "harness/measure/answers.h"
#include "harness/scenes/generate.h"
#include "harness/scenes/random.h"
#include "harness/truth/expected.h"
#include "harness/truth/truth.h"
#include "kernels/kernels.h"
#include "tests/kernel_answers.h"

namespace pitbench {
namespace {

#if PITBENCH_SLOW
constexpr std::size_t kInputs = 5'000;
#else
constexpr std::size_t kInputs = 120'000;
#endif

template <class T>
struct Input {
  Triangle<T> t;
  Point<T> p;
};

template <class T>
T Rounded(double x) {
  return static_cast<T>(x);
}

// A point on edge k of the triangle or next to it, in double.
template <class T>
Point<double> NearEdge(Random& random, const Triangle<T>& t,
                       std::uint64_t edge) {
  const Point<T> v[] = {t.a, t.b, t.c};
  const Point<T>& from = v[edge];
  const Point<T>& to = v[(edge + 1) % 3];
  const double way = random.Below(4) == 0 ? 0.5 : random.Unit();
  const auto between = [way](T a, T b) {
    return static_cast<double>(a) +
           way * (static_cast<double>(b) - static_cast<double>(a));
  };
  return {between(from.x, to.x), between(from.y, to.y)};
}

// Coordinates that are multiples of one number, up to 2^bits times that, where
// T holds them; the point on an edge or one multiple beside it. Every fourth
// triangle is a needle.
template <class T>
Input<T> OnGrid(Random& random, int bits) {
  const auto round = [](double x) { return Rounded<T>(std::floor(x)); };
  const double last = std::ldexp(1.0, bits);
  const auto draw = [&]() -> Point<T> {
    const T x = round(random.In(-last, last));
    return {x, round(random.In(-last, last))};
  };
  const auto beside = [&](Point<double> p) -> Point<T> {
    const auto step = [&] { return static_cast<double>(random.Below(3)) - 1; };
    const T x = round(p.x + step());
    return {x, round(p.y + step())};
  };
  Input<T> input{{draw(), draw(), draw()}, {}};
  if (random.Below(4) == 0) input.t.c = beside(NearEdge(random, input.t, 0));
  input.p = beside(NearEdge(random, input.t, random.Below(3)));
  return input;
}

// Coordinates of any sign whose exponents go from `low` to `high`; the point on
// an edge up to rounding, or a few ulps beside it.
template <class T>
Input<T> Spread(Random& random, int low, int high) {
  const auto coordinate = [&] {
    const int exponent =
        low +
        static_cast<int>(random.Below(static_cast<std::uint64_t>(high - low)));
    const double x = std::ldexp(1 + random.Unit(), exponent);
    return Rounded<T>(random.Below(2) == 0 ? x : -x);
  };
  const auto draw = [&]() -> Point<T> {
    const T x = coordinate();
    return {x, coordinate()};
  };
  Input<T> input{{draw(), draw(), draw()}, {}};
  const Point<double> on = NearEdge(random, input.t, random.Below(3));
  input.p = {Rounded<T>(on.x), Rounded<T>(on.y)};
  for (T* x : {&input.p.x, &input.p.y}) {
    // No coordinate below the range.
    if (std::abs(*x) < std::ldexp(T{1}, low)) *x = 0;
    for (std::uint64_t k = random.Below(3); k > 0 && *x != 0; --k) {
      *x = std::nextafter(*x, 2 * *x);
    }
  }
  return input;
}

// As OnGrid, all of it times 2^exponent.
template <class T>
Input<T> OnScaledGrid(Random& random, int bits, int exponent) {
  Input<T> input = OnGrid<T>(random, bits);
  for (Point<T>* p : {&input.t.a, &input.t.b, &input.t.c, &input.p}) {
    *p = {std::ldexp(p->x, exponent), std::ldexp(p->y, exponent)};
  }
  return input;
}

// The kernels of a method for pairs.
template <class T>
std::vector<const Kernel*> PairsOf(std::string_view method) {
  return KernelsWhere([method](const Kernel& kernel) {
    return kernel.method.key == method && kernel.loop == Loop::kPairs &&
           kernel.scalar == ScalarOf<T>() && kernel.output == Output::kInside;
  });
}

// No kernel of the method errs on inputs that `draw` makes.
template <class T>
void ExpectRight(std::string_view method,
                 const std::function<Input<T>(Random&)>& draw) {
  const std::vector<const Kernel*> kernels = PairsOf<T>(method);
  if (kernels.empty()) GTEST_SKIP() << "no ISA with FMA runs here";
  Random random(17);
  Scene<T> scene{.name = "", .loop = Loop::kPairs};
  std::vector<bool> expected;
  std::size_t inside = 0;
  for (std::size_t i = 0; i < kInputs; ++i) {
    const Input<T> input = draw(random);
    scene.Add(input.t);
    scene.Add(input.p);
    expected.push_back(Expected(kernels[0]->method, input.t, input.p));
    inside += expected.back() ? 1u : 0u;
  }
  EXPECT_GT(inside, kInputs / 5);
  EXPECT_LT(inside, kInputs * 4 / 5);
  scene.calls.push_back({0, 0, kInputs});
  for (const Kernel* kernel : kernels) {
    std::vector<std::uint8_t> bits(BitBytes(kInputs));
    FunctionOf<T> (*kernel)(scene.BatchOf(scene.calls[0]),
                            {.bits = bits.data()});
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < kInputs; ++i) {
      if (((bits[i / 8] >> (i % 8) & 1) != 0) == expected[i]) continue;
      if (++wrong > 3) continue;
      ADD_FAILURE() << NameOf(*kernel) << " is wrong of " << scene.PointAt(i)
                    << " in " << scene.TriangleAt(i);
    }
    EXPECT_EQ(wrong, 0u) << NameOf(*kernel);
  }
}

// Every kernel of the method, in every loop, errs on this input.
template <class T>
void ExpectWrong(std::string_view method, const Input<T>& input,
                 Position truth) {
  ASSERT_EQ(Classify(input.t, input.p), truth);
  std::size_t asked = 0;
  for (const Kernel* kernel : FloatInsideKernels()) {
    if (kernel->method.key != method || kernel->scalar != ScalarOf<T>()) {
      continue;
    }
    ++asked;
    EXPECT_NE(Says(*kernel, input.t, input.p),
              Expected(kernel->method, input.t, input.p))
        << NameOf(*kernel);
  }
  if (asked == 0) GTEST_SKIP() << "no ISA with FMA runs here";
}

TEST(ShewchukAdaptiveTest, IsRightAtAnySpreadWithinItsRange) {
  ExpectRight<float>("shewchuk_adaptive",
                     [](Random& r) { return Spread<float>(r, -50, 62); });
  ExpectRight<float>("shewchuk_adaptive",
                     [](Random& r) { return Spread<float>(r, -2, 1); });
  ExpectRight<double>("shewchuk_adaptive",
                      [](Random& r) { return Spread<double>(r, -484, 510); });
  ExpectRight<double>("shewchuk_adaptive",
                      [](Random& r) { return Spread<double>(r, -2, 1); });
}

TEST(ShewchukAdaptiveTest, IsRightOnNearlyCollinearWholeNumbers) {
  ExpectRight<float>("shewchuk_adaptive",
                     [](Random& r) { return OnGrid<float>(r, 23); });
  ExpectRight<double>("shewchuk_adaptive",
                      [](Random& r) { return OnGrid<double>(r, 53); });
  ExpectRight<double>("shewchuk_adaptive", [](Random& r) {
    return OnScaledGrid<double>(r, 52, -484);
  });
}

// What the products lose is below the smallest subnormal number.
TEST(ShewchukAdaptiveTest, IsWrongWhereTheErrorOfAProductUnderflows) {
  ExpectWrong<double>("shewchuk_adaptive",
                      {{{0x1.128ae2d569764p-500, 0x1.65033a4eee505p-500},
                        {-0x1.128ae2d569764p-500, -0x1.65033a4eee505p-500},
                        {-0x1.42e39ed1e79e6p-501, 0x1.7299fcae7202p-503}},
                       {-0x1.c2cd5d045fa82p-531, -0x1.251c0b463bc6bp-530}},
                      Position::kOutside);
  ExpectWrong<float>("shewchuk_adaptive",
                     {{{0x1.38ffp-56f, -0x1.962e34p-56f},
                       {-0x1.582fc6p-56f, 0x1.6b36d4p-56f},
                       {0x1.e3992ep-56f, 0x1.728926p-56f}},
                      {0x1.7d4f04p-56f, -0x1.7cabcap-58f}},
                     Position::kOutside);
}

TEST(ShewchukAdaptiveTest, IsWrongWhereAProductOverflows) {
  ExpectWrong<float>("shewchuk_adaptive",
                     {{{0x1.22e258p+62f, -0x1.15a7ap+62f},
                       {0x1.2d08dap+61f, 0x1.989458p+63f},
                       {0x1.f308dcp+63f, -0x1.bcd33p+63f}},
                      {0x1.33fd54p+61f, 0x1.8b0492p+63f}},
                     Position::kInside);
}

TEST(DoubleDoubleTest, IsRightWhereDifferencesAreExact) {
  ExpectRight<float>("double_double",
                     [](Random& r) { return OnGrid<float>(r, 23); });
  ExpectRight<double>("double_double",
                      [](Random& r) { return OnGrid<double>(r, 52); });
  ExpectRight<double>("double_double", [](Random& r) {
    return OnScaledGrid<double>(r, 52, -484);
  });
}

TEST(DoubleDoubleTest, IsWrongWhereTheProductHasMoreThanTwiceTheBits) {
  const Point<double> a{-0x1.eee9fd621371ap+0, -0x1.0045116be2025p-1};
  ExpectWrong<double>("double_double",
                      {{a, {-a.x, -a.y}, {-1.5, 1.25}},
                       {0x1.a1cc7b7044fafp-44, 0x1.b0ad90f7c737p-46}},
                      Position::kInside);
}

TEST(KahanTest, IsRightWhereDifferencesAreExact) {
  ExpectRight<float>("cross_product_kahan",
                     [](Random& r) { return OnGrid<float>(r, 23); });
  ExpectRight<double>("cross_product_kahan",
                      [](Random& r) { return OnGrid<double>(r, 52); });
}

TEST(KahanTest, IsWrongWhereDifferencesRound) {
  ExpectWrong<float>("cross_product_kahan",
                     {{{0x1.540e96p-1f, -0x1.bf524ep+0f},
                       {0x1.3f363p-1f, -0x1.50f986p+0f},
                       {0x1.fdfd72p+0f, 0x1.abd672p-1f}},
                      {0x1.b2b468p+0f, 0x1.0df132p-2f}},
                     Position::kOutside);
}

TEST(PromotedTest, IsRightWhereTheDeterminantIsExactInF64) {
  for (const char* method : {"promoted_f64", "promoted_f64_fma"}) {
    ExpectRight<float>(method, [](Random& r) { return OnGrid<float>(r, 25); });
  }
}

TEST(PromotedTest, IsWrongWhereTheDeterminantRoundsTo0) {
  ExpectWrong<float>(
      "promoted_f64",
      {{{-0x1p+1f, 0x1p+1f}, {0x1.8p-26f, -0x1p-26f}, {0x1.8p+1f, 0x1.8p+1f}},
       {0x1p-27f, -0x1p-54f}},
      Position::kOutside);
}

// The edge through the point is seen exactly, but for contraction.
TEST(PromotedTest, FmaIsWrongOnAnEdgeWhereTheProductsRound) {
  ExpectWrong<float>(
      "promoted_f64_fma",
      {{{0x1p+0f, 0x1p+1f}, {0x1p-19f, -0x1p-19f}, {-0x1p+1f, -0x1p+0f}},
       {0x1.3ffff8p-19f, -0x1.ffffep-21f}},
      Position::kBoundary);
}

TEST(PromotedTest, KahanIsRightWhereExponentsSpreadOver28Binades) {
  ExpectRight<float>("promoted_f64_kahan",
                     [](Random& r) { return OnGrid<float>(r, 51); });
  ExpectRight<float>("promoted_f64_kahan",
                     [](Random& r) { return Spread<float>(r, -14, 14); });
}

TEST(PromotedTest, KahanIsWrongWhereTheySpreadFurther) {
  ExpectWrong<float>(
      "promoted_f64_kahan",
      {{{-0x1p+0f, -0x1p+0f}, {0x1p-28f, -0x1p-28f}, {0x1p+1f, 0x1p+1f}},
       {-0x1p-56f, 0x1.8p-55f}},
      Position::kOutside);
}

struct Wrongs {
  std::size_t inside = 0;
  std::size_t outside = 0;
  bool operator==(const Wrongs&) const = default;
};

// What each kernel of the method gets wrong of the scene, which is the same.
Wrongs WrongsOn(const std::string& scene_name, std::string_view method) {
  const Scene<float> scene =
      MakeScene<float>(ParseScene(scene_name), Loop::kPairs,
                       {.groups = 40, .size = 67}, kDefaultSeed);
  const SceneTruth truth = JudgeScene(scene);
  std::vector<Wrongs> found;
  for (const Kernel* kernel : PairsOf<float>(method)) {
    Wrongs& wrongs = found.emplace_back();
    for (const Wrong& wrong : Ask(*kernel, scene, truth).wrong) {
      ++(wrong.said_inside ? wrongs.inside : wrongs.outside);
    }
    EXPECT_EQ(wrongs, found.front()) << NameOf(*kernel);
  }
  return found.empty() ? Wrongs{} : found.front();
}

TEST(PromotedTest, FormsDifferWhereProductsCancelAndDifferencesRound) {
  if (PairsOf<float>("promoted_f64_fma").empty()) {
    GTEST_SKIP() << "no ISA with FMA runs here";
  }
  const std::vector<std::string_view> methods = {
      "promoted_f64", "promoted_f64_fma", "promoted_f64_kahan"};
  for (const std::string_view method : methods) {
    EXPECT_EQ(WrongsOn("cancellation:binades=28", method), Wrongs{}) << method;
  }
  std::vector<Wrongs> beyond;
  for (const std::string_view method : methods) {
    beyond.push_back(WrongsOn("cancellation:binades=30", method));
    EXPECT_GT(beyond.back().inside, 0u) << method;
  }
  EXPECT_NE(beyond[0], beyond[1]);
  EXPECT_NE(beyond[0], beyond[2]);
  EXPECT_NE(beyond[1], beyond[2]);
}

TEST(EpsilonTest, IsRightOnWholeNumbers) {
  ExpectRight<float>("epsilon", [](Random& r) { return OnGrid<float>(r, 10); });
  ExpectRight<double>("epsilon",
                      [](Random& r) { return OnGrid<double>(r, 25); });
}

// In f32 a triangle of a thousandth contains points of another; in f64 so does
// one of 1/65536.
TEST(EpsilonTest, IsWrongWhereTheTriangleIsSmall) {
  ExpectWrong<float>(
      "epsilon", {{{0, 0}, {0x1p-10f, 0}, {0, 0x1p-10f}}, {0x1p-10f, 0x1p-12f}},
      Position::kOutside);
  ExpectWrong<double>(
      "epsilon", {{{0, 0}, {0x1p-16, 0}, {0, 0x1p-16}}, {0x1p-16, 0x1p-16}},
      Position::kOutside);
}

// The tolerance does not grow with the coordinates, rounding does.
TEST(EpsilonTest, IsWrongWhereTheCoordinatesAreLarge) {
  const float big = 0x1p+12f;
  ExpectWrong<float>("epsilon",
                     {{{0x1.ap+2f * big, 0x1.ccccccp+2f * big},
                       {0x1.acccccp+2f * big, 0x1.ccccccp+0f * big},
                       {0x1.d9999ap+1f * big, 0x1.8p+2f * big}},
                      {0x1.a28f5cp+2f * big, 0x1.87ae14p+2f * big}},
                     Position::kOutside);
}

}  // namespace
}  // namespace pitbench
