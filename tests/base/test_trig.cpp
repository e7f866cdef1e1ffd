#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "base/random.hpp"
#include "base/trig.hpp"

using namespace weft;

namespace {

/// The larger of the two absolute errors, against libm in long double.
double error_at(double angle) {
  const Turn turn = turn_of(angle);
  const auto exact = static_cast<long double>(angle);
  return static_cast<double>(std::max(std::abs(static_cast<long double>(turn.cosine) - std::cos(exact)),
                                      std::abs(static_cast<long double>(turn.sine) - std::sin(exact))));
}

}  // namespace

TEST_CASE("sine and cosine are within 2e-16 of libm's, at angles of all sizes") {
  Random random(1);
  double worst = 0;
  for (int k = 0; k < 200000; ++k) {
    for (const double size : {1e-3, 1.0, 10.0, 1e3, 1e6, 1e9, 1e12})
      worst = std::max(worst, error_at(random.uniform(-size, size)));
  }
  CHECK(worst < 2e-16);
}

TEST_CASE("sine and cosine are right at and around multiples of a quarter turn") {
  for (int k = -2000; k <= 2000; ++k) {
    const double quarter = k * 1.5707963267948966;
    for (const double angle :
         {quarter, std::nextafter(quarter, 1e300), std::nextafter(quarter, -1e300), quarter / 2})
      CHECK(error_at(angle) < 2e-16);
  }
  CHECK(turn_of(0).cosine == 1);
  CHECK(turn_of(0).sine == 0);
}

TEST_CASE("the bits of sine and cosine never change") {
  const Turn turn = turn_of(2.5);
  CHECK(turn.sine == 0.5984721441039564);
  CHECK(turn.cosine == -0.8011436155469337);
  const Turn far = turn_of(123456789.0);
  CHECK(far.sine == 0.9901147518020355);
  CHECK(far.cosine == 0.14025968153390961);
}

TEST_CASE("the angle of a turn in the first quarter is within 4e-16 of libm's") {
  double worst = 0;
  for (int k = 0; k <= 100000; ++k) {
    const double angle = 1.5707963267948966 * k / 100000;
    const Turn turn{std::abs(std::cos(angle)), std::sin(angle)};
    const long double exact =
        std::atan2(static_cast<long double>(turn.sine), static_cast<long double>(turn.cosine));
    worst = std::max(worst, static_cast<double>(std::abs(exact - static_cast<long double>(angle_of(turn)))));
  }
  CHECK(worst < 4e-16);
  CHECK(angle_of({1, 0}) == 0);
  for (const double small : {1e-300, 1e-12, 1e-5})  // with all its digits
    CHECK(angle_of({1, small}) == doctest::Approx(small).epsilon(1e-9).scale(0));
}
