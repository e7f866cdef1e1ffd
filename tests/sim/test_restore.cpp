// A snapshot that is put back: time goes on from its own, in its world and in worlds whose frames have another length.
#include <cmath>

#include "scene/motion.hpp"
#include "world_rig.hpp"

using namespace weft;

namespace {

constexpr const char* kAlone = R"(, "contact": {"method": "none"})";

/// A sheet of 1 m by 1 m and 9 x 9 nodes, with frames of `frames_per_second` in so many steps a second; of fewer steps
/// it is as much softer as they need.
scene::Scene sheet(int frames_per_second, const std::string& cloth, const std::string& more = "",
                   int steps = 3840) {
  const double softer = std::pow(steps / 3840.0, 2);
  auto scene = scene::parse_scene(
      R"({"format": "weft-scene/1", "drag": 0.5, "solver": {"kind": "mass_spring"},
          "time": {"frame": )" +
          std::to_string(1.0 / frames_per_second) + R"(, "substeps": )" +
          std::to_string(steps / frames_per_second) + "}" + (more.empty() ? kAlone : more) +
          R"(, "cloths": [{"grid": [9, 9], "size": [1, 1], "plane": "xz", "density": 0.4, "damping": 0.01,
              "stiffness": {"structural": )" +
          std::to_string(450 * softer) + R"(, "shear": )" + std::to_string(130 * softer) + R"(, "bend": )" +
          std::to_string(10 * softer) + "}" + cloth + "}]}",
      "sheet.json");
  REQUIRE_OK(scene);
  scene->time.frame = 1.0 / frames_per_second;  // its decimals are not all in the text
  return std::move(*scene);
}

constexpr const char* kPulled = R"(, "pins": ["left"], "motions": [
  {"nodes": "right", "kind": "line", "direction": [1, 0, 0], "speed": 0.6, "start": 0.05, "ramp": 0.1}])";

sim::Snapshot state_of(sim::World& world) {
  auto snapshot = world.snapshot();
  REQUIRE_OK(snapshot);
  return std::move(*snapshot);
}

/// The largest length of an edge over its length at rest.
double largest_stretch(const sim::World& world, const sim::Snapshot& state) {
  const Model& model = world.model().host;
  double most = 0;
  for (const mesh::Triangle& triangle : model.triangles)
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = triangle[k], b = triangle[(k + 1) % 3];
      const Vec3d now = state.position[a].xyz().to<double>() - state.position[b].xyz().to<double>();
      most = std::max(most, length(now) / length(model.rest_position[a] - model.rest_position[b]));
    }
  return most;
}

double largest_difference(const sim::Snapshot& a, const sim::Snapshot& b) {
  double most = 0;
  for (std::size_t node = 0; node < a.position.size(); ++node)
    most = std::max(most, length((a.position[node].xyz() - b.position[node].xyz()).to<double>()));
  return most;
}

/// How far the moved nodes are from where the scene's motions have them at the world's time, at most [m].
double off_motions(sim::World& world) {
  const sim::Snapshot state = state_of(world);
  const Model& model = world.model().host;
  double most = 0;
  for (std::size_t node = 0; node < state.position.size(); ++node)
    if (model.motion[node] > 1) {
      const auto place = scene::motion_at(model.motions[model.motion[node] - 2], world.time());
      const Vec3d wanted = place(model.rest_position[node]);
      most = std::max(most, length(state.position[node].xyz().to<double>() - wanted));
    }
  return most;
}

}  // namespace

TEST_CASE("a step after a restore in a world with other frames, a pulled sheet is stretched as it was") {
  GpuFixture fixture;
  auto world = world_of(fixture.device(), sheet(60, kPulled));
  advance(*world, 24);
  const sim::Snapshot middle = state_of(*world);
  const double before = largest_stretch(*world, middle);
  CHECK(before > 1.15);  // 0.18 m of 1 m
  auto other = world_of(fixture.device(), sheet(3840, kPulled));
  REQUIRE(other->restore(middle));
  CHECK(other->time() == doctest::Approx(0.4).epsilon(1e-12).scale(0));
  CHECK(other->frame() == 0);
  advance(*other, 1);
  // In 0.26 ms an edge of 125 mm between nodes of 0 and 0.6 m/s becomes 0.16 mm longer: by 0.13 %.
  CHECK(largest_stretch(*other, state_of(*other)) == doctest::Approx(before).epsilon(0.01).scale(0));
  CHECK(other->time() == doctest::Approx(0.4 + 1.0 / 3840).epsilon(1e-12).scale(0));
  REQUIRE(other->reset());
  CHECK(other->time() == 0);
  advance(*other, 1);
  CHECK(off_motions(*other) == 0);  // before the motion begins
}

