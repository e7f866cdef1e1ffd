// A grabbed node is pulled, never put.
#include <algorithm>
#include <cmath>

#include "method/mass_spring/reference/mass_spring.hpp"
#include "model/grab_speed.hpp"
#include "world_rig.hpp"

using namespace weft;

namespace {

constexpr std::uint32_t kCorner = 10 * 13;  // bottom left

/// A sheet of 13 x 11 nodes that hangs by its upper edge, 1 m wide.
scene::Scene curtain(const std::string& members = "", const std::string& cloth = "") {
  auto scene = scene::parse_scene(
      R"({"format": "weft-scene/1", "solver": {"kind": "mass_spring"},
          "contact": {"method": "none"}, "drag": 0.5, "cloths": [{"grid": [13, 11],
         "size": [1, 0.8], "density": 0.2, "damping": 0.01, "pins": ["top"], "transform": {"translate": [0, 0.4, 0]},
         "stiffness": {"structural": 400, "shear": 100, "bend": 2})" +
          cloth + "}]" + members + "}",
      "curtain.json");
  REQUIRE_OK(scene);
  return std::move(*scene);
}

Vec3d place_of(sim::World& world, std::uint32_t node) {
  const auto snapshot = world.snapshot();
  REQUIRE_OK(snapshot);
  return snapshot->position[node].xyz().to<double>();
}

double energy_of(sim::World& world) {
  const auto snapshot = world.snapshot();
  REQUIRE_OK(snapshot);
  reference::MassSpringSystem system;
  for (std::size_t i = 0; i < snapshot->position.size(); ++i) {
    system.position.push_back(snapshot->position[i].xyz().to<double>());
    system.velocity.push_back(snapshot->velocity[i].xyz().to<double>());
    system.inverse_mass.push_back(static_cast<double>(snapshot->position[i].w));
  }
  for (const Spring s : world.model().host.springs())
    system.springs.push_back({s.node_a, s.node_b, static_cast<double>(s.rest_length),
                              static_cast<double>(s.stiffness), static_cast<double>(s.damping)});
  system.acceleration = world.scene().gravity;
  return reference::energy(system);
}

std::string refusal(const Result<void>& result) { return result ? "" : result.error().message; }

}  // namespace

TEST_CASE("a grabbed corner of hanging cloth is at its target within 1 mm after 1 s, and its sheet follows") {
  GpuFixture fixture;
  auto world = world_of(fixture.device(), curtain());
  const std::string rest = hash_of(*world);
  const Vec3d start = place_of(*world, kCorner), target = start + Vec3d{0.15, 0.3, 0.3};
  REQUIRE(world->grab(kCorner, target));
  advance(*world, 60);
  CHECK(length(place_of(*world, kCorner) - target) < 1e-3);
  const Vec3d beside = place_of(*world, kCorner + 1) - (start + Vec3d{1.0 / 12, 0, 0});
  CHECK(length(beside) > 0.2);
  // The waves of the lattice run at about √(E / rho) = 50 m/s. The first pull is 20 / s of 0.45 m, 9 m/s, so
  // at a corner the strain is near 9 / 50, and less than twice that.
  CHECK(world->totals().max_stretch < 1.36F);

  REQUIRE(world->release(kCorner));
  const double before = energy_of(*world), scale = std::abs(before);
  for (int frame = 0; frame < 60; ++frame) {
    advance(*world, 1);
    CHECK(energy_of(*world) <= before + 1e-3 * scale);
  }
  CHECK(energy_of(*world) < before);

  REQUIRE(world->grab(kCorner, target));
  REQUIRE(world->reset());
  CHECK(hash_of(*world) == rest);
  CHECK(refusal(world->release(kCorner)) == "Node 130 is not grabbed; 0 of at most 1024 nodes are.");
  auto fresh = world_of(fixture.device(), curtain());
  advance(*world, 5);
  advance(*fresh, 5);
  CHECK(hash_of(*world) == hash_of(*fresh));  // the substeps know of no grab either
}

TEST_CASE("no substep moves a grabbed node by more than its greatest speed allows, wherever the target is") {
  GpuFixture fixture;
  const double dt = 5e-4;
  auto world = world_of(fixture.device(), curtain(R"(, "time": {"frame": 5e-4, "substeps": 1})"));
  CHECK(grab_speed(world->model().host) == 10);
  Vec3d before = place_of(*world, kCorner);
  REQUIRE(world->grab(kCorner, {5, -3, 8}));
  for (int step = 0; step < 60; ++step) {
    if (step == 30) REQUIRE(world->drag(kCorner, {-9, 2, -1}));
    advance(*world, 1);
    const Vec3d now = place_of(*world, kCorner);
    CHECK(length(now - before) < 10 * dt * (1 + 1e-4));  // positions below 1 m round by 6e-8 of 5e-3
    CHECK(length(now - before) > 10 * dt * (1 - 1e-4));
    before = now;
  }
}

TEST_CASE("a scene's own grab is the same as one by hand") {
  GpuFixture fixture;
  auto by_hand = world_of(fixture.device(), curtain());
  REQUIRE(by_hand->grab(kCorner, {-0.3, 0.1, 0.4}));
  advance(*by_hand, 20);
  REQUIRE(by_hand->release(kCorner));
  advance(*by_hand, 10);
  // The end lies within the last grabbed substep, where rounding cannot move it to another.
  auto scripted =
      world_of(fixture.device(), curtain("", R"(, "grabs": [{"node": "bottom_left", "end": 0.33334,
                           "path": [{"time": 3, "point": [-0.3, 0.1, 0.4]}]}])"));
  advance(*scripted, 30);
  CHECK(hash_of(*scripted) == hash_of(*by_hand));
  REQUIRE(scripted->reset());
  advance(*scripted, 30);
  CHECK(hash_of(*scripted) == hash_of(*by_hand));
}

