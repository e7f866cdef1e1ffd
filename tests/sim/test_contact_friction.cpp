// Friction of contact is Coulomb's: what it holds does not creep, what it does not hold slides as it should.
#include <cmath>
#include <numbers>
#include <span>

#include "closed_forms/strip_over_capsule.hpp"
#include "contact_laws_rig.hpp"

using namespace weft;

namespace {

/// A sheet on a slope of this part of the angle of friction, with gravity tilted instead.
Setting on_slope(const std::string& solver, const std::string& collider, double part, double friction) {
  const double slope = part * std::atan(friction);
  return {.solver = solver,
          .gravity =
              "[" + text_of(kGravity * std::sin(slope)) + "," + text_of(-kGravity * std::cos(slope)) + ",0]",
          .contact = R"("thickness": 0.005)",
          .cloths = R"({"grid": [4, 4], "size": [0.1, 0.1], "plane": "xz", "density": 0.3, "damping": 0.0003,
      "stiffness": {"structural": 0.5, "shear": 0.1, "bend": 0.003},
      "transform": {"translate": [0.0013, 0.005, 0.0007]}})",
          .colliders = "{" + collider + R"(, "friction": )" + text_of(friction) + "}"};
}

const std::string kFloors[] = {R"("kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0])",
                               R"("kind": "box", "center": [0, -0.1, 0], "size": [4, 0.2, 1])",
                               R"("kind": "mesh", "mesh": "floor.obj")"};

/// So large that the slope is nearly the same under all of a sheet.
const std::string kRound[] = {R"("kind": "sphere", "center": [0, -5, 0], "radius": 5)",
                              R"("kind": "capsule", "a": [0, -5, -1], "b": [0, -5, 1], "radius": 5)"};

/// How fast a sheet creeps at 0.98 of the angle, between two frames [m/s].
double creep_of(gpu::Device& device, const std::string& solver, const std::string& floor, std::uint32_t from,
                std::uint32_t to) {
  auto world = world_on(device, on_slope(solver, floor, 0.98, 0.5), 0.005, 0.2);
  advance(*world, from);
  const double begin = Moment(*world).mean_position().x;
  advance(*world, to - from);
  const double creep = (Moment(*world).mean_position().x - begin) * 60 / (to - from);
  MESSAGE(solver, " ", floor, ": creeps at ", 1e6 * creep, " um/s");
  return std::abs(creep);
}

/// A sheet on a slope of this part of the angle of friction, which is the same between the two, and a smaller one on
/// it, of these densities.
Setting sheet_on_sheet(double part, double lower, double upper) {
  const auto sheet = [](const std::string& grid, const std::string& size, double density,
                        const std::string& height) {
    return R"({"grid": )" + grid + R"(, "size": )" + size + R"(, "density": )" + text_of(density) +
           R"(, "plane": "xz", "damping": 0.02, "friction": 0.5,
      "stiffness": {"structural": 300, "shear": 80, "bend": 2}, "transform": {"translate": [0, )" +
           height + ", 0]}}";
  };
  Setting setting = on_slope("multigrid", kFloors[0], part, 0.5);
  setting.cloths =
      sheet("[9, 9]", "[0.4, 0.4]", lower, "0.005") + "," + sheet("[9, 8]", "[0.3, 0.3]", upper, "0.01");
  return setting;
}
Setting heavy_on_light(double part) { return sheet_on_sheet(part, 0.05, 5); }

/// Of the lower and the upper sheet of these, the mean along the slope.
std::array<double, 2> along_slope(const std::vector<Vec3d>& all) {
  std::array<double, 2> sums{};
  for (std::size_t v = 0; v < all.size(); ++v) sums[v < 81 ? 0 : 1] += all[v].x / (v < 81 ? 81 : 72);
  return sums;
}

}  // namespace

TEST_CASE("what friction holds does not creep") {
  GpuFixture fixture;
  for (const std::string& floor : kFloors)
    CHECK(creep_of(fixture.device(), "mass_spring", floor, 10, 40) < 1e-5);
  // A sheet that begins flat comes down on what is round, and slides a little first.
  for (const std::string solver : {"mass_spring", "multigrid", "vbd", "xpbd"})
    for (const std::string& round : kRound) CHECK(creep_of(fixture.device(), solver, round, 30, 60) < 1e-5);
}
TEST_CASE("long: what friction holds does not creep in ten seconds") {
  GpuFixture fixture;
  for (const std::string solver : kSolvers)
    for (const std::span<const std::string> floors :
         {std::span<const std::string>(kFloors), std::span<const std::string>(kRound)})
      for (const std::string& floor : floors)
        CHECK(creep_of(fixture.device(), solver, floor, 60, 600) < 1e-5);
}

