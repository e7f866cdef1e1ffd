// Parameters that change while the cloth moves.
#include <cmath>

#include "world_rig.hpp"

using namespace weft;

namespace {

scene::Scene sheet(const std::vector<scene::Override>& overrides = {}) {
  auto scene = scene::parse_scene(
      R"({"format": "weft-scene/1", "solver": {"kind": "mass_spring"}, "contact": {"method": "none"}, "drag": 0.5,
         "wind": {"velocity": [2, 0, 1], "gusts": 0.8}, "cloths": [{"grid": [9, 8], "size": [1, 0.8],
         "density": 0.2, "damping": 0.005, "pins": ["top"],
         "stiffness": {"structural": 100, "shear": 30, "bend": 1}}]})",
      "sheet.json", overrides);
  REQUIRE_OK(scene);
  return std::move(*scene);
}

}  // namespace

TEST_CASE(
    "changed gravity, force, drag and wind act from the next frame on as if the scene had begun with them") {
  GpuFixture fixture;
  const std::vector<scene::Override> other = {{"gravity", "[1, -3, 0]"},
                                              {"external_force", "[0, 0, 0.5]"},
                                              {"drag", "2"},
                                              {"wind", R"({"velocity": [0, 0, -3], "gusts": 1})"}};
  auto from_start = world_of(fixture.device(), sheet(other));
  auto changed = world_of(fixture.device(), sheet());
  REQUIRE(changed->change(sheet(other)));
  CHECK(changed->scene().drag == 2);
  // The step need not be the same: it is chosen with the drag of the beginning.
  REQUIRE(changed->substeps() == from_start->substeps());
  advance(*from_start, 6);
  advance(*changed, 6);
  CHECK(hash_of(*changed) == hash_of(*from_start));

  auto later = world_of(fixture.device(), sheet());
  advance(*later, 6);
  const std::string before = hash_of(*later);
  REQUIRE(later->change(sheet(other)));
  CHECK(hash_of(*later) == before);  // the state is left alone
  advance(*later, 1);
  REQUIRE(later->reset());
  advance(*later, 6);
  CHECK(hash_of(*later) == hash_of(*from_start));  // a reset keeps what was changed
}

TEST_CASE("gusts go on from where they are when the wind changes") {
  GpuFixture fixture;
  auto kept = world_of(fixture.device(), sheet()), changed = world_of(fixture.device(), sheet());
  advance(*kept, 9);
  advance(*changed, 9);
  REQUIRE(changed->change(sheet()));
  advance(*kept, 3);
  advance(*changed, 3);
  const auto a = kept->snapshot(), b = changed->snapshot();
  REQUIRE_OK(a);
  REQUIRE_OK(b);
  double most = 0;  // the phase is added up in another order, and the last bit of f32 may fall otherwise
  for (std::size_t i = 0; i < a->position.size(); ++i)
    most = std::max(most, static_cast<double>(length(a->position[i].xyz() - b->position[i].xyz())));
  CHECK(most < 1e-5);
}

TEST_CASE("what shapes the model cannot change, and the message names it") {
  GpuFixture fixture;
  auto world = world_of(fixture.device(), sheet());
  const auto refused = world->change(sheet({{"cloths.0.stiffness.bend", "2"}, {"gravity", "[0, 0, 0]"}}));
  REQUIRE_FALSE(refused);
  CHECK(refused.error().kind == ErrorKind::Input);
  CHECK(refused.error().message ==
        "cloths[0].stiffness cannot change while the cloth moves; load the scene again.");
  CHECK(world->scene().gravity == Vec3d{0, -9.81, 0});
}

TEST_CASE("a drag that would make the running step unstable is refused with both numbers") {
  GpuFixture fixture;
  const scene::Override still{"wind", "{}"};  // at such a drag 2 m/s pull with 30 g
  auto world = world_of(fixture.device(), sheet({still}));
  // h < (√(μ² + 4 λ) - μ) / λ, solved for μ: drag adds to μ.
  const NetworkSpectrum found = world->plan().limit().cloths.at(0);
  const double h = world->step();
  const double most = (4 - h * h * found.stiffness) / (2 * h) - found.damping;
  CHECK(most > 10);
  CHECK(world->change(sheet({still, {"drag", std::to_string(0.999 * most)}})));
  const auto refused = world->change(sheet({still, {"drag", std::to_string(1.001 * most)}}));
  REQUIRE_FALSE(refused);
  CHECK(refused.error().kind == ErrorKind::Limit);
  CHECK(refused.error().message.find("the largest stable step") != std::string::npos);
  CHECK(world->scene().drag == doctest::Approx(0.999 * most));
  advance(*world, 30);
  CHECK(world->totals().nonfinite == 0);
  CHECK(world->totals().max_stretch < 2);
}