TEST_CASE("what cannot be grabbed is refused with the reason") {
  GpuFixture fixture;
  const Vec3d target{0, 0, 0.5};
  auto world = world_of(fixture.device(), curtain());
  CHECK(refusal(world->grab(143, target)) ==
        "Node 143 cannot be grabbed: there are 143 nodes, counted from 0.");
  CHECK(refusal(world->grab(3, target)) == "Node 3 cannot be grabbed: it is pinned.");
  CHECK(refusal(world->drag(40, target)) == "Node 40 is not grabbed; 0 of at most 1024 nodes are.");
  for (const std::uint32_t node : {40U, 41U, 42U}) REQUIRE(world->grab(node, target));
  CHECK(refusal(world->grab(41, target)) == "Node 41 cannot be grabbed: it is grabbed already.");
  CHECK(refusal(world->drag(40, {0, NAN, 0})).find("not finite") != std::string::npos);
  REQUIRE(world->release(41));
  REQUIRE(world->grab(41, target));

  auto shared = world_of(fixture.device(), curtain("", R"(, "grabs": [
      {"node": {"nodes": [50]}, "start": 1, "end": 3, "path": [{"time": 0, "point": [0, 0, 1]}]},
      {"node": {"nodes": [51]}, "start": 3, "end": 4, "path": [{"time": 0, "point": [0, 0, 1]}]},
      {"node": {"nodes": [52]}, "start": 2, "end": 4, "path": [{"time": 0, "point": [0, 0, 1]}]}])"));
  CHECK(refusal(shared->grab(52, target)) ==
        "Node 52 cannot be grabbed: curtain.json: cloths[0].grabs[2] holds it from 2 s on.");
}

TEST_CASE("in a large scene a grabbed node may cross five sheets a second") {
  auto scene = shipped_scene("hanging-paper", {{"cloths.0.grid", "[5,5]"}});
  const auto model = build_model(scene, {{}});
  REQUIRE_OK(model);
  CHECK(grab_speed(*model) == doctest::Approx(1500));
}
