// The recipes that people call exact: each is right for hard inputs inside the
// domain that its file states, and wrong for one just outside, which
// report/recipes.csv has. Truth is exact arithmetic.
#include <gtest/gtest.h>

#include <array>
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
#include "tests/worst_rows.h"

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

// What a line of report/recipes.csv has after method and scalar.
enum Field : std::size_t { kRightWhere = 2, kOutside, kFirstCoordinate };
constexpr std::size_t kTruth = kFirstCoordinate + 8;

Rows ReadRecipes() {
  return ReadWorstRows(PITBENCH_TESTS_DIR "/../report/recipes.csv",
                       "method,scalar,right_where,outside,ax,ay,bx,by,cx,cy,px,"
                       "py,truth");
}

// Every kernel of the method, in every loop, errs on the row's input.
template <class T>
void ExpectWrong(const Row& row) {
  std::array<T, 8> x{};
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double value = std::stod(row[kFirstCoordinate + k]);
    x[k] = static_cast<T>(value);
    EXPECT_EQ(static_cast<double>(x[k]), value);
  }
  const Triangle<T> t{{x[0], x[1]}, {x[2], x[3]}, {x[4], x[5]}};
  const Point<T> p{x[6], x[7]};
  EXPECT_EQ(Name(Classify(t, p)), row[kTruth]);
  std::size_t asked = 0;
  for (const Kernel* kernel : FloatInsideKernels()) {
    if (kernel->method.key != row[0] || kernel->scalar != ScalarOf<T>()) {
      continue;
    }
    ++asked;
    EXPECT_NE(Says(*kernel, t, p), Expected(kernel->method, t, p))
        << NameOf(*kernel);
  }
  if (asked == 0) GTEST_SKIP() << "no ISA with FMA runs here";
}

TEST(RecipesTest, EachIsWrongJustOutsideItsDomain) {
  const Rows rows = ReadRecipes();
  EXPECT_FALSE(rows.empty());
  for (const auto& [key, row] : rows) {
    SCOPED_TRACE(key.first + " " + key.second + ", " + row[kOutside]);
    EXPECT_NE(row[kRightWhere], "");
    if (key.second == "f32") {
      ExpectWrong<float>(row);
    } else {
      ExpectWrong<double>(row);
    }
  }
}

// Both ways out of a domain of range and bits, and each scalar that there is.
TEST(RecipesTest, NoRecipeIsMissing) {
  const Rows rows = ReadRecipes();
  for (const char* method :
       {"shewchuk_adaptive", "ozaki_adaptive", "double_double",
        "cross_product_kahan", "promoted_f64", "promoted_f64_fma",
        "promoted_f64_kahan", "epsilon", "epsilon_fma"}) {
    for (const Kernel& kernel : AllKernels()) {
      if (kernel.method.key != method || !IsFloat(kernel.scalar)) continue;
      EXPECT_GT(rows.count({method, std::string(Name(kernel.scalar))}), 0u)
          << method << " " << Name(kernel.scalar);
    }
  }
}

// By Shewchuk's filter or Ozaki's.
constexpr std::array<const char*, 2> kAdaptive = {"shewchuk_adaptive",
                                                  "ozaki_adaptive"};

TEST(AdaptiveTest, IsRightAtAnySpreadWithinItsRange) {
  for (const char* method : kAdaptive) {
    ExpectRight<float>(method,
                       [](Random& r) { return Spread<float>(r, -50, 62); });
    ExpectRight<float>(method,
                       [](Random& r) { return Spread<float>(r, -2, 1); });
    ExpectRight<double>(method,
                        [](Random& r) { return Spread<double>(r, -484, 510); });
    ExpectRight<double>(method,
                        [](Random& r) { return Spread<double>(r, -2, 1); });
  }
}

TEST(AdaptiveTest, IsRightOnNearlyCollinearWholeNumbers) {
  for (const char* method : kAdaptive) {
    ExpectRight<float>(method, [](Random& r) { return OnGrid<float>(r, 23); });
    ExpectRight<double>(method,
                        [](Random& r) { return OnGrid<double>(r, 53); });
    ExpectRight<double>(
        method, [](Random& r) { return OnScaledGrid<double>(r, 52, -484); });
  }
}

