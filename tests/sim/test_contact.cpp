// Contact by proximity against closed forms: stick, slide, bounce, rest, keep momentum.
#include <cmath>

#include "contact/reference/proximity/respond.hpp"
#include "contact/rules/contact_law.hpp"
#include "contact_rig.hpp"
#include "method/method.hpp"

using namespace weft;

namespace {

constexpr double kGravity = 9.81;
constexpr double kStepRounding = 3 * 0x1p-23;  // of a velocity in a substep, below 2 m/s: two sums of f32,
                                               // and contact's changes in units of 2^-22 m/s

scene::Scene incline(double friction, double slope, const std::string& solver) {
  const auto text = [](double value) { return std::to_string(value); };
  return shipped_scene("incline", {scene::override_solver(solver),
                                   {"cloths.0.grid", "[6,6]"},
                                   {"colliders.0.friction", text(friction)},
                                   {"gravity", "[" + text(kGravity * std::sin(slope)) + "," +
                                                   text(-kGravity * std::cos(slope)) + ",0]"}});
}

void check_sticks(double slope, std::uint32_t frames, const std::string& solver = "mass_spring") {
  CAPTURE(solver);
  CAPTURE(slope);
  GpuFixture fixture;
  auto world = world_of(fixture.device(), incline(0.5, slope, solver));
  advance(*world, 30);
  const Moment before(*world);
  advance(*world, frames);
  const Moment after(*world);
  double creep = 0;
  for (std::size_t i = 0; i < before.position.size(); ++i)
    creep = std::max(creep, length(after.position[i] - before.position[i]));
  MESSAGE("creep ", creep, " m, speed ", after.largest_speed(), " m/s");
  CHECK(creep < 1e-4);
}

void check_slides(const std::string& solver) {
  CAPTURE(solver);
  GpuFixture fixture;
  const double degree = std::acos(-1.0) / 180;
  for (const auto& [friction, slope] : {std::pair{0.3, 20 * degree}, {0.5, 30 * degree}}) {
    CAPTURE(friction);
    auto world = world_of(fixture.device(), incline(friction, slope, solver));
    advance(*world, 15);
    const double before = Moment(*world).mean_velocity().x;
    advance(*world, 30);
    const double after = Moment(*world).mean_velocity().x;
    CHECK((after - before) / 0.5 ==
          doctest::Approx(kGravity * (std::sin(slope) - friction * std::cos(slope))).epsilon(0.005).scale(0));
  }
}

constexpr const char* kPlane = R"({"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0]})";

/// The speed after a bounce of one node, by the reference.
double bounced(double height, double speed, double thickness, double restitution, double dt) {
  double v = -speed;
  const double inverse_mass = 1;
  for (int step = 0; step < 2000; ++step) {
    const reference::NearPair pair{1, {0}, {1}, {0, 1, 0}, height, thickness, 0};
    const Vec3d velocity{0, v, 0};
    v += reference::respond({&pair, 1}, {&velocity, 1}, {&inverse_mass, 1}, {dt, restitution}).change[0].y;
    height += dt * v;
  }
  return v;
}

}  // namespace

TEST_CASE("long: on an incline just below the angle of friction a sheet does not creep in a minute") {
  for (const double part : {0.5, 0.9, 0.98}) check_sticks(part * std::atan(0.5), 3600);
}

TEST_CASE(
    "on an incline just below the angle of friction a sheet of no method creeps in five seconds, or ten") {
  for (const Method& method : methods())
    check_sticks(0.98 * std::atan(0.5), method.kind == scene::SolverKind::MassSpring ? 600 : 300,
                 scene::name_of(method.kind));
}

TEST_CASE("above the angle of friction a sheet of every method slides with g (sin - friction cos)") {
  for (const Method& method : methods()) check_slides(scene::name_of(method.kind));
}

