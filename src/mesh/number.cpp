#include "mesh/number.hpp"

#include <cfloat>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>

namespace weft::mesh {
namespace {

// A double or a float is halfway between two floats only with at most 113 significant digits, between two
// doubles with at most 768: digits beyond these matter only by not being zero, which one more digit "1"
// stands for.
constexpr int kMaxDigits = 770;
constexpr int kMaxExponent = 1'000'000;  // beyond: zero or infinite, whatever the digits

/// A decimal number: digits × 10^exponent, without a point, so that strtod reads it the same in every locale.
struct Decimal {
  bool negative = false;
  int digit_count = 0;         // significant digits seen, leading zeros apart; at most kMaxDigits + 1
  std::int64_t exponent = 0;   // of ten
  std::uint64_t mantissa = 0;  // the digits as a number, while digit_count <= 19
  char digits[kMaxDigits + 2];
};

void add_digit(Decimal& number, char digit, bool after_point) {
  if (after_point) --number.exponent;
  if (number.digit_count == 0 && digit == '0') return;
  if (number.digit_count <= kMaxDigits - 1) {
    number.digits[number.digit_count++] = digit;
    if (number.digit_count <= 19)
      number.mantissa = number.mantissa * 10 + static_cast<std::uint64_t>(digit - '0');
    return;
  }
  ++number.exponent;
  if (digit == '0') return;
  if (number.digit_count == kMaxDigits) {
    number.digits[number.digit_count++] = '1';
    --number.exponent;
  }
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool parse_decimal(std::string_view word, Decimal& number) {
  std::size_t at = 0;
  if (at < word.size() && (word[at] == '+' || word[at] == '-')) number.negative = word[at++] == '-';
  bool any = false;
  bool after_point = false;
  for (; at < word.size(); ++at) {
    if (word[at] == '.' && !after_point) {
      after_point = true;
    } else if (is_digit(word[at])) {
      any = true;
      add_digit(number, word[at], after_point);
    } else {
      break;
    }
  }
  if (!any) return false;
  if (at == word.size()) return true;
  if (word[at] != 'e' && word[at] != 'E') return false;
  bool negative_exponent = false;
  if (++at < word.size() && (word[at] == '+' || word[at] == '-')) negative_exponent = word[at++] == '-';
  if (at == word.size()) return false;
  std::int64_t exponent = 0;
  for (; at < word.size(); ++at) {
    if (!is_digit(word[at])) return false;
    if (exponent < (std::int64_t{1} << 40))
      exponent = exponent * 10 + (word[at] - '0');  // sizes of words are smaller
  }
  number.exponent += negative_exponent ? -exponent : exponent;
  return true;
}

// Clinger's fast path: an integer up to 2^53 times or over a power of ten up to 10^22 rounds once.
bool fast_double(const Decimal& number, double& value) {
  static constexpr double kPowers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                       1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  if (number.digit_count > 19 || number.mantissa > (std::uint64_t{1} << 53)) return false;
  if (number.exponent < -22 || number.exponent > 22) return false;
  const auto mantissa = static_cast<double>(number.mantissa);
  value = number.exponent < 0 ? mantissa / kPowers[-number.exponent] : mantissa * kPowers[number.exponent];
  return true;
}

// A correctly rounded double rounds to the right float too, unless it lies on the middle between two floats.
bool is_safe_as_float(double value) {
  if (value == 0.0) return true;
  if (value < static_cast<double>(FLT_MIN) || value > 1e38) return false;
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  constexpr std::uint64_t kDropped = (std::uint64_t{1} << 29) - 1;  // 52 - 23 bits of the fraction
  return (bits & kDropped) != (std::uint64_t{1} << 28);
}

template <class T>
T slow_value(Decimal& number) {
  if (number.digit_count == 0 || number.exponent < -kMaxExponent) return T{0};
  if (number.exponent > kMaxExponent) return std::numeric_limits<T>::infinity();
  char text[kMaxDigits + 16];
  std::memcpy(text, number.digits, static_cast<std::size_t>(number.digit_count));
  std::snprintf(text + number.digit_count, 15, "e%d", static_cast<int>(number.exponent));
  if constexpr (sizeof(T) == sizeof(float))
    return std::strtof(text, nullptr);
  else
    return std::strtod(text, nullptr);
}

}  // namespace

std::optional<double> parse_double(std::string_view word) {
  Decimal number;
  if (!parse_decimal(word, number)) return std::nullopt;
  double value = 0.0;
  if (!fast_double(number, value)) value = slow_value<double>(number);
  return number.negative ? -value : value;
}

std::optional<float> parse_float(std::string_view word) {
  Decimal number;
  if (!parse_decimal(word, number)) return std::nullopt;
  double nearest = 0.0;
  const float value = fast_double(number, nearest) && is_safe_as_float(nearest) ? static_cast<float>(nearest)
                                                                                : slow_value<float>(number);
  return number.negative ? -value : value;
}

std::optional<std::int64_t> parse_integer(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && is_digit(word[1])) word.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, status] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (status != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

void append_float(std::string& text, float value) {
  char buffer[64];
  for (int precision = 6; precision <= 9;
       ++precision) {  // %g drops zeros at the end, so 6 covers what is shorter
    const int size = std::snprintf(buffer, sizeof buffer, "%.*g", precision, static_cast<double>(value));
    std::string word;
    for (int i = 0; i < size; ++i) {  // the locale's decimal point, which may be several bytes, becomes "."
      const char c = buffer[i];
      if (is_digit(c) || c == '-' || c == '+' || c == 'e')
        word += c;
      else if (word.empty() || word.back() != '.')
        word += '.';
    }
    const auto back = parse_float(word);
    if (precision == 9 || (back && *back == value)) {
      text += word;
      return;
    }
  }
}

void append_integer(std::string& text, std::uint64_t value) {
  char buffer[24];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  text.append(buffer, end);
}

}  // namespace weft::mesh
