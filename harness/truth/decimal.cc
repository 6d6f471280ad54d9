#include "harness/truth/decimal.h"

#include <charconv>
#include <cstdlib>
#include <string>

namespace pitbench {
namespace {

// Takes the first character away if it is one of `characters`.
bool Skip(std::string_view& text, std::string_view characters) {
  const bool found =
      !text.empty() && characters.find(text.front()) != std::string_view::npos;
  if (found) text.remove_prefix(1);
  return found;
}

// base^|exponent|.
mpz_class Power(unsigned long base, long exponent) {
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), base,
                static_cast<unsigned long>(std::labs(exponent)));
  return power;
}

// value · base^exponent.
mpq_class TimesPower(const mpq_class& value, unsigned long base,
                     long exponent) {
  const mpq_class power(Power(base, exponent));
  return exponent < 0 ? mpq_class(value / power) : mpq_class(value * power);
}

}  // namespace

std::optional<mpq_class> ParseExactly(std::string_view text) {
  const bool negative = text.starts_with('-');
  Skip(text, "+-");
  const bool hexadecimal = text.starts_with("0x") || text.starts_with("0X");
  if (hexadecimal) text.remove_prefix(2);
  const std::string_view digits =
      hexadecimal ? "0123456789abcdefABCDEF" : "0123456789";

  std::string mantissa;
  long fraction_digits = 0;
  const auto take = [&] {
    const std::size_t end = text.find_first_not_of(digits);
    const std::string_view taken = text.substr(0, end);
    mantissa += taken;
    text.remove_prefix(taken.size());
    return static_cast<long>(taken.size());
  };
  take();
  if (Skip(text, ".")) fraction_digits = take();
  if (mantissa.empty()) return std::nullopt;

  int exponent = 0;
  if (Skip(text, hexadecimal ? "pP" : "eE")) {
    if (Skip(text, "+") && text.starts_with('-')) return std::nullopt;
    const char* last = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data(), last, exponent);
    if (error != std::errc() || std::abs(exponent) > kLargestExponent) {
      return std::nullopt;
    }
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  }
  if (!text.empty()) return std::nullopt;

  mpq_class value(mpz_class(mantissa, hexadecimal ? 16 : 10));
  value = hexadecimal ? TimesPower(value, 2, exponent - 4 * fraction_digits)
                      : TimesPower(value, 10, exponent - fraction_digits);
  return negative ? mpq_class(-value) : value;
}

}  // namespace pitbench
