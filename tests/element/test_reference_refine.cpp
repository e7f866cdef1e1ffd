// The reference refined until a number is known: what it says of its error, against closed forms.
#include "closed_forms/elastica.hpp"
#include "element/reference/equilibrium.hpp"
#include "element/reference/refine.hpp"
#include "reference_sheets.hpp"

using namespace weft;
using namespace weft::reference;

TEST_CASE("a refined number has the order of its error, and is no further from the limit than it says") {
  for (const double order : {1.0, 2.0}) {
    const auto found =
        refine([&](int level) -> Result<double> { return 3 + 0.5 * std::exp2(-order * level); }, 1e-2, 12);
    REQUIRE(found);
    CHECK(found->order == doctest::Approx(order).epsilon(1e-10));
    CHECK(found->error < 1e-2);
    CHECK(std::abs(found->value - 3) == doctest::Approx(found->error / 1.25).epsilon(1e-10));
  }
}

TEST_CASE("a number that swings or is not fine enough is no limit") {
  const auto swings = refine([](int level) -> Result<double> { return level % 2; }, 1e-2);
  REQUIRE(!swings);
  CHECK(swings.error().message ==
        "After 6 levels a refined value has an error of inf, above 0.01, and changes by the order 0.");
  const auto coarse = refine([](int level) -> Result<double> { return std::exp2(-2 * level); }, 1e-6, 4);
  REQUIRE(!coarse);
  CHECK(coarse.error().message ==
        "After 4 levels a refined value has an error of 0.0195, above 1e-06, and changes by the order 2.");
  const auto fails = refine([](int) -> Result<double> { return input_error("No sheet."); }, 1e-6);
  REQUIRE(!fails);
  CHECK(fails.error().message == "No sheet.");
}

TEST_CASE(
    "a heavy cantilever that is refined until its drop is known to a thousandth drops as the elastica") {
  constexpr double kLength = 0.2, kModulus = 2e-5, kLoad = 10;  // [m], [N·m], G
  const double weight = kLoad * kModulus / std::pow(kLength, 3);
  const auto drop = [&](int level) -> Result<double> {
    const PatternSheet pattern = pattern_sheet(Pattern::Alternating, kLength, 6 << level, 1 << level, 1);
    Sheet sheet = cloth_of(pattern);
    sheet.warp = {1, 0, 0};
    sheet.held = held_before_zero(pattern.position);
    sheet.membrane.stiffness = Stiffness::of(Moduli::isotropic(1000 * weight * kLength, 0));
    sheet.bending = Stiffness::of(Moduli::isotropic(kModulus, 0));
    sheet.density = weight / 9.81;
    sheet.gravity = {0, 0, -9.81};
    WEFT_TRY(found, equilibrium(SheetEnergy(sheet), pattern.position));
    return -found.position.back().z / kLength;
  };
  const auto found = refine(drop, 1e-3);
  REQUIRE_MESSAGE(found, (found ? "" : found.error().message));
  const double exact = Elastica(kLoad, 1e-3).drop;
  MESSAGE("drop " << found->value << " for " << exact << ", error " << std::abs(found->value - exact)
                  << " of at most " << found->error << ", order " << found->order << ", " << found->levels
                  << " levels");
  CHECK(std::abs(found->value - exact) < found->error);
}
