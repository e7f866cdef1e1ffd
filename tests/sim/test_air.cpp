// Worlds with air: what they change while they run, and cloth that lies on a floor in the wind.
#include <cmath>

#include "contact_rig.hpp"

using namespace weft;

namespace {

scene::Scene sheet(const std::vector<scene::Override>& overrides) {
  auto scene = scene::parse_scene(
      R"({"format": "weft-scene/1", "solver": {"kind": "mass_spring"}, "contact": {"method": "none"},
         "time": {"substeps": 32}, "wind": {"velocity": [2, 0, 1], "gusts": 0.8},
         "cloths": [{"grid": [9, 8], "size": [1, 0.8],
         "density": 0.2, "damping": 0.005, "pins": ["top"],
         "stiffness": {"structural": 100, "shear": 30, "bend": 1}}]})",
      "sheet.json", overrides);
  REQUIRE_OK(scene);
  return std::move(*scene);
}

}  // namespace

TEST_CASE(
    "air that changes acts from the next frame on as if the scene had begun with it; to begin it is "
    "refused") {
  GpuFixture fixture;
  const std::string solvers[] = {R"({"kind": "mass_spring"})", R"({"kind": "multigrid"})",
                                 R"({"kind": "xpbd"})"};
  for (const std::string& solver : solvers) {
    CAPTURE(solver);
    const auto with = [&](const std::string& air) {
      std::vector<scene::Override> all = {{"solver", solver}};
      if (!air.empty()) all.push_back({"air", air});
      return sheet(all);
    };
    const std::string other = R"({"density": 2, "lift": 0.5, "friction": 0.2})";
    auto from_start = world_of(fixture.device(), with(other));
    auto changed = world_of(fixture.device(), with("{}"));
    REQUIRE(changed->change(with(other)));
    advance(*from_start, 6);
    advance(*changed, 6);
    CHECK(hash_of(*changed) == hash_of(*from_start));

    auto none = world_of(fixture.device(), with(""));
    const auto refused = none->change(with("{}"));
    REQUIRE_FALSE(refused);
    CHECK(refused.error().message == "air cannot change while the cloth moves; load the scene again.");
    // Air of nothing is none, but for the rounding of what is added once more.
    auto empty = world_of(fixture.device(), with(R"({"density": 0})"));
    advance(*none, 6);
    advance(*empty, 6);
    const Moment a(*none), b(*empty);
    double most = 0;
    for (std::size_t n = 0; n < a.position.size(); ++n)
      most = std::max(most, length(a.position[n] - b.position[n]));
    CHECK(most < 1e-4);
    CHECK(hash_of(*none) != hash_of(*from_start));
  }
}

TEST_CASE(
    "a sheet on a floor slides in the wind by the air's friction less the floor's, and lies still below it") {
  GpuFixture fixture;
  // ½ ρ C_F U² by the mass of an area, 4.32 m/s², against μ g of 2.94 and 4.91.
  const double pull = 0.5 * 1.2 * 0.02 * 6 * 6 / 0.1;
  for (const char* solver : {"mass_spring", "multigrid"})
    for (const double friction : {0.3, 0.5}) {
      CAPTURE(std::string(solver));
      CAPTURE(friction);
      const scene::Scene scene = contact_scene(
          R"("solver": {"kind": ")" + std::string(solver) + R"("}, "time": {"substeps": 8},
             "wind": {"velocity": [6, 0, 0]}, "air": {"density": 1.2, "friction": 0.02, "lift": 0, "pressure": 0},
             "contact": {"method": "proximity", "thickness": 0.01}, "cloths": [{"grid": [9, 9], "size": [0.4, 0.4],
             "plane": "xz", "density": 0.1, "damping": 0.01, "friction": )" +
          text_of(friction) +
          R"(, "stiffness": {"structural": 20, "shear": 5, "bend": 0.2}, "transform": {"translate": [0, 0.01, 0]}}],
             "colliders": [{"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0]}])");
      auto world = world_of(fixture.device(), scene);
      advance(*world, 12);  // until it bears
      const Vec3d begun = Moment(*world).mean_velocity();
      advance(*world, 18);
      const Moment now(*world);
      const double gained = now.mean_velocity().x - begun.x, time = 18.0 / 60;
      // The wind over the sheet falls by its own speed, at most 0.7 m/s of 6: the pull by a fifth.
      const double most = (pull - friction * kGravity) * time;
      const double least = (0.78 * pull - friction * kGravity) * time;
      if (friction < 0.4) {
        CHECK(gained < 1.02 * most);
        CHECK(gained > least);
      } else {
        CHECK(std::abs(now.mean_velocity().x) < 1e-3);
      }
    }
}
