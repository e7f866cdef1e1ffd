#include "player/hand.hpp"

#include <doctest/doctest.h>

#include <limits>

using namespace weft::window;

TEST_CASE("a hand goes after the pointer no faster in simulated time than half as fast again in real time") {
  Hand hand({0, 0});
  hand.follow({10, 0}, 0.0);  // 10 pixels within 50 ms: 300 pixel/s are allowed
  const Place after = hand.after(0.01);
  CHECK(after.x == doctest::Approx(3));
  CHECK(after.y == 0);
  CHECK(!hand.arrived());
  CHECK(hand.after(0.01).x == doctest::Approx(6));
  CHECK(hand.after(1).x == 10);
  CHECK(hand.arrived());
}

TEST_CASE("where time stands still, a hand is with the pointer at once") {
  Hand hand({0, 0});
  hand.follow({300, 400}, 1.0);
  const Place after = hand.after(std::numeric_limits<double>::infinity());
  CHECK(after.x == 300);
  CHECK(after.y == 400);
}

TEST_CASE("only the way within the window counts for the pointer's speed") {
  Hand hand({0, 0});
  hand.follow({100, 0}, 0.0);
  CHECK(hand.after(1).x == 100);  // it has arrived, and what was allowed is over
  hand.follow({101, 0}, 1.0);     // 1 pixel within 50 ms: 30 pixel/s
  CHECK(hand.after(0.01).x == doctest::Approx(100.3));
}
