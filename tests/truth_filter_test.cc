// The filter of truth agrees with exact arithmetic, and exact arithmetic with
// plain rationals, on millions of inputs made to be hard; and neither depends
// on the order of the vertices.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstdlib>
#include <ios>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <type_traits>

#include "harness/truth/truth.h"

namespace pitbench {
namespace {

constexpr int kPointsPerFamily = PITBENCH_SLOW ? 50'000 : 500'000;

template <class T>
struct Input {
  Triangle<T> triangle;
  Point<T> p;
};

template <class T>
std::string Written(const Input<T>& input) {
  const auto& [a, b, c] = input.triangle;
  std::ostringstream text;
  text << std::hexfloat;
  for (const Point<T>& q : {a, b, c, input.p}) {
    text << +q.x << ',' << +q.y << ' ';
  }
  return text.str();
}

// Plain rational arithmetic, written as the textbook has it: no scaling, no
// shortcut, nothing shared with the code under test.
template <class T>
Position ByRationals(const Input<T>& input) {
  const auto cross = [](const Point<T>& a, const Point<T>& b,
                        const Point<T>& c) {
    const mpq_class ax(a.x), ay(a.y), bx(b.x), by(b.y), cx(c.x), cy(c.y);
    return sgn(mpq_class((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)));
  };
  const auto& [a, b, c] = input.triangle;
  const int area = cross(a, b, c);
  if (area == 0) return Position::kDegenerate;
  const std::array<int, 3> sides = {area * cross(a, b, input.p),
                                    area * cross(b, c, input.p),
                                    area * cross(c, a, input.p)};
  for (const int side : sides) {
    if (side < 0) return Position::kOutside;
  }
  for (const int side : sides) {
    if (side == 0) return Position::kBoundary;
  }
  return Position::kInside;
}

template <class T>
class Generator {
 public:
  explicit Generator(std::uint64_t seed) : bits_(seed) {}

  int Int(int low, int high) {
    const auto span = static_cast<std::uint64_t>(high - low + 1);
    return low + static_cast<int>(bits_() % span);
  }
  // In [−1, 1), with as many bits as T has.
  T Unit() {
    constexpr int kDigits = std::numeric_limits<T>::digits;
    const auto integer = static_cast<std::int64_t>(bits_()) >> (63 - kDigits);
    return std::ldexp(static_cast<T>(integer), -kDigits);
  }
  Point<T> UnitPoint() {
    const T x = Unit();
    return {x, Unit()};
  }
  Triangle<T> UnitTriangle() {
    const Point<T> a = UnitPoint();
    const Point<T> b = UnitPoint();
    return {a, b, UnitPoint()};
  }
  T MovedByUlps(T x, int most) {
    constexpr T kInfinity = std::numeric_limits<T>::infinity();
    const int ulps = Int(-most, most);
    for (int k = 0; k < std::abs(ulps); ++k) {
      x = std::nextafter(x, ulps < 0 ? -kInfinity : kInfinity);
    }
    return x;
  }
  // A point of segment ab, rounded and then moved by a few ulps.
  Point<T> Near(const Point<T>& a, const Point<T>& b, int ulps = 2) {
    const T t = (Unit() + 1) / 2;
    const T x = MovedByUlps(a.x + t * (b.x - a.x), ulps);
    return {x, MovedByUlps(a.y + t * (b.y - a.y), ulps)};
  }