TEST_CASE("the numbers of contacts for pictures are those of the listed pairs, also when lists have grown") {
  GpuFixture fixture;
  auto world = world_of(fixture.device(),
                        shipped_scene("stack", {{"cloths.0.grid", "[8,8]"}, {"cloths.0.copies.count", "3"}}),
                        {.contact_room = ContactRoom{500, 500, 100000}});
  REQUIRE(world->count_contacts(true));
  advance(*world, 10);
  REQUIRE(world->totals().repeated_frames > 0);
  const auto counts = gpu::download(fixture.device(), *world->contact_counts());
  REQUIRE_OK(counts);
  // A vertex at the thickness above the floor is in one pair at least; a corner of the upper sheet may be in
  // none.
  double sum = 0;
  for (const float count : *counts) {
    CHECK(count == std::floor(count));
    sum += static_cast<double>(count);
  }
  CHECK(sum > 3 * 64);
  REQUIRE(world->count_contacts(false));
  const std::string hash = hash_of(*world);
  REQUIRE(world->reset());
  advance(*world, 10);
  CHECK(hash_of(*world) == hash);  // to count changes nothing
  const auto kept = gpu::download(fixture.device(), *world->contact_counts());
  REQUIRE_OK(kept);
  CHECK(*kept == *counts);  // nobody has counted since
}

TEST_CASE("two sheets that meet in free space keep their momentum") {
  GpuFixture fixture;
  auto world = world_of(fixture.device(), contact_scene(R"("gravity": [0, 0, 0], "time": {"substeps": 6},
    "contact": {"method": "proximity", "thickness": 0.01}, "cloths": [)" +
                                                        lying_cloth(8, "[0, 0, 0]") + "," +
                                                        lying_cloth(7, "[0.03, 0.04, 0.02]") + "]"));
  push(*world, 64, 113, {0.2, -1, 0.1});
  const Vec3d start = Moment(*world).momentum(0, 113);
  advance(*world, 30);
  const Moment now(*world);
  const Vec3d end = now.momentum(0, 113);
  double mass = 0;
  for (const double m : now.mass) mass += m;
  MESSAGE("change ", length(end - start), " of ", length(start), " kg m/s, truncated ",
          world->totals().truncated);
  CHECK(length(end - start) < 30 * 8 * kStepRounding * mass);
  CHECK(now.momentum(0, 64).y < 0.4 * start.y);  // half of it, as what sticks has one velocity
  CHECK(world->totals().truncated == 0);         // truncation does not keep momentum
  CHECK(passed(*world) == 0);
}

TEST_CASE("a sheet that has fallen on a plane lies at the thickness and does not move") {
  GpuFixture fixture;
  auto world = world_of(fixture.device(),
                        contact_scene(R"("time": {"substeps": 6},
    "contact": {"method": "proximity", "thickness": 0.01}, "cloths": [)" +
                                      lying_cloth(6, "[0, 0.1, 0]") + R"(], "colliders": [)" + kPlane + "]"));
  advance(*world, 120);
  const Moment now(*world);
  double off = 0;
  for (const Vec3d& p : now.position) off = std::max(off, std::abs(p.y - 0.01));
  MESSAGE("off by ", off, " m, speed ", now.largest_speed(), " m/s");
  CHECK(off < 1e-3 * 0.01);
  CHECK(now.largest_speed() < 1e-5);
}

TEST_CASE("a patch bounces off a plane as the reference's law says, near to its restitution") {
  GpuFixture fixture;
  for (const double restitution : {0.0, 0.5}) {
    CAPTURE(restitution);
    // Three at once, which begin at different parts of a substep's way above the plane.
    const double heights[] = {0.05, 0.0503, 0.0509};
    std::string cloths;
    for (const double height : heights)
      cloths += (cloths.empty() ? "" : ",") +
                lying_cloth(2, "[0, " + std::to_string(height) + ", 0]", R"(, "friction": 0)");
    auto world =
        world_of(fixture.device(), contact_scene(R"("gravity": [0, 0, 0], "time": {"substeps": 16}, "contact":
        {"method": "proximity", "thickness": 0.01, "self": false, "restitution": )" +
                                                 std::to_string(restitution) + R"(}, "cloths": [)" + cloths +
                                                 R"(], "colliders": [)" + kPlane + "]"));
    push(*world, 0, 12, {0, -1, 0});
    advance(*world, 10);
    const Moment now(*world);
    for (std::size_t k = 0; k < 3; ++k) {
      const double exact = bounced(heights[k], 1, 0.01, restitution, world->step());
      for (std::size_t node = 4 * k; node < 4 * k + 4; ++node)
        CHECK(std::abs(now.velocity[node].y - exact) < 1e-5);  // the rounding of some ten substeps
      // An angle of √β = 1/2 a substep makes half a swing about six substeps, met at any part of one.
      CHECK(std::abs(exact - restitution) < 0.05);
    }
  }
}