TEST_CASE("what friction does not hold slides with g (sin - friction cos)") {
  GpuFixture fixture;
  const double slope = 1.05 * std::atan(0.5);
  const double exact = kGravity * (std::sin(slope) - 0.5 * std::cos(slope));
  for (const std::string& floor : kFloors) {
    auto world = world_on(fixture.device(), on_slope("mass_spring", floor, 1.05, 0.5), 0.005, 0.3);
    advance(*world, 3);
    const double begin = Moment(*world).mean_velocity().x;
    advance(*world, 15);
    const double found = (Moment(*world).mean_velocity().x - begin) * 4;
    MESSAGE(floor, ": ", found / exact, " of the acceleration");
    CHECK(found == doctest::Approx(exact).epsilon(0.02).scale(0));
  }
}

TEST_CASE(
    "a sheet slides down a slope by g (sin - μ cos), however stiff and light it is, by implicit steps") {
  GpuFixture fixture;
  constexpr double kSlope = 25 * 3.14159265358979 / 180, kFriction = 0.2;
  const double down = kGravity * std::sin(kSlope), into = kGravity * std::cos(kSlope);
  for (const auto& [density, stiffness] :
       {std::pair{1e-4, 2e4}, {3e-4, 2e4}, {1e-3, 2e4}, {0.2, 5e4}, {1e-4, 500.0}}) {
    const std::string k = text_of(stiffness);
    auto world = world_of(
        fixture.device(),
        contact_scene(R"("gravity": [)" + text_of(down) + ", " + text_of(-into) +
                      R"(, 0], "solver": {"kind": "multigrid"}, "time": {"substeps": "auto"},
        "contact": {"method": "proximity", "thickness": 0.005}, "cloths": [{"grid": [14, 14],
        "size": [0.3, 0.3], "plane": "xz", "transform": {"translate": [0, 0.005, 0]}, "density": )" +
                      text_of(density) + R"(, "damping": 0.1, "stiffness": {"structural": )" + k +
                      R"(, "shear": )" + text_of(stiffness / 4) + R"(, "bend": )" + text_of(stiffness / 40) +
                      R"(}}], "colliders": [{"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0],
        "friction": 0.2}])"));
    const Moment start(*world);
    advance(*world, 20);
    const double way = Moment(*world).mean_position().x - start.mean_position().x;
    const double exact = (down - kFriction * into) / 2 / 9;  // after a third of a second
    MESSAGE(density, " kg/m², ", stiffness, " N/m: ", way / exact, " of its way");
    CHECK(way == doctest::Approx(exact).epsilon(0.02).scale(0));
  }
}

TEST_CASE("a sheet that lands on a floor that moves gains of its speed what friction takes of the blow") {
  GpuFixture fixture;
  struct Landing {
    int floor;
    double down, friction, restitution;  // [m/s]
    int substeps;
  };
  constexpr double kFloor = 2;  // [m/s]
  for (const std::string solver : kSolvers)
    for (const Landing& landing :
         {Landing{0, 2, 0.1, 0, 0}, Landing{1, 2, 0.3, 0, 0}, Landing{2, 2, 0.1, 0, 0},
          Landing{0, 0.5, 0.3, 0, 24}, Landing{2, 4, 0.1, 0, 16}, Landing{0, 1, 0.3, 0.5, 0},
          Landing{0, 2, 1.5, 0, 0}}) {
      const std::string rubs = R"(, "friction": )" + text_of(landing.friction) +
                               R"(, "motion": {"kind": "line", "direction": [1, 0, 0], "speed": )" +
                               text_of(kFloor) + "}";
      auto world =
          world_on(fixture.device(),
                   {.solver = solver,
                    .gravity = "[0, 0, 0]",
                    .contact = R"("thickness": 0.005, "restitution": )" + text_of(landing.restitution),
                    .substeps = landing.substeps,
                    .cloths = lying_cloth(5, "[0.0013, 0.1, 0.0007]"),
                    .colliders = "{" + kFloors[landing.floor] + rubs + "}"},
                   0.05, 1.6);
      change_state(*world, [&](std::size_t, Vec3d& place, Vec3d& velocity) {
        place.y =
            0.005 + 1.37 * landing.down / 60;  // more than a frame in the air, a part that no step divides
        velocity = {0, -landing.down, 0};
      });
      advance(*world, 12);
      const Vec3d after = Moment(*world).mean_velocity();
      const double blow = (1 + landing.restitution) * landing.down;
      const double exact = std::min(kFloor, landing.friction * blow);
      MESSAGE(solver, ", ", landing.down, " m/s, friction ", landing.friction, ", ", landing.substeps,
              " substeps: gains ", after.x / exact, " of it, and rises at ", after.y / landing.down);
      CHECK(after.x == doctest::Approx(exact).epsilon(0.02).scale(0));
      CHECK(std::abs(after.y - landing.restitution * landing.down) < 0.02 * landing.down);
    }
}

