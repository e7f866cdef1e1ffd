#include "player/pace.hpp"

#include <doctest/doctest.h>

using weft::window::Pace;

namespace {
constexpr double kFrame = 0.02;  // [s]
}

TEST_CASE("as many frames are due as real time has, however unevenly pictures come") {
  Pace pace;
  int frames = 0;
  const double pictures[] = {0.004, 0.017, 0.031, 0.008};  // 60 ms in all, and never late by two frames
  for (int i = 0; i < 400; ++i) {
    pace.pass(pictures[i % 4], kFrame);
    if (!pace.due(kFrame)) continue;
    pace.take(kFrame);
    ++frames;
  }
  CHECK(frames == 300);
  CHECK(pace.dropped() == doctest::Approx(0));
}

TEST_CASE("time that is late by more than two frames is dropped") {
  Pace pace;
  pace.pass(10 * kFrame, kFrame);
  CHECK(pace.dropped() == doctest::Approx(8 * kFrame));
  for (const bool due : {true, true, false}) {
    CHECK(pace.due(kFrame) == due);
    if (due) pace.take(kFrame);
  }
  CHECK(pace.until_due(kFrame) > 0.9 * kFrame);
}

TEST_CASE("a frame is due once its time is over, but for the unevenness of a display") {
  Pace pace;
  CHECK(!pace.due(kFrame));
  CHECK(pace.until_due(kFrame) == doctest::Approx(kFrame).epsilon(0.05));
  pace.pass(0.5 * kFrame, kFrame);
  CHECK(!pace.due(kFrame));
  pace.pass(0.49 * kFrame, kFrame);
  CHECK(pace.due(kFrame));
  pace.begin();
  CHECK(!pace.due(kFrame));
}
