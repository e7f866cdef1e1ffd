#include <doctest/doctest.h>

#include <cmath>

#include "scene/wind.hpp"

using namespace weft;
using namespace weft::scene;

TEST_CASE("a wind without gusts is even, and no wind is none") {
  const WindField even = wind_field({.velocity = {3, 0, -4}});
  CHECK(even.blows());
  CHECK_FALSE(even.varies());
  CHECK_FALSE(wind_field({.velocity = {0, 0, 0}, .gusts = 1}).blows());
}

TEST_CASE("gusts travel with the wind at its wavelength, and never turn it back") {
  for (const Vec3d& velocity : {Vec3d{3, 0, -4}, Vec3d{0, 2, 0}, Vec3d{0, -7, 0}, Vec3d{-1, 5, 0.1}}) {
    const double speed = length(velocity), wavelength = 1.7;
    const Vec3d along = velocity / speed;
    const WindField wind = wind_field({.velocity = velocity, .gusts = 1, .wavelength = wavelength});
    CHECK(wind.varies());
    // A place that goes with the wind keeps the phase of the first wave, and a wavelength is one turn.
    CHECK(dot(wind.waves[0].gradient, velocity) == doctest::Approx(wind.waves[0].rate));
    CHECK(dot(wind.waves[0].gradient, along * wavelength) == doctest::Approx(1));
    CHECK(std::abs(dot(wind.waves[1].gradient, along)) < 1e-12);  // the second runs across
    CHECK(length(wind.waves[0].gradient) / length(wind.waves[1].gradient) ==
          doctest::Approx(2 / (1 + std::sqrt(5.0))));
    double most = 0;  // of what both waves together take from the wind
    for (const WindWave& wave : wind.waves) most += std::abs(dot(wave.gust, along));
    CHECK(most <= speed * (1 + 1e-12));
    for (const WindWave& wave : wind.waves) CHECK(length(wave.gust) < 0.62 * speed);
  }
}

TEST_CASE("the part of a turn is never below 0 or as much as 1, and loses nothing after a million turns") {
  CHECK(turn_part(-0.25) == 0.75);
  CHECK(turn_part(3.0) == 0);
  CHECK(turn_part(1e6 + 0.125) == 0.125);
}