 private:
  std::mt19937_64 bits_;
};

template <class T>
Input<T> Scaled(Input<T> input, int x_exponent, int y_exponent) {
  for (Point<T>* q :
       {&input.triangle.a, &input.triangle.b, &input.triangle.c, &input.p}) {
    q->x = std::ldexp(q->x, x_exponent);
    q->y = std::ldexp(q->y, y_exponent);
  }
  return input;
}

template <class T>
Input<T> NearAnEdge(Generator<T>& random) {
  const Triangle<T> at = random.UnitTriangle();
  return {at, random.Near(at.a, at.b)};
}

// c lies within ulps of ab, and p within ulps of both.
template <class T>
Input<T> Needle(Generator<T>& random) {
  const Point<T> a = random.UnitPoint();
  const Point<T> b = random.UnitPoint();
  const Point<T> c = random.Near(a, b, 40);
  return {{a, b, c}, random.Near(a, c, 20)};
}

// The offset leaves the triangle 3 bits, or more, or all but one.
template <class T>
Input<T> FarFromTheOrigin(Generator<T>& random) {
  constexpr int kDigits = std::numeric_limits<T>::digits;
  const T offset = std::ldexp(T{1}, kDigits - random.Int(3, kDigits));
  const auto moved = [offset](Point<T> q) -> Point<T> {
    return {q.x + offset, q.y - offset};
  };
  const Triangle<T> unit = random.UnitTriangle();
  const Triangle<T> at = {moved(unit.a), moved(unit.b), moved(unit.c)};
  return {at, random.Near(at.b, at.c, 1)};
}

// Near an edge, from subnormal to near overflow, x and y apart.
template <class T>
Input<T> ExtremeExponents(Generator<T>& random) {
  using Limits = std::numeric_limits<T>;
  const auto exponent = [&random] {
    switch (random.Int(0, 3)) {
      case 0:  // subnormal, few bits left
        return Limits::min_exponent - random.Int(0, Limits::digits);
      case 1:  // the greatest that T holds
        return Limits::max_exponent - random.Int(0, 2);
      default:  // products that leave T's range, and any other
        return random.Int(Limits::min_exponent / 2, Limits::max_exponent / 2);
    }
  };
  const int x = exponent();
  const int y = random.Int(0, 1) == 0 ? x : exponent();
  return Scaled(NearAnEdge(random), x, y);
}

// Every coordinate has an exponent of its own.
template <class T>
Input<T> MixedExponents(Generator<T>& random) {
  using Limits = std::numeric_limits<T>;
  const auto spread = [&random](Point<T> q) -> Point<T> {
    const int width = random.Int(0, 1) == 0 ? 60 : Limits::max_exponent;
    q.x = std::ldexp(q.x, random.Int(-width, width));
    q.y = std::ldexp(q.y, random.Int(-width, width));
    return q;
  };
  const Triangle<T> unit = random.UnitTriangle();
  const Triangle<T> at = {spread(unit.a), spread(unit.b), spread(unit.c)};
  return {at, random.Near(at.a, at.b, 1)};
}

// Small integers times a power of two: all four points are often collinear,
// on an edge, or the same.
template <class T>
Input<T> SmallGrid(Generator<T>& random) {
  const auto point = [&random]() -> Point<T> {
    const auto x = static_cast<T>(random.Int(-3, 3));
    return {x, static_cast<T>(random.Int(-3, 3))};
  };
  const Input<T> grid = {{point(), point(), point()}, point()};
  const int exponent = random.Int(std::numeric_limits<T>::min_exponent - 20,
                                  std::numeric_limits<T>::max_exponent - 3);
  return Scaled(grid, exponent, exponent);
}

// Coordinates of `bits` bits, p within 1 of an edge.
Input<std::int32_t> Integers(std::mt19937_64& bits, int width) {
  const auto coordinate = [&bits, width] {
    return static_cast<std::int32_t>(static_cast<std::int64_t>(bits()) >>
                                     (64 - width));
  };
  const auto point = [&]() -> Point<std::int32_t> {
    const std::int32_t x = coordinate();
    return {x, coordinate()};
  };
  Input<std::int32_t> input = {{point(), point(), point()}, {}};
  const auto& [a, b, c] = input.triangle;
  // In halves, quarters … of an edge the rounded point is often on it.
  const std::int64_t parts = std::int64_t{1} << (bits() % 31);
  const auto k =
      static_cast<std::int64_t>(bits() % static_cast<std::uint64_t>(parts + 1));
  const auto between = [&](std::int64_t from, std::int64_t to) {
    const auto move = static_cast<std::int64_t>(bits() % 3) - 1;
    const std::int64_t at = from + (to - from) / parts * k + move;
    return static_cast<std::int32_t>(
        std::clamp<std::int64_t>(at, std::numeric_limits<std::int32_t>::min(),
                                 std::numeric_limits<std::int32_t>::max()));
  };
  input.p = {between(a.x, b.x), between(a.y, b.y)};
  return input;
}

// The textbook in arithmetic as narrow as T, which must get some of the inputs
// wrong.
template <class T>
Position ByRounding(const Input<T>& input) {
  using Narrow = std::conditional_t<std::same_as<T, double>, double, float>;
  const auto cross = [](const Point<T>& a, const Point<T>& b,
                        const Point<T>& c) {
    const auto ax = static_cast<Narrow>(a.x);
    const auto ay = static_cast<Narrow>(a.y);
    return (static_cast<Narrow>(b.x) - ax) * (static_cast<Narrow>(c.y) - ay) -
           (static_cast<Narrow>(b.y) - ay) * (static_cast<Narrow>(c.x) - ax);
  };
  const auto& [a, b, c] = input.triangle;
  const Narrow area = cross(a, b, c);
  if (area == 0) return Position::kDegenerate;
  const Narrow turn = area > 0 ? Narrow{1} : Narrow{-1};
  const Narrow least =
      std::min({turn * cross(a, b, input.p), turn * cross(b, c, input.p),
                turn * cross(c, a, input.p)});
  return least < 0    ? Position::kOutside
         : least == 0 ? Position::kBoundary
                      : Position::kInside;
}

// `make` gives the inputs. Plain arithmetic must err on some of them, or they
// would be too easy to prove anything.
template <class T, class Make>
void ExpectAgreement(Make make) {
  int plain_errs = 0;
  for (int i = 0; i < kPointsPerFamily; ++i) {
    const Input<T> input = make();
    const Position exact = ClassifyExactly(input.triangle, input.p);
    ASSERT_EQ(Classify(input.triangle, input.p), exact) << Written(input);
    if (ByRounding(input) != exact) ++plain_errs;
    if (i % 16 != 0) continue;
    ASSERT_EQ(ByRationals(input), exact) << Written(input);
    const auto& [a, b, c] = input.triangle;
    for (const Triangle<T>& permuted :
         {Triangle<T>{a, c, b}, Triangle<T>{b, a, c}, Triangle<T>{b, c, a},
          Triangle<T>{c, a, b}, Triangle<T>{c, b, a}}) {
      ASSERT_EQ(Classify(permuted, input.p), exact) << Written(input);
      ASSERT_EQ(ClassifyExactly(permuted, input.p), exact) << Written(input);
    }
  }
  EXPECT_GT(plain_errs, 0);
}

template <class T>
class TruthFilterTest : public testing::Test {};
using Floats = testing::Types<float, double>;
TYPED_TEST_SUITE(TruthFilterTest, Floats);

#define PITBENCH_AGREES(Family)                                       \
  TYPED_TEST(TruthFilterTest, AgreesWithExactArithmetic##Family) {    \
    Generator<TypeParam> random(1);                                   \
    ExpectAgreement<TypeParam>([&random] { return Family(random); }); \
  }
PITBENCH_AGREES(NearAnEdge)
PITBENCH_AGREES(Needle)
PITBENCH_AGREES(FarFromTheOrigin)
PITBENCH_AGREES(ExtremeExponents)
PITBENCH_AGREES(MixedExponents)
PITBENCH_AGREES(SmallGrid)
#undef PITBENCH_AGREES

TEST(TruthFilterTest, AgreesWithExactArithmeticOnIntegersUpTo32Bits) {
  std::mt19937_64 bits(1);
  for (const int width : {16, 18, 20, 24, 31, 32}) {
    ExpectAgreement<std::int32_t>([&] { return Integers(bits, width); });
  }
}

}  // namespace
}  // namespace pitbench
