#include "player/notice.hpp"

#include <doctest/doctest.h>

using weft::window::Notice;
using weft::window::Tone;

TEST_CASE("a plain notice goes by itself, and what stands below it is seen again") {
  Notice notice;
  notice.say("An error.", Tone::Error);
  notice.say("Saved.", Tone::Plain);
  CHECK(notice.sentence() == "Saved.");
  notice.wait(4.9);
  CHECK(notice.sentence() == "Saved.");
  notice.wait(0.2);
  CHECK(notice.sentence() == "An error.");
  notice.wait(1000);
  CHECK(notice.sentence() == "An error.");
  notice.close();
  CHECK(notice.sentence() == "");
}

TEST_CASE("a warning does not take the place of an error, and goes on where the error has been read") {
  Notice notice;
  notice.say("An error.", Tone::Error);
  notice.say("A warning.", Tone::Warning);
  CHECK(notice.sentence() == "An error.");
  notice.clear_error();
  CHECK(notice.sentence() == "");
  notice.say("A warning.", Tone::Warning);
  notice.clear_error();
  CHECK(notice.sentence() == "A warning.");
}