TEST_CASE(
    "a sheet that lies on another on a slope does not creep, nor does that, and both slide where they "
    "should") {
  GpuFixture fixture;
  const double angle = std::atan(0.5);
  for (const double part : {0.85, 1.1}) {
    auto world = world_on(fixture.device(), sheet_on_sheet(part, 0.2, 0.2));
    if (part < 1) {
      advance(*world, 30);
      const auto begin = along_slope(Moment(*world).position);
      advance(*world, 30);
      const auto end = along_slope(Moment(*world).position);
      MESSAGE("the lower creeps at ", 2e6 * (end[0] - begin[0]), " um/s, the upper at ",
              2e6 * (end[1] - begin[1]));
      for (const std::size_t k : {0U, 1U}) CHECK(std::abs(end[k] - begin[k]) < 0.5 * 1e-5);
    } else {
      const double exact = kGravity * (std::sin(part * angle) - 0.5 * std::cos(part * angle));
      advance(*world, 15);
      const auto begin = along_slope(Moment(*world).velocity);
      advance(*world, 30);
      const auto end = along_slope(Moment(*world).velocity);
      MESSAGE("the lower gains ", 2 * (end[0] - begin[0]) / exact, " of the acceleration, the upper ",
              2 * (end[1] - begin[1]) / exact);
      for (const std::size_t k : {0U, 1U})
        CHECK(2 * (end[k] - begin[k]) == doctest::Approx(exact).epsilon(0.02).scale(0));
    }
  }
}

TEST_CASE(
    "two cloths have the mean of their friction, whichever lies above and whichever the scene names first") {
  GpuFixture fixture;
  const double friction = std::sqrt(0.5 * 0.2), slope = std::atan(0.4);
  std::string cloths;
  for (int pair = 0; pair < 4; ++pair) {
    const std::string more = R"(, "plane": "xz", "density": 0.3, "damping": 0.01,
        "stiffness": {"structural": 60, "shear": 12, "bend": 0.5}, "friction": )";
    const std::string at = R"(, "transform": {"translate": [0, )",
                      aside = ", " + std::to_string(3 * pair) + "]}";
    const bool rough_above = pair % 2 == 0, above_first = pair < 2;
    const std::string above = R"({"grid": [6, 6], "size": [0.25, 0.25])" + at + "0.005" + aside + more +
                              (rough_above ? "0.5}" : "0.2}");
    const std::string below = R"({"grid": [11, 11], "size": [0.5, 0.5])" + at + "0" + aside + more +
                              (rough_above ? "0.2" : "0.5") +
                              R"(, "pins": [{"box": {"min": [-9, -9, -9], "max": [9, 9, 99]}}]})";
    cloths += (pair > 0 ? "," : "") + (above_first ? above + "," + below : below + "," + above);
  }
  const scene::Scene scene = scene_of(Setting{.solver = "mass_spring",
                                              .gravity = "[" + text_of(kGravity * std::sin(slope)) + ", " +
                                                         text_of(-kGravity * std::cos(slope)) + ", 0]",
                                              .contact = R"("thickness": 0.005)",
                                              .substeps = 32,
                                              .cloths = cloths});
  auto world = world_of(fixture.device(), scene);
  const int frames = 20;
  advance(*world, frames);
  const Moment moment(*world);
  const double expected = kGravity * (std::sin(slope) - friction * std::cos(slope)) * frames / 60;
  for (const Body& body : world->model().host.bodies) {
    if (body.vertex_count != 36) continue;
    double speed = 0;
    for (std::uint32_t v = 0; v < 36; ++v) speed += moment.velocity[body.first_vertex + v].x / 36;
    CHECK(speed == doctest::Approx(expected).epsilon(0.02).scale(0));
  }
}