TEST_CASE("after a restore every motion goes on from the snapshot's time, whatever the frames") {
  GpuFixture fixture;
  for (const char* motion :
       {R"("kind": "line", "direction": [0, 0, 1], "speed": 0.5, "ramp": 0.1, "distance": 0.2)",
        R"("kind": "rotation", "axis": [1, 0, 0], "center": [0, 0.2, 0], "speed": 3)",
        R"("kind": "path", "points": [[0, [0, 0.01, 0]], [1, [0, 0.3, 0.1]]])"}) {
    CAPTURE(motion);
    const std::string cloth = R"(, "motions": [{"nodes": "right", )" + std::string(motion) + "}]";
    auto world = world_of(fixture.device(), sheet(60, cloth));
    const sim::Snapshot rest = state_of(*world);
    advance(*world, 12);
    const sim::Snapshot middle = state_of(*world);
    CHECK(off_motions(*world) < 1e-6);
    for (const int frames_per_second : {480, 60, 30, 32}) {
      CAPTURE(frames_per_second);
      auto other = world_of(fixture.device(), sheet(frames_per_second, cloth));
      REQUIRE(other->restore(middle));
      CHECK(off_motions(*other) < 1e-6);  // some roundings of f32 at 1 m
      advance(*other, 3);
      CHECK(other->time() == doctest::Approx(0.2 + 3.0 / frames_per_second).epsilon(1e-12).scale(0));
      CHECK(off_motions(*other) < 1e-6);
    }
    REQUIRE(world->restore(
        rest));  // a path that does not begin at its nodes' rest moves them from the first step on
    CHECK(world->time() == 0);
  }
}

TEST_CASE("after a restore a moving floor still carries what lies on it") {
  GpuFixture fixture;
  const std::string floor = R"(, "contact": {"method": "proximity", "thickness": 0.005}, "colliders": [
    {"kind": "box", "center": [0, -0.11, 0], "size": [2, 0.2, 2],
     "motion": {"kind": "line", "direction": [0, 1, 0], "speed": 0.5, "ramp": 0.2}}])";
  auto world = world_of(fixture.device(), sheet(60, "", floor, 960));
  advance(*world, 24);
  auto other = world_of(fixture.device(), sheet(120, "", floor, 960));
  REQUIRE(other->restore(state_of(*world)));
  advance(*other, 12);
  const double top = -0.01 + 0.5 * (0.5 - 0.1);  // at 0.5 s
  double mean = 0;
  const sim::Snapshot now = state_of(*other);
  for (const Vec4f& p : now.position)
    mean += static_cast<double>(p.y) / static_cast<double>(now.position.size());
  CHECK(mean - top > 0);
  CHECK(mean - top <
        0.01);  // two thicknesses; in free fall from 0.4 s on it would be 0.049 m behind the floor
}

TEST_CASE("after a restore gusts and the scene's grabs go on, also where the wind has changed before") {
  GpuFixture fixture;
  const std::string held =
      R"(, "pins": ["left"], "grabs": [{"node": "bottom_right", "start": 0.05, "path": [
           {"time": 0, "point": [0.5, 0, 0.5]}, {"time": 0.5, "point": [0.5, 0.4, 0.4]}]}])";
  const std::string wind =
      std::string(kAlone) + R"(, "wind": {"velocity": [3, 1, 2], "gusts": 0.8, "wavelength": 0.5})";
  auto world = world_of(fixture.device(), sheet(60, held, wind));
  advance(*world, 5);
  scene::Scene changed = world->scene();
  changed.wind.velocity = {4, 1, 2};
  REQUIRE(world->change(changed));
  advance(*world, 4);
  const sim::Snapshot middle = state_of(*world);
  advance(*world, 6);
  const sim::Snapshot straight = state_of(*world);

  scene::Scene half = sheet(120, held, wind);  // the same steps
  half.wind = changed.wind;
  auto other = world_of(fixture.device(), half);
  REQUIRE(other->restore(middle));
  advance(*other, 12);
  // The two differ by roundings of the f32 in which forces and 384 steps are computed. A wind of another phase, or a
  // hand that is elsewhere, moves nodes by millimetres.
  CHECK(largest_difference(state_of(*other), straight) < 2e-5);

  auto again = world_of(fixture.device(), sheet(60, held, wind));
  REQUIRE(again->change(changed));
  REQUIRE(again->restore(middle));
  CHECK(again->frame() == 9);
  advance(*again, 6);
  CHECK(state_of(*again).hash() == straight.hash());
  REQUIRE(world->restore(middle));
  advance(*world, 6);
  CHECK(state_of(*world).hash() == straight.hash());
}

