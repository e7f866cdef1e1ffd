// Cloth that flies in its own plane: its open patches are not searched, and do not fold where something stops them.
#include "contact_rig.hpp"

using namespace weft;

namespace {

/// A sheet of squares of about 25 mm in xz.
std::string grid_cloth(const std::string& grid, const std::string& size, const std::string& translate) {
  return R"({"grid": )" + grid + R"(, "size": )" + size +
         R"(, "plane": "xz", "density": 0.3, "damping": 0.01,
    "stiffness": {"structural": 40, "shear": 10, "bend": 0.3}, "transform": {"translate": )" +
         translate + "}}";
}
std::string flight_text(const std::string& solver, const std::string& more = "") {
  return R"("solver": {"kind": ")" + solver + R"("}, "time": {"substeps": )" +
         (solver == "mass_spring" ? "16" : "8") +
         R"(}, "contact": {"method": "proximity", "thickness": 0.008)" + more + "}, ";
}
constexpr const char* kBothSolvers[] = {"mass_spring", "multigrid"};

struct Flight {
  std::uint32_t bad = 0;  // frames in which something had passed through something
  std::uint64_t contacts = 0, truncated = 0;
};
Flight fly(sim::World& world, std::uint32_t frames) {
  Flight flight;
  for (std::uint32_t frame = 0; frame < frames; ++frame) {
    advance(world, 1);
    flight.bad += passed(world) != 0 ? 1 : 0;
  }
  const Totals& totals = world.totals();
  CHECK(totals.crossings == 0);
  flight.contacts = totals.contacts;
  flight.truncated = totals.truncated;
  MESSAGE("contacts ", totals.contacts, ", pairs ", totals.pairs, ", truncated ", totals.truncated,
          ", stretch ", totals.max_stretch);
  return flight;
}

}  // namespace

TEST_CASE(
    "a sheet that flies in its plane at 10 m/s lists no pair of itself, and flies as one that cannot meet "
    "itself") {
  GpuFixture fixture;
  for (const char* solver : kBothSolvers) {
    CAPTURE(solver);
    std::vector<Moment> ends;
    for (const char* self : {"true", "false"}) {
      auto world =
          world_of(fixture.device(),
                   contact_scene(flight_text(solver, std::string(R"(, "self": )") + self) + R"("cloths": [)" +
                                 grid_cloth("[25,17]", "[0.6,0.4]", "[0, 0, 0]") + "]"));
      push(*world, 0, 25 * 17, {8, 0, 6});
      fly(*world, 6);
      CHECK(world->totals().pairs == 0);
      CHECK(world->totals().candidates == 0);
      CHECK(world->totals().truncated == 0);
      ends.emplace_back(*world);
    }
    double most = 0;
    for (std::size_t v = 0; v < ends[0].position.size(); ++v)
      most = std::max(most, length(ends[0].position[v] - ends[1].position[v]));
    CHECK(most < 1e-6);
  }
}

TEST_CASE(
    "a sheet that flies in its plane against a wall, and into a corner of it, passes nowhere through "
    "itself") {
  GpuFixture fixture;
  for (const char* solver : kBothSolvers)
    for (const double speed : {5.0, 20.0})
      for (const char* wall : {R"("kind": "box", "center": [0.5, 0, 0], "size": [0.3, 0.6, 1])",
                               R"("kind": "box", "center": [0.5, 0, 0.3], "size": [0.3, 0.6, 0.5])"}) {
        CAPTURE(solver);
        CAPTURE(speed);
        CAPTURE(wall);
        auto world =
            world_of(fixture.device(),
                     contact_scene(R"("gravity": [0, 0, 0], )" + flight_text(solver) + R"("cloths": [)" +
                                   grid_cloth("[25,17]", "[0.6,0.4]", "[0, 0, 0]") + R"(], "colliders": [{)" +
                                   wall + "}]"));
        push(*world, 0, 25 * 17, {speed, 0, 0});
        const Flight flight = fly(*world, 10);
        CHECK(flight.bad == 0);
        CHECK(flight.contacts > 10);
      }
}

