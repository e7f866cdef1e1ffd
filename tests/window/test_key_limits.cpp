#include "player/key_limits.hpp"

#include <doctest/doctest.h>

#include "player/json_values.hpp"
#include "scene/names.hpp"

using namespace weft;
using namespace weft::window;

TEST_CASE("limits, unit and words are those of the schema") {
  const auto gravity = limits_of("gravity");
  REQUIRE(gravity);
  CHECK(gravity->unit == "m/s²");
  CHECK(gravity->meaning.find('[') == std::string::npos);
  const auto substeps = limits_of("time.substeps");
  REQUIRE(substeps);
  CHECK(substeps->whole);
  CHECK(substeps->choices == std::vector<std::string>{"auto"});
  CHECK(limits_of("contact.method")->choices.size() == std::size(scene::kContactMethodNames));
  CHECK(limits_of("cloths.0.stiffness.shear")->numeric);
  CHECK(!limits_of("cloths.0.nothing"));
  CHECK(!limits_of("gravity.x"));
}

TEST_CASE("what is typed is a number in its limits, or a word that stands for one") {
  const KeyLimits& substeps = *limits_of("time.substeps");
  CHECK(parsed(substeps, "Substeps", "12").value() == "12");
  CHECK(parsed(substeps, "Substeps", "auto").value() == "\"auto\"");
  CHECK(parsed(substeps, "Substeps", "").value() == "\"auto\"");
  const KeyLimits& density = *limits_of("cloths.0.density");
  CHECK(parsed(density, "Density", "0.25").value() == "0.25");
  for (const char* bad : {"", "x", "0.2x", "-1", "nan", "1e99"}) CHECK(!parsed(density, "Density", bad));
  const auto refused = parsed(substeps, "Substeps", "2.5");
  REQUIRE(!refused);
  CHECK(refused.error().kind == ErrorKind::Input);
  CHECK(refused.error().message.find("Substeps is \"2.5\", but must be a whole number from 1 to ") == 0);
  CHECK(refused.error().message.find(" or \"auto\".") != std::string::npos);
}

TEST_CASE("a key that a scene does not give has the format's value") {
  REQUIRE(fallback_of("gravity"));
  CHECK(text_of(*fallback_of("gravity")) == "[0,-9.81,0]");
  CHECK(!fallback_of("cloths.0.fabric"));
}