// What the products lose is below the smallest subnormal number.
// Double-double and Kahan's difference, and at both ends of their range.
TEST(DifferencesTest, BothAreRightWhereTheyAreExact) {
  for (const char* method : {"double_double", "cross_product_kahan"}) {
    ExpectRight<float>(method, [](Random& r) { return OnGrid<float>(r, 23); });
    ExpectRight<double>(method,
                        [](Random& r) { return OnGrid<double>(r, 52); });
    for (const int exponent : {-50, 62 - 22}) {
      ExpectRight<float>(method, [exponent](Random& r) {
        return OnScaledGrid<float>(r, 22, exponent);
      });
    }
    for (const int exponent : {-484, 510 - 51}) {
      ExpectRight<double>(method, [exponent](Random& r) {
        return OnScaledGrid<double>(r, 51, exponent);
      });
    }
  }
}

TEST(PromotedTest, IsRightWhereTheDeterminantIsExactInF64) {
  for (const char* method : {"promoted_f64", "promoted_f64_fma"}) {
    ExpectRight<float>(method, [](Random& r) { return OnGrid<float>(r, 25); });
  }
}

TEST(PromotedTest, KahanIsRightWhereExponentsSpreadOver28Binades) {
  ExpectRight<float>("promoted_f64_kahan",
                     [](Random& r) { return OnGrid<float>(r, 51); });
  ExpectRight<float>("promoted_f64_kahan",
                     [](Random& r) { return Spread<float>(r, -14, 14); });
}

struct Wrongs {
  std::size_t inside = 0;
  std::size_t outside = 0;
  bool operator==(const Wrongs&) const = default;
};

// What each kernel of the method gets wrong of the scene, which is the same.
template <class T>
Wrongs WrongsOn(const std::string& scene_name, std::string_view method) {
  const Scene<T> scene = MakeScene<T>(ParseScene(scene_name), Loop::kPairs,
                                      {.groups = 40, .size = 67}, kDefaultSeed);
  const SceneTruth truth = JudgeScene(scene);
  std::vector<Wrongs> found;
  for (const Kernel* kernel : PairsOf<T>(method)) {
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
    EXPECT_EQ(WrongsOn<float>("cancellation:binades=28", method), Wrongs{})
        << method;
  }
  std::vector<Wrongs> beyond;
  for (const std::string_view method : methods) {
    beyond.push_back(WrongsOn<float>("cancellation:binades=30", method));
    EXPECT_GT(beyond.back().inside, 0u) << method;
  }
  EXPECT_NE(beyond[0], beyond[1]);
  EXPECT_NE(beyond[0], beyond[2]);
  EXPECT_NE(beyond[1], beyond[2]);
}

// Bits of whole coordinates with which a method is right, and with which it is
// not always.
struct Bits {
  std::string_view method;
  int right, wrong;
};

template <class T>
void ExpectBits(const std::vector<Bits>& all) {
  for (const Bits& bits : all) {
    SCOPED_TRACE(bits.method);
    if (PairsOf<T>(bits.method).empty()) continue;  // no ISA with FMA
    const auto on = [&](int n) {
      return WrongsOn<T>("whole_numbers:bits=" + std::to_string(n),
                         bits.method);
    };
    EXPECT_EQ(on(bits.right), Wrongs{});
    EXPECT_NE(on(bits.wrong), Wrongs{});
  }
}

TEST(WholeNumbersTest, TellHowManyBitsEachMethodIsRightWith) {
  ExpectBits<float>({{"cross_product_centered", 11, 14},
                     {"cross_product_centered_fma", 11, 14},
                     {"cross_product_kahan", 23, 24},
                     {"double_double", 23, 24}});
  ExpectBits<double>({{"cross_product_centered", 25, 29},
                      {"cross_product_centered_fma", 25, 29},
                      {"cross_product_kahan", 52, 53},
                      {"double_double", 52, 53}});
}

TEST(WholeNumbersTest, OfAllBitsAreRightByExpansionsAndInF64) {
  for (const char* method : kAdaptive) {
    EXPECT_EQ(WrongsOn<float>("whole_numbers:bits=24", method), Wrongs{});
    EXPECT_EQ(WrongsOn<double>("whole_numbers:bits=53", method), Wrongs{});
  }
  for (const char* method : {"promoted_f64", "promoted_f64_kahan"}) {
    EXPECT_EQ(WrongsOn<float>("whole_numbers:bits=24", method), Wrongs{});
  }
}

TEST(EpsilonTest, IsRightOnWholeNumbers) {
  for (const char* method : {"epsilon", "epsilon_fma"}) {
    ExpectRight<float>(method, [](Random& r) { return OnGrid<float>(r, 10); });
    ExpectRight<double>(method,
                        [](Random& r) { return OnGrid<double>(r, 25); });
  }
}

}  // namespace
}  // namespace pitbench
