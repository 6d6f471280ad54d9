// Sums and products of doubles, exactly: whole numbers of as many 64-bit words
// as their bits need, in a unit that is a power of two.
//
// Never allocates, throws, overflows or underflows: how many words there may be
// follows from how many doubles are multiplied. What is not needed of them is
// neither set nor read, and with the unit that CommonUnit finds coordinates of
// like size are of one word, and their products of two or three.
#ifndef PITBENCH_KERNELS_EXACT_BIG_NUMBER_H_
#define PITBENCH_KERNELS_EXACT_BIG_NUMBER_H_

#include <algorithm>
#include <bit>
#include <cstdint>
#include <initializer_list>

namespace pitbench {

// The number mantissa · 2^exponent.
struct SplitDouble {
  std::int64_t mantissa;
  int exponent;

  // `value` is finite; |mantissa| < 2^53, odd or 0.
  static SplitDouble Of(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    std::uint64_t magnitude = bits & ((std::uint64_t{1} << 52) - 1);
    const int field = static_cast<int>((bits >> 52) & 0x7FF);
    if (field != 0) magnitude |= std::uint64_t{1} << 52;
    if (magnitude == 0) return {0, 0};
    const int zeros = std::countr_zero(magnitude);
    const auto mantissa = static_cast<std::int64_t>(magnitude >> zeros);
    return {(bits >> 63) != 0 ? -mantissa : mantissa,
            std::max(field, 1) - 1075 + zeros};
  }
};

// The exponent of the largest power of two of which all these are multiples; of
// no more of them than 0s, 0. They are finite.
inline int CommonUnit(std::initializer_list<double> values) {
  int unit = 1024;
  for (const double value : values) {
    const SplitDouble split = SplitDouble::Of(value);
    if (split.mantissa != 0) unit = std::min(unit, split.exponent);
  }
  return unit == 1024 ? 0 : unit;
}

// A double as a whole number of 2^unit, if it is one below 2^62: of two of them
// the difference is below 2^63, and what two differences multiply to below
// 2^126.
struct SmallWhole {
  bool fits;
  std::int64_t value;

  SmallWhole(double of, int unit) {
    const SplitDouble split = SplitDouble::Of(of);
    const auto magnitude = static_cast<std::uint64_t>(
        split.mantissa < 0 ? -split.mantissa : split.mantissa);
    const int shift = split.exponent - unit;
    fits = magnitude == 0 ||
           (shift >= 0 && shift <= std::countl_zero(magnitude) - 2);
    value = fits ? split.mantissa *
                       (std::int64_t{1} << (magnitude == 0 ? 0 : shift))
                 : 0;
  }
};

// A sum of at most eight products of kDegree factors, each of them a double or
// the difference of two.
template <int kDegree>
class BigNumber {
  // A double's bits have the weights 2^-1074 to 2^1023, and one more below for
  // what is half way between two of them: at most 34 words, in which the sum of
  // two has room as well. Products take no more words than their factors. A
  // sum of products is below 2^(1025·kDegree + 3), its bits are from
  // 2^(-1075·kDegree) on, and the highest word that a carry might reach is one
  // more: within 34·kDegree words too, wherever these are cut.
  static constexpr int kMostWords = 34 * kDegree;
  using Word = std::uint64_t;
  __extension__ using TwoWords = unsigned __int128;

 public:
  BigNumber() = default;  // 0

  // In units of 2^unit.
  explicit BigNumber(double value, int unit = 0)
      : BigNumber(SplitDouble::Of(value), unit) {}

  // |mantissa| < 2^54, exponent ≥ −1075.
  explicit BigNumber(SplitDouble value, int unit = 0) {
    if (value.mantissa == 0) return;
    negative_ = value.mantissa < 0;
    const auto magnitude =
        static_cast<Word>(negative_ ? -value.mantissa : value.mantissa);
    const int place = value.exponent - unit;
    lowest_ = place >> 6;  // rounded down
    const TwoWords wide = static_cast<TwoWords>(magnitude) << (place & 63);
    word_[0] = static_cast<Word>(wide);
    word_[1] = static_cast<Word>(wide >> 64);
    count_ = word_[1] == 0 ? 1 : 2;
  }

  // A copy is of the words that there are.
  BigNumber(const BigNumber& other)
      : negative_(other.negative_),
        lowest_(other.lowest_),
        count_(other.count_) {
    std::copy_n(other.word_, count_, word_);
  }
  BigNumber& operator=(const BigNumber& other) {
    if (this == &other) return *this;
    negative_ = other.negative_;
    lowest_ = other.lowest_;
    count_ = other.count_;
    std::copy_n(other.word_, count_, word_);
    return *this;
  }

  // −1, 0 or 1.
  int Sign() const { return count_ == 0 ? 0 : negative_ ? -1 : 1; }

  BigNumber Magnitude() const {
    BigNumber magnitude = *this;
    magnitude.negative_ = false;
    return magnitude;
  }

