// Layers of cloth pass their weight on, and nothing through each other.
#include <cmath>

#include "contact_laws_rig.hpp"

using namespace weft;

// ---- Stacks

TEST_CASE("long: sixteen layers at rest are as thick as they should be, and each bears what lies on it") {
  GpuFixture fixture;
  for (const std::string solver : kSolvers) {
    auto world = world_of(fixture.device(),
                          shipped_scene("stack", {{"cloths.0.grid", "[6,6]"},
                                                  {"cloths.0.copies.offset", "[0.004, 0.006, 0.003]"},
                                                  {"solver.kind", "\"" + solver + "\""}}));
    advance(*world, 180);
    const Moment now(*world);
    const double weight = kGravity * total(now.mass);
    const Forces forces = forces_of(*world, 36);
    double worst = 0;
    for (std::size_t k = 0; k + 1 < 16; ++k)
      worst = std::max(worst, std::abs(forces.up[k] / weight - (15 - static_cast<double>(k)) / 16));
    MESSAGE(solver, ": top layer at ", 1e3 * mean_height(now, 540, 576), " mm, the floor bears ",
            forces.ground.y / weight, " of the weight, between layers off by ", worst, ", largest speed ",
            now.largest_speed());
    CHECK(mean_height(now, 540, 576) > 0.07);
    // The implicit solver's own hold bears the lowest layer, which no pair's force knows of.
    if (solver == "mass_spring") CHECK(forces.ground.y == doctest::Approx(weight).epsilon(0.02).scale(0));
    CHECK(worst < 0.02);
  }
}

TEST_CASE("long: fifty layers at rest are four fifths as thick as they would be without weight") {
  GpuFixture fixture;
  for (const std::string solver : kSolvers) {
    auto world = world_of(fixture.device(),
                          shipped_scene("stack", {{"cloths.0.grid", "[3,3]"},
                                                  {"cloths.0.copies.count", "50"},
                                                  {"cloths.0.copies.offset", "[0.001, 0.005, 0.001]"},
                                                  {"time.substeps", "60"},
                                                  {"solver.kind", "\"" + solver + "\""}}));
    advance(*world, 90);
    const Moment now(*world);
    const double top = mean_height(now, 49 * 9, 50 * 9);
    MESSAGE(solver, ": top layer at ", 1e3 * top, " mm, largest speed ", now.largest_speed());
    CHECK(top > 0.8 * 50 * 0.005);
    CHECK(top < 1.04 * 50 * 0.005);
  }
}

TEST_CASE("long: layers that are pressed by eight times their weight keep four fifths of their thickness") {
  GpuFixture fixture;
  auto world = world_of(fixture.device(),
                        shipped_scene("stack", {{"cloths.0.grid", "[5,5]"},
                                                {"cloths.0.size", "[0.12, 0.12]"},
                                                {"cloths.0.copies.count", "16"},
                                                {"cloths.0.copies.offset", "[0.0005, 0.007, 0.0007]"},
                                                {"gravity", "[0, -80, 0]"},
                                                {"time.substeps", "48"}}));
  advance(*world, 40);
  const double top = mean_height(Moment(*world), 15 * 25, 16 * 25);
  MESSAGE("top layer at ", 1e3 * top, " mm");
  CHECK(top > 0.8 * 16 * 0.005);
  CHECK(top < 1.04 * 16 * 0.005);
}

// ---- No passing through

namespace {

/// A ball that is shot through layers 21 mm apart, in zero gravity.
void check_shot(gpu::Device& device, const std::string& solver, int layers, double speed) {
  const double way = 0.1 + 0.021 * layers + 0.1;
  const int part = speed >= 10 ? 4 : 1;
  Setting setting{.solver = solver, .gravity = "[0, 0, 0]", .substeps = 8 / part, .part = part};
  for (int k = 0; k < layers; ++k)
    setting.cloths += (k > 0 ? "," : "") + lying_cloth(8, "[0, " + text_of(0.021 * k) + ", 0]");
  setting.colliders = R"({"kind": "sphere", "center": [0.013, -0.095, 0.007], "radius": 0.08,
      "motion": {"kind": "line", "direction": [0, 1, 0], "speed": )" +
                      text_of(speed) + R"(, "distance": )" + text_of(way) + "}}";
  auto world = world_on(device, setting);
  const int frames = static_cast<int>(std::ceil(way / speed * 60 * part)) + 4;
  std::size_t crossings = 0, inside = 0;
  for (int frame = 0; frame < frames; ++frame) {
    advance(*world, 1);
    const Moment now(*world);
    REQUIRE(now.finite());
    const std::size_t tangled = tangles(*world, now);
    crossings = std::max(crossings, tangled);
    inside = std::max(inside, passed(*world, now, {}) - tangled);
  }
  MESSAGE(solver, " ", layers, " layers, ", speed, " m/s: ", crossings, " crossings, ", inside,
          " vertices in the ball, truncated ", world->totals().truncated, ", driven ",
          world->totals().driven);
  CHECK(crossings == 0);
}

}  // namespace

TEST_CASE("two layers that a ball is shot into do not pass through each other") {
  GpuFixture fixture;
  for (const std::string solver : kSolvers)
    for (const double speed : {3.0, 30.0}) check_shot(fixture.device(), solver, 2, speed);
}
TEST_CASE("long: layers that a ball is shot into do not pass through each other") {
  GpuFixture fixture;
  for (const std::string solver : kSolvers)
    for (const int layers : {2, 4, 8})
      for (const double speed : {1.0, 3.0, 10.0, 30.0}) check_shot(fixture.device(), solver, layers, speed);
}

TEST_CASE(
    "long: a ball that flies into two sheets that hang by their corners pulls neither through the other") {
  GpuFixture fixture;
  for (const std::string solver : kSolvers) {
    auto world = world_of(fixture.device(),
                          shipped_scene("shot", {{"cloths.0.grid", "[14,14]"},
                                                 {"cloths.0.copies", R"({"count":2,"offset":[0,0,0.02]})"},
                                                 {"solver.kind", "\"" + solver + "\""},
                                                 {"colliders.0.motion.start", "0"},
                                                 {"colliders.0.center", "[0.08, 0, -0.4]"}}));
    std::size_t crossings = 0;
    for (int frame = 0; frame < 20; ++frame) {
      advance(*world, 1);
      const Moment now(*world);
      crossings = std::max(crossings, tangles(*world, now));
    }
    MESSAGE(solver, ": ", crossings, " crossings, truncated ", world->totals().truncated);
    CHECK(crossings == 0);
  }
}
