#include "player/rates.hpp"

#include <doctest/doctest.h>

using weft::window::Rates;

TEST_CASE("rates are means over the last second") {
  Rates rates;
  std::uint64_t frames = 0;
  for (int i = 0; i < 100; ++i) rates.count(0.1, 0.05, frames += 7);
  for (int i = 0; i < 100; ++i) rates.count(0.02, 0.005, frames += 1);  // a frame a picture, 50 a second
  CHECK(rates.pictures_a_second() == doctest::Approx(50));
  CHECK(rates.picture_ms() == doctest::Approx(20));
  CHECK(rates.cpu_ms() == doctest::Approx(5));
  CHECK(rates.frames_a_second() == doctest::Approx(50));
  CHECK(rates.graph().size() == 120);
  CHECK(rates.graph().back() == doctest::Approx(20));
}

TEST_CASE("a scene that begins again counts from there") {
  Rates rates;
  for (int i = 1; i <= 20; ++i) rates.count(0.05, 0, 100 * i);
  for (int i = 1; i <= 20; ++i) rates.count(0.05, 0, i);
  CHECK(rates.frames_a_second() == doctest::Approx(20));
}
