// A number that counts: it computes as T does and leaves a note of every
// operation on the tape.
#ifndef PITBENCH_KERNELS_COUNTING_NUMBER_H_
#define PITBENCH_KERNELS_COUNTING_NUMBER_H_

#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

#include "kernels/counting/tape.h"

namespace pitbench::counting {

// Operations; two of the same kind that give different results have different
// codes.
enum class Code : std::uint32_t {
  kConstant,
  kSame,  // the same bits under another name, or in more lanes
  kAdd,
  kSub,
  kMul,
  kMulAdd,
  kMulSub,
  kNegMulAdd,
  kNegMulSub,
  kDiv,
  kSqrt,
  kMin,
  kMax,
  kGreaterAsIntegers,
  kLesserAsUnsigned,
  kTestBit,
  kEq,
  kNe,
  kLt,
  kLe,
  kGe,
  kGt,
  kAnd,
  kOr,
  kXor,
  kAndNot,
  kNot,
  kSignMask,
  kAbs,
  kNeg,
  kCopySign,
  kSelect,
  kShiftLeft,
  kShiftRight,
  kConvert,
  kUpperHalf,
  kJoin,
  kCombine,
  kSumOfPairs,
  kIota,
  kFirstLanes,
  kLoad,
  kStore,
};

// One code for each operation on each type.
template <class T>
constexpr std::uint32_t CodeFor(Code code) {
  return static_cast<std::uint32_t>(code) * 64 +
         static_cast<std::uint32_t>(sizeof(T)) * 4 +
         (std::is_floating_point_v<T> ? 2 : 0) + (std::is_signed_v<T> ? 1 : 0);
}

template <class T>
std::uint64_t Bits(T value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof(value));
  return bits;
}

template <class T>
Id Note(Kind kind, Code code, std::size_t lanes, Id a = 0, Id b = 0, Id c = 0,
        std::uint64_t immediate = 0) {
  return CurrentTape().Note(kind, {.code = CodeFor<T>(code),
                                   .lanes = static_cast<std::uint32_t>(lanes),
                                   .immediate = immediate,
                                   .operands = {a, b, c}});
}

template <class T>
struct Number {
  T value;
  Id id;

  Number() : Number(T{}) {}
  // NOLINTNEXTLINE(google-explicit-constructor): a constant, as in x < 0
  Number(T constant)
      : value(constant),
        id(Note<T>(Kind::kFree, Code::kConstant, 1, 0, 0, 0, Bits(constant))) {}
  Number(T value_, Id id_) : value(value_), id(id_) {}
  template <class U>
  requires std::is_arithmetic_v<U>
  explicit Number(U constant) : Number(static_cast<T>(constant)) {}
  template <class U>
  explicit Number(Number<U> other)
      : value(static_cast<T>(other.value)),
        id(std::is_same_v<T, U>
               ? other.id
               : Note<T>(Kind::kConvert, Code::kConvert, 1, other.id)) {}

  // The number leaves: whatever is done with it is not noted any more.
  template <class U>
  requires std::is_arithmetic_v<U>
  explicit operator U() const {
    CurrentTape().Need(id);
    return static_cast<U>(value);
  }

  friend Number operator+(Number a, Number b) {
    return {a.value + b.value, Note<T>(Kind::kAdd, Code::kAdd, 1, a.id, b.id)};
  }
  friend Number operator-(Number a, Number b) {
    return {a.value - b.value, Note<T>(Kind::kAdd, Code::kSub, 1, a.id, b.id)};
  }
  friend Number operator*(Number a, Number b) {
    return {a.value * b.value,
            Note<T>(Kind::kMultiply, Code::kMul, 1, a.id, b.id)};
  }
  friend Number operator/(Number a, Number b) {
    return {a.value / b.value,
            Note<T>(Kind::kDivide, Code::kDiv, 1, a.id, b.id)};
  }
  friend Number operator-(Number a) {
    return {-a.value, Note<T>(Kind::kLogic, Code::kNeg, 1, a.id)};
  }
  Number& operator+=(Number b) { return *this = *this + b; }
  Number& operator-=(Number b) { return *this = *this - b; }
  Number& operator*=(Number b) { return *this = *this * b; }
  Number& operator/=(Number b) { return *this = *this / b; }

  // A branch follows from what a comparison says.
  friend bool operator<(Number a, Number b) {
    Compared(Code::kLt, a, b);
    return a.value < b.value;
  }
  friend bool operator>(Number a, Number b) { return b < a; }
  friend bool operator<=(Number a, Number b) {
    Compared(Code::kLe, a, b);
    return a.value <= b.value;
  }
  friend bool operator>=(Number a, Number b) { return b <= a; }
  friend bool operator==(Number a, Number b) {
    Compared(Code::kEq, a, b);
    return a.value == b.value;
  }
  friend bool operator!=(Number a, Number b) { return !(a == b); }

  friend Number abs(Number a) {
    return {std::abs(a.value), Note<T>(Kind::kLogic, Code::kAbs, 1, a.id)};
  }

 private:
  static void Compared(Code code, Number a, Number b) {
    CurrentTape().Need(Note<T>(Kind::kCompare, code, 1, a.id, b.id));
  }
};

}  // namespace pitbench::counting

// What Eigen asks of a number.
template <class T>
struct std::numeric_limits<pitbench::counting::Number<T>>
    : std::numeric_limits<T> {};

#endif  // PITBENCH_KERNELS_COUNTING_NUMBER_H_