TEST_CASE("a heavy sheet and the light one under it do not creep on a slope") {
  GpuFixture fixture;
  auto world = world_on(fixture.device(), heavy_on_light(0.9));
  advance(*world, 8);
  const auto begin = along_slope(Moment(*world).position);
  advance(*world, 6);
  const auto end = along_slope(Moment(*world).position);
  MESSAGE("the light one creeps at ", 1e7 * (end[0] - begin[0]), " um/s, the heavy one at ",
          1e7 * (end[1] - begin[1]));
  for (const std::size_t k : {0U, 1U}) CHECK(std::abs(end[k] - begin[k]) < 0.1 * 1e-5);
}

TEST_CASE(
    "long: a heavy sheet and the light one under it hold at 0.98 of the angle, and slide together beyond "
    "it") {
  GpuFixture fixture;
  for (const double part : {0.98, 1.05, 1.1}) {
    auto world = world_on(fixture.device(), heavy_on_light(part));
    advance(*world, part < 1 ? 60 : 15);
    const Moment begin(*world);
    advance(*world, 30);
    const Moment end(*world);
    const auto x0 = along_slope(begin.position), x1 = along_slope(end.position);
    const auto v0 = along_slope(begin.velocity), v1 = along_slope(end.velocity);
    const double slope = part * std::atan(0.5);
    const double exact = kGravity * (std::sin(slope) - 0.5 * std::cos(slope));
    for (const std::size_t k : {0U, 1U}) {
      MESSAGE(part, ": ", 2e6 * (x1[k] - x0[k]), " um/s, ", 2 * (v1[k] - v0[k]) / exact,
              " of the acceleration");
      if (part < 1) CHECK(std::abs(x1[k] - x0[k]) < 0.5 * 1e-5);
      if (part > 1) CHECK(2 * (v1[k] - v0[k]) == doctest::Approx(exact).epsilon(0.02).scale(0));
    }
  }
}

TEST_CASE("a strip over a capsule holds up to the ratio of its ends that friction says, and slides beyond") {
  // With its own weight on the arc, R from its middle: L' = (L + c) e^(mu pi) + c, c = 2 mu R / (1 + mu²).
  constexpr double kFriction = 0.3, kLeft = 0.1, kRadius = 0.052;
  const double c = 2 * kFriction * kRadius / (1 + kFriction * kFriction);
  const double most = (kLeft + c) * std::exp(kFriction * std::numbers::pi) + c;
  GpuFixture fixture;
  // Light, so that weak springs hold it and 48 substeps are stable.
  for (const double part : {0.9, 1.05}) {
    const double middle =
        kRadius * std::cos(std::numbers::pi / 32);  // of an edge, where nodes lie on the capsule
    const StripOverCapsule strip({kLeft, part * most, middle, kFriction, 0.981}, 16, 0.2 / 36);
    Setting setting{.gravity = "[0, -0.981, 0]", .contact = R"("thickness": 0.002)", .substeps = 48};
    setting.cloths = R"({"grid": [)" + std::to_string(strip.rows()) + R"(, 3], "size": [)" +
                     text_of(strip.cell() * (strip.rows() - 1)) +
                     R"(, 0.02], "plane": "xz", "density": 0.2,
      "damping": 0.001, "friction": 0.3, "stiffness": {"structural": 30, "shear": 6, "bend": 0.05}})";
    setting.colliders = R"({"kind": "capsule", "a": [0, 0, -0.2], "b": [0, 0, 0.2], "radius": 0.05})";
    auto world = world_on(fixture.device(), setting);
    change_state(*world, [&](std::size_t, Vec3d& x, Vec3d&) { x = strip.draped(x); });
    advance(*world, part < 1 ? 90 : 12);
    const double begin = Moment(*world).position.front().y;
    advance(*world, 18);
    const double gone = Moment(*world).position.front().y - begin;  // of the short end, up
    MESSAGE(part, " of the ratio that friction holds: goes ", 1e3 * gone, " mm in 0.3 s");
    if (part < 1)
      CHECK(std::abs(gone) < 0.3 * 1e-5);  // m/s: no creep
    else
      CHECK(gone > 0.5 * (strip.rope().way(0.5) - strip.rope().way(0.2)));
  }
}