  friend BigNumber operator+(const BigNumber& a, const BigNumber& b) {
    return Sum(a, b, b.negative_);
  }
  friend BigNumber operator-(const BigNumber& a, const BigNumber& b) {
    return Sum(a, b, !b.negative_);
  }

  template <int kOther>
  BigNumber<kDegree + kOther> operator*(const BigNumber<kOther>& b) const {
    BigNumber<kDegree + kOther> product;
    if (count_ == 0 || b.count_ == 0) return product;
    product.negative_ = negative_ != b.negative_;
    product.lowest_ = lowest_ + b.lowest_;
    product.count_ = count_ + b.count_;
    std::fill_n(product.word_, b.count_, Word{0});
    for (int i = 0; i < count_; ++i) {
      Word carry = 0;
      for (int j = 0; j < b.count_; ++j) {
        const TwoWords sum = static_cast<TwoWords>(word_[i]) * b.word_[j] +
                             product.word_[i + j] + carry;
        product.word_[i + j] = static_cast<Word>(sum);
        carry = static_cast<Word>(sum >> 64);
      }
      product.word_[i + b.count_] = carry;
    }
    product.DropLeadingZeros();
    return product;
  }

  // The number is near fraction · 2^exponent units, within 2^-52 of itself;
  // |fraction| is from 2^63 to 2^64. Precondition: it is not 0.
  double Leading(int& exponent) const {
    const Word top = word_[count_ - 1];
    const int unused = std::countl_zero(top);
    Word leading = top << unused;
    if (unused != 0 && count_ > 1) {
      leading |= word_[count_ - 2] >> (64 - unused);
    }
    exponent = 64 * (lowest_ + count_ - 1) - unused;
    const auto fraction = static_cast<double>(leading);
    return negative_ ? -fraction : fraction;
  }

 private:
  template <int>
  friend class BigNumber;

  // a + b, where b's sign is this one.
  static BigNumber Sum(const BigNumber& a, const BigNumber& b,
                       bool b_negative) {
    BigNumber sum;
    if (a.count_ == 0) {
      sum = b;
      sum.negative_ = b_negative;
      return sum;
    }
    sum.negative_ = a.negative_;
    sum.lowest_ = b.count_ == 0 ? a.lowest_ : std::min(a.lowest_, b.lowest_);
    const int top = std::max(a.lowest_ + a.count_,
                             b.count_ == 0 ? a.lowest_ : b.lowest_ + b.count_);
    sum.count_ = top - sum.lowest_;
    // a in the words of the sum, and b added to it or subtracted.
    const int below = a.lowest_ - sum.lowest_;
    std::fill_n(sum.word_, below, Word{0});
    std::copy_n(a.word_, a.count_, sum.word_ + below);
    std::fill(sum.word_ + below + a.count_, sum.word_ + sum.count_, Word{0});
    const int first = b.lowest_ - sum.lowest_;
    Word carry = 0;
    if (a.negative_ == b_negative) {
      for (int i = 0; i < b.count_; ++i) {
        const TwoWords word =
            static_cast<TwoWords>(sum.word_[first + i]) + b.word_[i] + carry;
        sum.word_[first + i] = static_cast<Word>(word);
        carry = static_cast<Word>(word >> 64);
      }
      for (int i = first + b.count_; carry != 0 && i < sum.count_; ++i) {
        carry = ++sum.word_[i] == 0 ? 1 : 0;
      }
      if (carry != 0) sum.word_[sum.count_++] = carry;
      return sum;
    }
    for (int i = 0; i < b.count_; ++i) {
      const TwoWords word =
          static_cast<TwoWords>(sum.word_[first + i]) - b.word_[i] - carry;
      sum.word_[first + i] = static_cast<Word>(word);
      carry = static_cast<Word>(word >> 64) & 1;
    }
    for (int i = first + b.count_; carry != 0 && i < sum.count_; ++i) {
      carry = sum.word_[i]-- == 0 ? 1 : 0;
    }
    if (carry != 0) sum.Negate();  // |b| is the larger one
    sum.DropLeadingZeros();
    return sum;
  }

  // Of what has been borrowed from beyond the highest word.
  void Negate() {
    negative_ = !negative_;
    Word carry = 1;
    for (int i = 0; i < count_; ++i) {
      word_[i] = ~word_[i] + carry;
      carry = carry != 0 && word_[i] == 0 ? 1 : 0;
    }
  }

  void DropLeadingZeros() {
    while (count_ > 0 && word_[count_ - 1] == 0) --count_;
  }

  bool negative_ = false;
  int lowest_ = 0;  // word 0 has the weight 2^(64·lowest_)
  int count_ = 0;   // 0, or the highest word is not 0
  Word word_[kMostWords];
};

}  // namespace pitbench

#endif  // PITBENCH_KERNELS_EXACT_BIG_NUMBER_H_
