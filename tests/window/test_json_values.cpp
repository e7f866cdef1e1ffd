#include "player/json_values.hpp"

#include <doctest/doctest.h>

using namespace weft;
using namespace weft::window;

TEST_CASE("a value is found by its dotted key, and said as JSON again") {
  const std::string text = R"({"a":{"b":[1,2.5,{"c":"word"}]},"d":true,"e":null})";
  const auto json = parse_json(text, "test");
  REQUIRE(json);
  CHECK(text_of(*json) == text);
  REQUIRE(value_at(*json, "a.b.2.c") != nullptr);
  CHECK(value_at(*json, "a.b.2.c")->text == "word");
  CHECK(value_at(*json, "a.b.3") == nullptr);
  CHECK(value_at(*json, "a.b.c") == nullptr);
  CHECK(value_at(*json, "d.x") == nullptr);
}
