#include <doctest/doctest.h>

#include <clocale>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>

#include "base/random.hpp"
#include "mesh/number.hpp"

using namespace weft;
using namespace weft::mesh;

namespace {

float random_float(Random& random) {
  float value = 0.0F;
  do {
    const std::uint32_t bits = random.next();
    std::memcpy(&value, &bits, sizeof value);
  } while (!std::isfinite(value));
  return value;
}

std::string random_decimal(Random& random) {
  std::string text = random.below(2) == 0 ? "-" : "";
  const std::uint32_t sizes[] = {2, 5, 9, 17, 25, 150, 900};
  for (std::uint32_t i = 0, size = 1 + random.below(sizes[random.below(7)]); i < size; ++i)
    text += static_cast<char>('0' + random.below(10));
  if (random.below(2) == 0)
    text.insert(text.size() - random.below(static_cast<std::uint32_t>(text.size() - 1)), ".");
  if (random.below(2) == 0) text += "e" + std::to_string(static_cast<int>(random.below(100)) - 50);
  return text;
}

}  // namespace

TEST_CASE("decimals are read as the C library reads them, to the last bit") {
  Random random(1);
  int different = 0;
  for (int i = 0; i < 50'000; ++i) {
    const std::string text = random_decimal(random);
    different += parse_float(text) != std::strtof(text.c_str(), nullptr);
    different += parse_double(text) != std::strtod(text.c_str(), nullptr);
  }
  CHECK(different == 0);
}

TEST_CASE("a decimal on the middle of two floats goes to the even one, and beside it to the nearer") {
  Random random(2);
  int wrong = 0;
  for (int i = 0; i < 5'000; ++i) {
    const float low = std::abs(random_float(random));
    const float high = std::nextafter(low, HUGE_VALF);
    if (!std::isfinite(high)) continue;
    const double middle = 0.5 * (static_cast<double>(low) + static_cast<double>(high));  // exact: 25 bits
    char text[400];
    std::snprintf(text, sizeof text, "%.300f", middle);  // floats have at most 149 places after the point
    const std::string on = text;
    std::uint32_t bits = 0;
    std::memcpy(&bits, &low, sizeof bits);
    wrong += parse_float(on) != (bits % 2 == 0 ? low : high);
    wrong += parse_float(on + "00000001") != high;
  }
  CHECK(wrong == 0);
}

TEST_CASE("a decimal that rounds to the middle of two floats as a double still goes to the nearer float") {
  Random random(4);
  int wrong = 0;
  int beside = 0;  // decimals that are not the middle itself: rounding twice gets half of them wrong
  for (int i = 0; i < 5'000; ++i) {
    const auto low = static_cast<float>(random.uniform(1.0, 1000.0));
    const double middle =
        0.5 * (static_cast<double>(low) + static_cast<double>(std::nextafter(low, HUGE_VALF)));
    char text[40];
    std::snprintf(text, sizeof text, "%.16g", middle);
    beside +=
        std::strtod(text, nullptr) == middle && std::strtof(text, nullptr) != static_cast<float>(middle);
    wrong += parse_float(text) != std::strtof(text, nullptr);
  }
  CHECK(wrong == 0);
  CHECK(beside > 0);
}

TEST_CASE("a digit far behind a middle still decides") {
  // 2^-1075 lies between 0 and the smallest double; it has 752 digits, so the last one here is number 853.
  char middle[1200];
  std::snprintf(middle, sizeof middle, "%.1075Lf", std::ldexp(1.0L, -1075));
  const std::string zeros(100, '0');
  CHECK(parse_double(middle + zeros) == 0.0);
  CHECK(parse_double(middle + zeros + "1") == std::numeric_limits<double>::denorm_min());
  CHECK(parse_float("1.000000059604644775390625" + std::string(2000, '0')) == 1.0F);
  CHECK(parse_float("1.000000059604644775390625" + std::string(2000, '0') + "1") ==
        std::nextafter(1.0F, 2.0F));
}

TEST_CASE("every float written is read back to the same bits, in at most nine digits") {
  Random random(3);
  int wrong = 0;
  for (int i = 0; i < 50'000; ++i) {
    const float value = random_float(random);
    std::string text;
    append_float(text, value);
    const float back = parse_float(text).value();
    wrong += std::memcmp(&back, &value, sizeof value) != 0 || text.size() > 15;
  }
  CHECK(wrong == 0);
  std::string text;
  append_float(text, 0.1F);
  append_float(text, -0.0F);
  append_float(text, 16777216.0F);
  CHECK(text == "0.1-016777216");
}

TEST_CASE("numbers read and write alike under a locale with a decimal comma") {
  const char* name = std::setlocale(LC_NUMERIC, "de_DE.UTF-8");
  if (name == nullptr) MESSAGE("de_DE.UTF-8 is not installed: only the C locale is tested");
  std::string text;
  append_float(text, 1.5F);
  CHECK(text == "1.5");
  CHECK(parse_float("1.5") == 1.5F);
  CHECK(parse_float("1.00000005960464477539062500001") == std::nextafter(1.0F, 2.0F));
  CHECK_FALSE(parse_float("1,5"));
  std::setlocale(LC_NUMERIC, "C");
}

TEST_CASE("what is no decimal number is refused, and what is too large is infinite") {
  for (const char* text :
       {"", "-", "+", ".", "e5", "1e", "1e+", "nan", "inf", "0x10", "1.2.3", "1f", "--1", "1e5.0"}) {
    INFO(text);
    CHECK_FALSE(parse_float(text));
    CHECK_FALSE(parse_double(text));
  }
  CHECK(parse_float("1e39") == HUGE_VALF);
  CHECK(parse_float("-1e999999999999999999999") == -HUGE_VALF);
  CHECK(parse_float("1e-999999999999999999999") == 0.0F);
  CHECK(parse_float("0e999999") == 0.0F);
  CHECK(parse_float("+.5e1") == 5.0F);
  CHECK(parse_integer("-12") == -12);
  CHECK(parse_integer("+12") == 12);
  for (const char* text : {"", "+", "+-1", "1.0", "99999999999999999999", "0x1", "1 "})
    CHECK_FALSE(parse_integer(text));
}
