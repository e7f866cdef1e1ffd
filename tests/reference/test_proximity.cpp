// Scenes with contact "proximity", in double: rest, friction, obstacles that move, and that nothing passes.
#include <cmath>

#include "contact/reference/proximity/audit.hpp"
#include "contact/rules/contact_law.hpp"
#include "mesh/primitives.hpp"
#include "rig.hpp"

using namespace weft;

namespace {

constexpr double kGravity = 9.81;

Vec3d mean(const std::vector<Vec3d>& values) {
  Vec3d sum;
  for (const Vec3d& v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

double lowest(const std::vector<Vec3d>& positions) {
  double least = positions[0].y;
  for (const Vec3d& p : positions) least = std::min(least, p.y);
  return least;
}

/// Invariants of every frame: no triangle passes through another, and features keep apart.
void check_surfaces(const reference::Simulation& simulation, double time) {
  CAPTURE(simulation.frame());
  const reference::Surfaces cloth{simulation.positions(), simulation.triangles()};
  CHECK(reference::self_crossings(cloth).empty());
  CHECK(reference::least_self_distance(cloth) > 0);
  const reference::Obstacles& obstacles = simulation.proximity()->obstacles();
  const auto placed = obstacles.at(time);
  const reference::Surfaces object{placed.positions, obstacles.features().triangles};
  CHECK(reference::crossings(cloth, object).empty());
}

/// A sheet of 5 x 5 nodes that lies at the thickness above a floor, gravity tilted by `slope` about z.
reference::Simulation on_incline(double slope, const std::string& friction) {
  const auto text = [](double value) { return std::to_string(value); };
  return simulation_of_text(R"("gravity": [)" + text(kGravity * std::sin(slope)) + ", " +
                            text(-kGravity * std::cos(slope)) + R"(, 0],
    "time": {"substeps": 16}, "contact": {"method": "proximity", "thickness": 0.01},
    "cloths": [{"grid": [5, 5], "size": [0.2, 0.2], "plane": "xz", "density": 0.2, "damping": 0.01,
      "transform": {"translate": [0, 0.01, 0]}, "friction": 0.5,
      "stiffness": {"structural": 50, "shear": 20, "bend": 1}}],
    "colliders": [{"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0])" +
                            friction + "}]");
}

}  // namespace

TEST_CASE("a sheet that rests on a plane lies at the thickness, and does not move") {
  auto simulation = on_incline(0, "");
  advance(simulation, 60);
  for (const Vec3d& p : simulation.positions()) CHECK(std::abs(0.01 - p.y) < 1e-12);
  for (const Vec3d& v : simulation.velocities()) CHECK(length(v) < 1e-12);
}

TEST_CASE("on an incline a sheet sticks below the angle of friction, without creeping") {
  const double angle = std::atan(0.5);
  for (const double slope : {0.5 * angle, 0.98 * angle}) {
    auto simulation = on_incline(slope, "");
    advance(simulation, 10);
    const Vec3d before = mean(simulation.positions());
    advance(simulation, 60);
    CHECK(length(mean(simulation.positions()) - before) < 1e-6);
  }
}

TEST_CASE("above the angle of friction a sheet slides with g (sin - mu cos), of cloth or of the collider") {
  for (const auto& [friction, mu] :
       {std::pair<std::string, double>{"", 0.5}, {R"(, "friction": 0.2)", 0.2}}) {
    for (const double excess : {1.05, 1.5}) {
      const double slope = std::atan(excess * mu);
      auto simulation = on_incline(slope, friction);
      advance(simulation, 20);
      const double before = mean(simulation.velocities()).x;
      advance(simulation, 60);
      const double expected = kGravity * (std::sin(slope) - mu * std::cos(slope));
      CHECK(mean(simulation.velocities()).x - before == doctest::Approx(expected).epsilon(0.02).scale(0));
    }
  }
}

TEST_CASE("implicit cloth that starts too deep in a floor leaves it and keeps no speed") {
  auto simulation = simulation_of_text(R"("gravity": [0, 0, 0], "solver": {"kind": "multigrid"},
    "contact": {"method": "proximity", "thickness": 0.01},
    "cloths": [{"grid": [9, 9], "size": [0.4, 0.4], "plane": "xz", "density": 0.3, "damping": 0.01,
      "transform": {"translate": [0, 0.006, 0]}, "stiffness": {"structural": 40, "shear": 10, "bend": 0.3}}],
    "colliders": [{"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0]}])");
  advance(simulation, 2);
  for (const Vec3d& p : simulation.positions()) CHECK(p.y > 0.00999);
  for (const Vec3d& v : simulation.velocities()) CHECK(length(v) < 0.02 * kHoldSpeed);
}

TEST_CASE("a dropped sheet bounces as its restitution says") {
  const auto bounce = [](const std::string& restitution) {
    auto simulation = simulation_of_text(R"("time": {"substeps": 64},
      "contact": {"method": "proximity", "thickness": 0.05, "restitution": )" +
                                         restitution + R"(},
      "cloths": [{"grid": [3, 3], "size": [0.2, 0.2], "plane": "xz", "density": 0.2, "damping": 0,
        "transform": {"translate": [0, 0.1, 0]}, "stiffness": {"structural": 5, "shear": 2, "bend": 1}}],
      "colliders": [{"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0]}])");
    double up = 0;  // where it lies [m/s]
    for (int frame = 0; frame < 20; ++frame) {
      advance(simulation, 1);
      const double speed = mean(simulation.velocities()).y;
      const double square = speed * speed + 2 * kGravity * (mean(simulation.positions()).y - 0.05);
      if (speed > 0 && square > up * up) up = std::sqrt(square);
    }
    return up / std::sqrt(2 * kGravity * 0.05);
  };
  CHECK(bounce("0") < 0.2);
  CHECK(bounce("0.5") == doctest::Approx(0.5).epsilon(0.15).scale(0));
  CHECK(bounce("0.9") == doctest::Approx(0.9).epsilon(0.1).scale(0));
}

TEST_CASE("two sheets that meet in free space keep their momentum, and neither passes") {
  auto simulation = simulation_of_text(R"("gravity": [0, 0, 0], "time": {"substeps": 16},
    "contact": {"method": "proximity", "thickness": 0.01},
    "cloths": [{"grid": [6, 6], "size": [0.3, 0.3], "plane": "xz", "density": 0.2, "damping": 0.01,
        "transform": {"translate": [0, 0.06, 0]}, "stiffness": {"structural": 50, "shear": 20, "bend": 1}},
      {"grid": [4, 5], "size": [0.4, 0.3], "plane": "xz", "density": 0.4, "damping": 0.01,
        "transform": {"translate": [0.05, 0, 0.02]}, "stiffness": {"structural": 50, "shear": 20, "bend": 1},
        "grabs": [{"node": {"nodes": [9]}, "end": 0.016, "path": [{"time": 0, "point": [0, 0.2, 0]}]}]}])");
  // The second is pulled up into the first for a frame; from then on nothing acts from outside.
  advance(simulation, 1);
  const auto momentum = [&] {
    const auto model = build_model(simulation.scene(), {{}, {}});
    Vec3d sum;
    for (std::size_t i = 0; i < simulation.velocities().size(); ++i)
      sum += model->mass[i] * simulation.velocities()[i];
    return sum;
  };
  const Vec3d before = momentum();
  CHECK(length(before) > 0.01);
  const std::uint64_t contacts = simulation.contacts();
  for (int frame = 0; frame < 20; ++frame) {
    advance(simulation, 1);
    check_surfaces(simulation, 0);
  }
  CHECK(simulation.contacts() > contacts + 60);
  CHECK(length(momentum() - before) < 1e-12);
}

TEST_CASE("a sheet over a ball, a capsule, a box and a floor passes through none, nor through itself") {
  auto simulation = simulation_of_text(R"("contact": {"method": "proximity", "thickness": 0.01},
    "time": {"substeps": 24},
    "cloths": [{"grid": [17, 17], "size": [0.8, 0.8], "plane": "xz", "density": 0.3, "damping": 0.02,
      "transform": {"translate": [0, 0.33, 0]}, "stiffness": {"structural": 80, "shear": 40, "bend": 0.5}}],
    "colliders": [{"kind": "sphere", "center": [-0.15, 0.15, 0.15], "radius": 0.12},
      {"kind": "capsule", "a": [-0.3, 0.2, -0.2], "b": [0.1, 0.25, -0.2], "radius": 0.03},
      {"kind": "box", "center": [0.2, 0.12, 0.1], "size": [0.1, 0.3, 0.1],
      "rotate": [0, 0.382683432365, 0, 0.923879532511]},
      {"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0]}])");
  for (int frame = 0; frame < 36; ++frame) {
    advance(simulation, 1);
    check_surfaces(simulation, 0);
    CHECK(reference::inside_capsule(simulation.positions(), {-0.15, 0.15, 0.15}, {-0.15, 0.15, 0.15}, 0.12)
              .count == 0);
    CHECK(
        reference::inside_capsule(simulation.positions(), {-0.3, 0.2, -0.2}, {0.1, 0.25, -0.2}, 0.03).count ==
        0);
    CHECK(lowest(simulation.positions()) > 0);
  }
  CHECK(lowest(simulation.positions()) < 0.05);  // it has come down
}

TEST_CASE("a coarse sheet that falls on a needle is held by it between its vertices") {
  auto scene = scene::parse_scene(R"({"format": "weft-scene/1", "solver": {"kind": "mass_spring"},
      "time": {"substeps": 16},
    "contact": {"method": "proximity", "thickness": 0.01},
    "cloths": [{"grid": [3, 3], "size": [0.6, 0.6], "plane": "xz", "density": 0.3, "damping": 0.05,
      "stiffness": {"structural": 200, "shear": 100, "bend": 20}}],
    "colliders": [{"kind": "mesh", "mesh": "needle"}]})",
                                  "test.json");
  REQUIRE_OK(scene);
  // Its tip is under the middle of a triangle, 0.1 m from each edge or more.
  const mesh::TriangleMesh needle{
      {{0.1F, -0.02F, 0.2F}, {0.11F, -0.6F, 0.2F}, {0.09F, -0.6F, 0.21F}, {0.09F, -0.6F, 0.19F}},
      {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}}};
  auto simulation = reference::Simulation::create(*scene, {.cloths = {{}}, .objects = {needle}});
  REQUIRE_OK(simulation);
  double above = 1;
  for (int frame = 0; frame < 12; ++frame) {
    advance(*simulation, 1);
    check_surfaces(*simulation, 0);
    above = std::min(above, mean(simulation->positions()).y);
  }
  CHECK(simulation->contacts() > 10);
  CHECK(above > -0.19);  // free fall would be 0.196 m
}

TEST_CASE("a floor that moves carries a sheet along, and a roller that turns drags it over") {
  const auto speed_on = [](const std::string& colliders) {
    auto simulation =
        simulation_of_text(R"("time": {"substeps": 16}, "contact": {"method": "proximity", "thickness": 0.01},
      "cloths": [{"grid": [5, 5], "size": [0.2, 0.2], "plane": "xz", "density": 0.2, "damping": 0.01,
        "transform": {"translate": [0, 0.01, 0]}, "stiffness": {"structural": 50, "shear": 20, "bend": 1}}],
      "colliders": [)" + colliders +
                           "]");
    advance(simulation, 15);
    return mean(simulation.velocities());
  };
  // Friction 0.3 gives 2.9 m/s²: 0.4 m/s within 0.14 s.
  const Vec3d carried = speed_on(R"({"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0],
    "motion": {"kind": "line", "direction": [1, 0, 0], "speed": 0.4}})");
  CHECK(std::abs(carried.x - 0.4) < 1e-6);
  CHECK(std::abs(carried.y) < 1e-6);
  // Rollers along z, 0.1 m thick, that turn about their own axes at 4 /s: their tops go to -x at 0.4 m/s.
  std::string rollers;
  for (const std::string x : {"-0.5", "-0.25", "0", "0.25", "0.5"})
    rollers += (rollers.empty() ? "" : ",") + std::string(R"({"kind": "capsule", "a": [)") + x +
               ", -0.1, -1], \"b\": [" + x + R"(, -0.1, 1], "radius": 0.1,
      "motion": {"kind": "rotation", "axis": [0, 0, 1], "center": [)" +
               x + R"(, -0.1, 0], "speed": 4}})";
  CHECK(speed_on(rollers).x < -0.2);
}

TEST_CASE("a ball that flies into a sheet at 20 m/s has its frames cut, and takes the sheet with it") {
  auto simulation = simulation_of_text(R"("gravity": [0, 0, 0], "time": {"substeps": 8},
    "contact": {"method": "proximity", "thickness": 0.01},
    "cloths": [{"grid": [9, 9], "size": [0.4, 0.4], "plane": "xz", "density": 0.3, "damping": 0.02,
      "stiffness": {"structural": 50, "shear": 20, "bend": 1}}],
    "colliders": [{"kind": "sphere", "center": [0.02, -0.6, 0.01], "radius": 0.1,
      "motion": {"kind": "line", "direction": [0, 1, 0], "speed": 20, "distance": 2}}])");
  for (int frame = 0; frame < 6; ++frame) {
    advance(simulation, 1);
    const Vec3d center{0.02, -0.6 + std::min(20 * simulation.time(), 2.0), 0.01};
    CHECK(reference::inside_capsule(simulation.positions(), center, center, 0.1).count == 0);
    check_surfaces(simulation, 0);
  }
  CHECK(mean(simulation.positions()).y > 1.4);
}

TEST_CASE("truncation brings no energy into a sheet that falls over a ball in too long steps") {
  // So thin that vertices come to the planes between features before impulses stop them.
  auto simulation = simulation_of_file(
      "pull-sphere",
      {{"cloths.0.grid", "[16,16]"}, {"contact.method", "\"proximity\""}, {"contact.thickness", "0.001"}});
  const double start = simulation.energy();
  for (int frame = 0; frame < 12; ++frame) {  // the pull begins after 15
    advance(simulation, 1);
    CHECK(simulation.energy() < start);
    check_surfaces(simulation, 0);
  }
  CHECK(simulation.proximity()->truncated().vertices > 0);
}

TEST_CASE("a mesh that keyframes lift does to a sheet what the same mesh does on a path") {
  const std::string start =
      R"({"format": "weft-scene/1", "solver": {"kind": "mass_spring"}, "time": {"substeps": 16},
    "contact": {"method": "proximity", "thickness": 0.01},
    "cloths": [{"grid": [7, 7], "size": [0.4, 0.4], "plane": "xz", "density": 0.3, "damping": 0.02,
      "transform": {"translate": [0, 0.02, 0]}, "stiffness": {"structural": 50, "shear": 20, "bend": 1}}],
    "colliders": [{"kind": "mesh", "mesh": "box")";
  const auto deforming =
      scene::parse_scene(start + R"(, "keyframes": [{"time": 0.5, "mesh": "up"}]}]})", "test.json");
  const auto moving = scene::parse_scene(
      start + R"(, "motion": {"kind": "path", "points": [[0.5, [0, 0.125, 0]]]}}]})", "test.json");
  REQUIRE_OK(deforming);
  REQUIRE_OK(moving);
  mesh::TriangleMesh box = mesh::make_box({0.25, 0.5, 0.25});
  for (Vec3f& p : box.positions) p.y -= 0.25F;
  mesh::TriangleMesh up = box;
  for (Vec3f& p : up.positions) p.y += 0.125F;
  auto a = reference::Simulation::create(
      *deforming, {.cloths = {{}}, .objects = {box}, .deformations = {{{{0.5}}, {up.positions}}}});
  auto b = reference::Simulation::create(*moving, {.cloths = {{}}, .objects = {box}});
  REQUIRE_OK(a);
  REQUIRE_OK(b);
  advance(*a, 20);
  advance(*b, 20);
  for (std::size_t i = 0; i < a->positions().size(); ++i)
    CHECK(length(a->positions()[i] - b->positions()[i]) < 1e-9);
  check_surfaces(*a, a->time());
  CHECK(mean(a->positions()).y > 0.05);
}

TEST_CASE("a moved sheet is to another what an obstacle is") {
  auto simulation = simulation_of_text(R"("gravity": [0, 0, 0], "time": {"substeps": 16},
    "contact": {"method": "proximity", "thickness": 0.01},
    "cloths": [{"grid": [5, 5], "size": [0.3, 0.3], "plane": "xz", "density": 0.3, "damping": 0.01,
        "transform": {"translate": [0, 0.05, 0]}, "stiffness": {"structural": 50, "shear": 20, "bend": 1}},
      {"grid": [4, 4], "size": [0.4, 0.4], "plane": "xz", "density": 0.3,
        "motions": [{"nodes": {"box": {"min": [-1, -1, -1], "max": [1, 0.01, 1]}}, "kind": "line",
                     "direction": [0, 1, 0], "speed": 3}]}])");
  advance(simulation, 10);
  check_surfaces(simulation, 0);
  for (std::size_t i = 0; i < 25; ++i) {
    CHECK(simulation.positions()[i].y >
          0.5 + 0.0025);  // a quarter of the thickness, or of what it is in the sheet
    CHECK(simulation.velocities()[i].y > 2);
  }
}

TEST_CASE("proximity repeats bit for bit, also after a reset, and without self contact cloth ignores cloth") {
  const std::vector<scene::Override> small = {{"cloths.0.grid", "[12,12]"},
                                              {"contact.method", "\"proximity\""}};
  auto a = simulation_of_file("pull-sphere", small), b = simulation_of_file("pull-sphere", small);
  advance(a, 6);
  advance(b, 6);
  CHECK(a.contacts() > 0);
  const std::string hash = a.hash();
  CHECK(b.hash() == hash);
  a.reset();
  advance(a, 6);
  CHECK(a.hash() == hash);
  auto without = simulation_of_file("pull-sphere", {{"contact.self", "false"}, small[0], small[1]});
  CHECK(without.proximity()->self_thickness() == 0);
}