TEST_CASE(
    "a vertex that is shot along its sheet folds no triangle, and nothing is held back nor loses momentum") {
  GpuFixture fixture;
  constexpr std::size_t kShot = 8 * 25 + 12;
  // By 1.2 edges in the substeps of explicit steps from one search to the next, of which the first sees no
  // fold; and by 1.4 in an implicit one.
  for (const char* solver : kBothSolvers) {
    CAPTURE(solver);
    const bool is_explicit = std::string(solver) == "mass_spring";
    for (const Vec3d& direction : {Vec3d{17, 0, 0}, Vec3d{0, 0, -17}, Vec3d{-12, 0, 12}, Vec3d{11, 0, 13}}) {
      CAPTURE(direction.x);
      const char* time =
          is_explicit ? R"({"frame": 0.004, "substeps": 4})" : R"({"frame": 0.002, "substeps": 1})";
      auto world = world_of(
          fixture.device(),
          contact_scene(std::string(R"("solver": {"kind": ")") + solver + R"("}, "time": )" + time +
                        R"(, "gravity": [0, 0, 0], "contact": {"method": "proximity", "thickness": 0.008},
        "cloths": [{"grid": [25, 17], "size": [0.6, 0.4], "plane": "xz", "density": 0.3, "damping": 0,
          "stiffness": {"structural": 0.4, "shear": 0.1, "bend": 0}}])"));
      const Vec3d velocity = (is_explicit ? 0.42 : 1.0) * direction;
      change_state(*world,
                   [&](std::size_t node, Vec3d&, Vec3d& v) { v = node == kShot ? velocity : Vec3d{}; });
      const Moment start(*world);
      const double energy = energy_of(*world, start);
      advance(*world, 1);
      const Moment end(*world);
      CHECK(world->totals().truncated == 0);
      CHECK(world->totals().slowed == 0);
      CHECK(passed(*world) == 0);
      const Vec3d momentum = start.momentum(0, 25 * 17);
      CHECK(length(end.momentum(0, 25 * 17) - momentum) < 1e-4 * length(momentum));
      CHECK(energy_of(*world, end) <= energy * (1 + 1e-6));
    }
  }
}

TEST_CASE("what flies into something that stands loses time, and not the speed of all that flies behind it") {
  GpuFixture fixture;
  // One vertex is pinned; all others fly along the sheet by 1.2 to 1.7 of its edges a substep. The scene has substeps
  // of that length, one a frame, or frames are cut to it, for a ball that goes past far away.
  constexpr std::uint32_t kCorner = 65 * 33 - 1;
  double lost = 0;  // s
  for (const auto& [speed, is_cut] : {std::pair{14.0, false},
                                      {15.0, false},
                                      {16.0, false},
                                      {17.0, false},
                                      {18.0, false},
                                      {19.0, false},
                                      {20.0, false},
                                      {14.0, true},
                                      {17.0, true},
                                      {20.0, true}}) {
    CAPTURE(speed);
    CAPTURE(is_cut);
    const double frame = is_cut ? 0.025 / 3 : 0.00625 / 3;
    auto world =
        world_of(fixture.device(),
                 contact_scene(R"("solver": {"kind": "multigrid"}, "time": {"substeps": 1, "frame": )" +
                               std::to_string(frame) + R"(},
    "gravity": [0, 0, 0], "contact": {"method": "proximity", "thickness": 0.008},
    "cloths": [{"grid": [65, 33], "size": [1.6, 0.8],
      "plane": "xz", "density": 0.3, "damping": 0, "pins": [{"nodes": [1072]}],
      "stiffness": {"structural": 4, "shear": 1, "bend": 0}}],
    "colliders": [{"kind": "sphere", "center": [0, -9, 0], "radius": 0.1,
      "motion": {"kind": "line", "direction": [1, 0, 0], "speed": )" +
                               (is_cut ? "7.6" : "0.1") + "}}]"));
    push(*world, 0, 65 * 33, {speed, 0, 0});
    const Moment start(*world);
    for (double time = 0; time < 0.008; time += frame) {
      advance(*world, 1);
      CHECK(passed(*world) == 0);
    }
    const Totals& totals = world->totals();
    const Moment end(*world);
    const double flown = (end.position[kCorner] - start.position[kCorner]).x / speed;  // s
    MESSAGE("truncated ", totals.truncated, ", slowed ", totals.slowed, " by ", totals.delay_s, " s, flown ",
            flown, " s");
    lost += totals.delay_s;
    CHECK(flown + totals.delay_s == doctest::Approx(totals.frames * frame).epsilon(3e-4).scale(0));
    std::size_t slower = 0;
    for (const Vec3d& v : end.velocity) slower += v.x < 0.9 * speed ? 1 : 0;
    MESSAGE(slower, " vertices are slower");  // held back alone, all that fly are
    CHECK(static_cast<double>(slower) < 0.1 * static_cast<double>(end.velocity.size()));
  }
  REQUIRE(lost > 0.005);
}

TEST_CASE("two sheets that fly into each other edge on pass through nothing") {
  GpuFixture fixture;
  for (const char* solver : kBothSolvers)
    for (const double speed : {2.0, 10.0}) {
      CAPTURE(solver);
      CAPTURE(speed);
      auto world =
          world_of(fixture.device(),
                   contact_scene(R"("gravity": [0, 0, 0], )" + flight_text(solver) + R"("cloths": [)" +
                                 grid_cloth("[25,17]", "[0.6,0.4]", "[0, 0, 0]") + "," +
                                 grid_cloth("[20,15]", "[0.5,0.36]", "[0.6, 0.002, 0.013]") + "]"));
      push(*world, 0, 25 * 17, {speed, 0, 0});
      push(*world, 25 * 17, 25 * 17 + 20 * 15, {-speed, 0, 0});
      const Flight flight = fly(*world, 10);
      CHECK(flight.bad == 0);
      CHECK(flight.contacts > 10);
    }
}

TEST_CASE("a sheet of two layers and the fold between them flies in its plane, and its layers stay apart") {
  GpuFixture fixture;
  for (const char* solver : kBothSolvers) {
    CAPTURE(solver);
    auto world = world_of(fixture.device(),
                          contact_scene(R"("gravity": [0, 0, 0], )" + flight_text(solver) + R"("cloths": [)" +
                                        grid_cloth("[33,17]", "[0.8,0.4]", "[0, 0, 0]") + "]"));
    change_state(*world, [](std::size_t, Vec3d& x, Vec3d& v) {
      // Half a circle of 0.1 m between the layers, which are a quarter of that apart where they end.
      const double bend = 0.1, radius = bend / std::acos(-1.0), along = x.x;
      const double angle = std::clamp((along + 0.5 * bend) / radius, 0.0, std::acos(-1.0));
      const double straight = std::max(0.0, std::abs(along) - 0.5 * bend);
      x = {radius * std::sin(angle) - straight, -radius * std::cos(angle) * (1 - 1.5 * straight), x.z};
      v = {6, 0, 8};
    });
    const Flight flight = fly(*world, 10);
    CHECK(flight.bad == 0);
    CHECK(flight.truncated == 0);
  }
}