TEST_CASE("a snapshot that is not of this scene at its time is refused, and nothing changes") {
  GpuFixture fixture;
  auto world = world_of(fixture.device(), sheet(60, kPulled));
  advance(*world, 24);
  const sim::Snapshot middle = state_of(*world);
  advance(*world, 3);
  const std::string hash = hash_of(*world);
  const auto refused = [&](const sim::Snapshot& snapshot) -> std::string {
    const auto restored = world->restore(snapshot);
    CHECK(hash_of(*world) == hash);
    CHECK(world->frame() == 27);
    CHECK(world->time() == 27 * (1.0 / 60));
    if (restored) return "";
    CHECK(restored.error().kind == ErrorKind::Input);
    return restored.error().message;
  };
  sim::Snapshot fewer = middle;
  fewer.position.pop_back();
  CHECK(refused(fewer) == "The snapshot has 80 positions and 81 velocities; this scene has 81 nodes.");
  sim::Snapshot early = middle;
  early.time = {};  // as if it had no time: the moved edge has gone 0.18 m
  CHECK(refused(early).find("is 0.18 m from where this scene has it at 0 s; rounding allows ") !=
        std::string::npos);
  // Nodes of ~1 m are rounded to 6e-8 m: a tenth of a millimetre is no rounding.
  sim::Snapshot off = middle;
  off.position[8].y += 1e-4F;
  CHECK(refused(off).find("Node 8 of the snapshot is 0.0001") == 0);
  off = middle;
  off.position[0].y = NAN;  // pinned
  CHECK(refused(off).find("Node 0 of the snapshot is ") == 0);
  off = middle;
  off.position[40].y += 0.1F;  // a free node may be anywhere
  CHECK(world->restore(off));
  CHECK(world->frame() == 24);

  const std::string grab = R"(, "grabs": [{"node": "bottom_right", "end": 0.1, "path": [
           {"time": 0, "point": [0.5, 0, 0.5]}]}])";
  world = world_of(fixture.device(), sheet(60, grab));
  const sim::Snapshot rest = state_of(*world);
  advance(*world, 8);
  const std::uint32_t node = world->model().host.grabs.at(0).node;
  REQUIRE(world->grab(node, {0.5, 0.1, 0.5}));
  const auto restored = world->restore(rest);
  REQUIRE(!restored);
  CHECK(restored.error().message.find("cannot be grabbed") != std::string::npos);
  CHECK(world->frame() == 8);
}

TEST_CASE("nodes that a program has moved are where a snapshot has them") {
  GpuFixture fixture;
  const auto scene = sheet(60, R"(, "motions": [{"nodes": "right", "kind": "given", "speed": 3}])");
  auto world = world_of(fixture.device(), scene);
  const std::vector<std::uint32_t> nodes = world->given_nodes();
  REQUIRE(nodes.size() == 9);
  const auto lift = [&](sim::World& of, float height) {
    const sim::Snapshot now = state_of(of);
    std::vector<Vec3f> places;
    for (const std::uint32_t node : nodes) places.push_back(now.position[node].xyz() + Vec3f{0, height, 0});
    REQUIRE(of.move(nodes, places));
    advance(of, 1);
  };
  lift(*world, 0.04F);
  const sim::Snapshot middle = state_of(*world);
  lift(*world, 0.03F);
  advance(*world, 2);
  const std::string end = hash_of(*world);
  REQUIRE(world->restore(middle));  // back by 0.03 m, at an earlier time
  CHECK(hash_of(*world) == middle.hash());
  lift(*world, 0.03F);
  advance(*world, 2);
  CHECK(hash_of(*world) == end);

  auto other = world_of(fixture.device(), scene);  // whose nodes were never moved
  REQUIRE(other->restore(middle));
  advance(*other, 1);
  const sim::Snapshot stayed = state_of(*other);
  for (const std::uint32_t node : nodes)
    CHECK(length(stayed.position[node].xyz() - middle.position[node].xyz()) < 2e-7F);
  sim::Snapshot bad = middle;
  bad.position[nodes[0]].y = NAN;
  CHECK(!other->restore(bad));
}

TEST_CASE("where coordinates are large, rounding is no reason to refuse a snapshot") {
  GpuFixture fixture;
  const std::string far = R"(, "transform": {"translate": [300, 40, -500]}, "motions": [
    {"nodes": "right", "kind": "rotation", "axis": [0.6, 0, 0.8], "center": [100, -700, 30], "speed": 5}])";
  auto world = world_of(fixture.device(), sheet(60, far));
  advance(*world, 2);
  REQUIRE(world->restore(state_of(*world)));
}
