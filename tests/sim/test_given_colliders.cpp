// Colliders that a program moves: what they do to cloth is what the same motion of a scene does.
#include <cmath>

#include "base/quaternion.hpp"
#include "base/trig.hpp"
#include "contact_rig.hpp"
#include "scene/screw.hpp"

using namespace weft;

namespace {

constexpr double kFrame = 1.0 / 64;  // s, so that times are exact
constexpr double kSpeed = 1.5;       // m/s; a frame is 0.0234375 m, exact too

/// A cloth over a collider with this motion.
scene::Scene over(const std::string& collider, const std::string& motion, const std::string& cloth = "") {
  return contact_scene(R"("time": {"frame": 0.015625, "substeps": 8}, "cloths": [)" +
                       lying_cloth(9, "[0, 0.005, 0]", cloth) + R"(], "colliders": [{)" + collider +
                       R"(, "friction": 0.6, "motion": )" + motion + "}]");
}

const std::string kGiven = R"({"kind": "given", "speed": 1.5})";
const std::string kSphere = R"("kind": "sphere", "center": [0, -0.2, 0], "radius": 0.2)";
const std::string kPlate = R"("kind": "box", "center": [0, -0.05, 0], "size": [1, 0.1, 1])";

Placement shifted(const Vec3d& by) { return {by}; }
Placement turned_about_y(double angle) {
  const Turn half = turn_of(0.5 * angle);
  return {{}, {0, half.sine, 0, half.cosine}};
}

void carry(sim::World& world, const Placement& placement) {
  const auto moved = world.set_collider(0, placement);
  REQUIRE_OK(moved);
  const auto done = world.advance_frame();
  REQUIRE_OK(done);
}
void finish(sim::World& world) {
  const auto done = world.finish();
  REQUIRE_OK(done);
}

/// Up for eight frames, aside for eight.
Vec3d zigzag(int frame) {
  const double step = kSpeed * kFrame;
  return {step * std::max(0, frame - 8), step * std::min(8, frame), 0};
}
const std::string kZigzag =
    R"({"kind": "path", "points": [[0.125, [0, 0.1875, 0]], [0.25, [0.1875, 0.1875, 0]], [1, [1.3125, 0.1875, 0]]]})";

std::string refusal(sim::World& world, std::size_t collider, const Placement& placement) {
  const auto moved = world.set_collider(collider, placement);
  REQUIRE(!moved);
  CHECK(moved.error().kind == ErrorKind::Input);
  return moved.error().message;
}

}  // namespace

TEST_CASE("a collider of any kind that a program carries has the bits of the same path of its scene") {
  GpuFixture fixture;
  for (const std::string& collider :
       {kSphere, kPlate, std::string(R"("kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0])"),
        std::string(R"("kind": "capsule", "a": [-0.3, -0.1, 0], "b": [0.3, -0.1, 0], "radius": 0.1)"),
        std::string(
            R"("kind": "convex", "points": [[-0.2, 0, 0], [0.2, 0, 0], [0, 0, 0.3], [0, -0.3, 0]])")}) {
    INFO(collider);
    auto path = world_of(fixture.device(), over(collider, kZigzag));
    advance(*path, 16);
    auto given = world_of(fixture.device(), over(collider, kGiven));
    for (int frame = 1; frame <= 16; ++frame) carry(*given, shifted(zigzag(frame)));  // nothing is waited for
    finish(*given);
    CHECK(hash_of(*given) == hash_of(*path));
    CHECK(given->totals().contacts > 0);
  }
}

TEST_CASE("frames that are repeated find their colliders where they had them") {
  GpuFixture fixture;
  sim::WorldOptions small;
  small.contact_room = ContactRoom{16, 16, 16};
  std::vector<std::string> hashes;
  for (const sim::WorldOptions& options : {sim::WorldOptions{}, small}) {
    auto world = world_of(fixture.device(), over(kSphere, kGiven), options);
    for (int frame = 1; frame <= 12; ++frame) carry(*world, shifted(zigzag(frame)));
    finish(*world);
    CHECK((world->totals().repeated_frames > 0) == options.contact_room.has_value());
    hashes.push_back(hash_of(*world));
  }
  CHECK(hashes[0] == hashes[1]);
}

TEST_CASE("a plate that a program pulls away drags its cloth by Coulomb's friction, and then has it along") {
  GpuFixture fixture;
  auto world = world_of(fixture.device(), over(kPlate, kGiven));
  advance(*world, 16);  // to rest
  const double friction = 0.6, begin = world->time();
  const auto mean = [&] { return Moment(*world).mean_velocity().x; };
  double next = 0;
  for (int frame = 1; frame <= 40; ++frame) {
    next += kSpeed * kFrame;
    carry(*world, shifted({next, 0, 0}));
    if (frame % 4 != 0) continue;
    finish(*world);
    const double t = world->time() - begin;
    // It slides with mu g for v / (mu g) = 0.255 s, 16 frames; around then parts of it do and parts do not.
    if (frame <= 12) CHECK(mean() == doctest::Approx(friction * kGravity * t).epsilon(0.02).scale(0));
    if (frame >= 24) CHECK(mean() == doctest::Approx(kSpeed).epsilon(0.001).scale(0));
  }
}

TEST_CASE("a plate that a program turns has cloth turn with it, each node at the plate's velocity there") {
  GpuFixture fixture;
  const double spin = 2;  // rad/s: 0.28 m from the axis the pull of 1.1 m/s² is below friction's 5.9 m/s²
  auto world = world_of(fixture.device(), over(kPlate, kGiven));
  advance(*world, 8);
  for (int frame = 1; frame <= 48; ++frame) carry(*world, turned_about_y(spin * frame * kFrame));
  finish(*world);
  const Moment now(*world);
  for (std::size_t node = 0; node < now.position.size(); ++node) {
    const Vec3d of_plate = cross(Vec3d{0, spin, 0}, now.position[node]);
    CHECK(length(now.velocity[node] - of_plate) < 0.02 * spin * 0.28);
  }
}

TEST_CASE("a plate that a program turns takes cloth where the rotation of a scene does") {
  GpuFixture fixture;
  auto given = world_of(fixture.device(), over(kPlate, kGiven));
  // The box's farthest corner, 0.707 m from the axis, goes with 1.5 m/s: both choose their substeps by that.
  auto turning =
      world_of(fixture.device(), over(kPlate, R"({"kind": "rotation", "axis": [0, 1, 0], "center": [0, 0, 0],
      "speed": 2.1213203435596424})"));
  for (int frame = 1; frame <= 24; ++frame)
    carry(*given, turned_about_y(2.1213203435596424 * frame * kFrame));
  finish(*given);
  advance(*turning, 24);
  REQUIRE(given->most_substeps() == turning->most_substeps());
  const Moment a(*given), b(*turning);
  // The angles are not the same doubles: a row may round otherwise, and a place below 1 m is off by 6e-8 m then, in
  // each of 24 x 8 substeps or more.
  for (std::size_t node = 0; node < a.position.size(); ++node)
    CHECK(length(a.position[node] - b.position[node]) < 24 * 8 * 6e-8);
}

TEST_CASE("a rigid body on a plate that a program carries goes where the same path of a scene takes it") {
  GpuFixture fixture;
  const auto stood_on = [&](const std::string& motion) {
    return world_of(fixture.device(),
                    contact_scene(R"("time": {"frame": 0.015625, "substeps": 8}, "cloths": [)" +
                                  lying_cloth(4, "[2, 2, 0]") + R"(], "colliders": [{)" + kPlate +
                                  R"(, "motion": )" + motion +
                                  R"(}, {"kind": "box", "center": [0, 0.051, 0], "size": [0.1, 0.1, 0.1],
                                     "rigid": {"mass": 0.2}}])"));
  };
  auto path = stood_on(kZigzag), given = stood_on(kGiven);
  advance(*path, 16);
  for (int frame = 1; frame <= 16; ++frame) carry(*given, shifted(zigzag(frame)));
  finish(*given);
  const auto a = given->rigid_places(), b = path->rigid_places();
  REQUIRE_OK(a);
  REQUIRE_OK(b);
  CHECK((*a)[0].place == (*b)[0].place);
  CHECK((*a)[0].velocity == (*b)[0].velocity);
  CHECK((*a)[0].place.y > 0.051 + 0.18);
}

TEST_CASE("a jump is refused with its speed, and at its full speed a ball passes through no cloth") {
  GpuFixture fixture;
  const std::string hung = R"(, "pins": ["corners"])";
  auto world = world_of(fixture.device(), over(R"("kind": "sphere", "center": [0, -0.3, 0], "radius": 0.1)",
                                               R"({"kind": "given", "speed": 20})", hung));
  CHECK(refusal(*world, 0, shifted({0, 1, 0})) ==
        "Collider 0 would go up to 1 m in a frame, at 64 m/s; its motion has a speed of 20 m/s.");
  double up = 0;
  for (int frame = 0; frame < 6; ++frame) {
    up += frame < 2 ? 20 * kFrame : 0;
    carry(*world, shifted({0, up, 0}));
  }
  finish(*world);
  CHECK(Moment(*world).mean_position().y > 0.1);  // the sheet is over the ball, 0.33 m higher than it began
  CHECK(passed(*world) == 0);
}

TEST_CASE("a state of a world that a program moves goes on elsewhere, and back") {
  GpuFixture fixture;
  const scene::Scene scene = over(kSphere, kGiven);
  auto world = world_of(fixture.device(), scene);
  for (int frame = 1; frame <= 5; ++frame) carry(*world, shifted(zigzag(frame)));
  finish(*world);
  const auto saved = world->save("test");
  REQUIRE_OK(saved);
  REQUIRE(saved->snapshot.given == std::vector{shifted(zigzag(5))});
  const auto read = sim::read_saved_state(sim::write_saved_state(*saved));
  REQUIRE_OK(read);
  const auto go_on = [](sim::World& one) {
    for (int frame = 6; frame <= 12; ++frame) carry(one, shifted(zigzag(frame)));
    finish(one);
    return hash_of(one);
  };
  const std::string whole = go_on(*world);
  auto other = world_of(fixture.device(), scene);
  const auto opened = other->open(*read);
  REQUIRE_OK(opened);
  CHECK(go_on(*other) == whole);
  const auto back = world->open(*read);
  REQUIRE_OK(back);
  CHECK(go_on(*world) == whole);
  const auto reset = world->reset();
  REQUIRE_OK(reset);
  for (int frame = 1; frame <= 5; ++frame) carry(*world, shifted(zigzag(frame)));
  CHECK(go_on(*world) == whole);
  auto spoiled = *read;
  spoiled.snapshot.given.clear();
  const auto refused = world->open(spoiled);
  REQUIRE(!refused);
  CHECK(refused.error().message == "The snapshot has 0 colliders that a program moves; this scene has 1.");
}

TEST_CASE("what is attached to a collider goes with it, and its state is taken back") {
  GpuFixture fixture;
  const std::string held = R"(, "attachments": [{"nodes": "top", "collider": 0, "reach": 0.3}])";
  auto world = world_of(fixture.device(), over(kPlate, R"({"kind": "given", "speed": 3})", held));
  const Moment rest(*world);
  const Placement place{{0.02, 0.03, 0}, turned_about_y(0.02).rotation};
  carry(*world, place);
  finish(*world);
  const auto snapshot = world->snapshot();
  REQUIRE_OK(snapshot);
  carry(*world, {});
  finish(*world);
  const auto restored = world->restore(*snapshot);
  REQUIRE_OK(restored);
  advance(*world, 2);  // it stays there
  const Moment now(*world);
  for (std::size_t node = 0; node < 9; ++node)
    CHECK(length(now.position[node] - scene::transform_of(place)(rest.position[node])) < 1e-7);
}

TEST_CASE("what set_collider cannot do is refused, and the collider stays") {
  GpuFixture fixture;
  auto world = world_of(fixture.device(), over(kPlate, kGiven));
  CHECK(world->given_colliders() == std::vector<std::size_t>{0});
  CHECK(refusal(*world, 1, {}) == "Collider 1 is not one of the 1 that a motion of kind \"given\" moves.");
  CHECK(refusal(*world, 0, {{}, {0, 0, 0, 2}}) ==
        "The rotation has length 2; a unit quaternion's is within 0.001 of 1.");
  CHECK(refusal(*world, 0, {{NAN, 0, 0}}).find("is not finite.") != std::string::npos);
  // A corner is 0.707 m from the axis; 1.5 m/s are 0.0331 rad a frame.
  const auto moved = world->set_collider(0, turned_about_y(0.0331));
  REQUIRE_OK(moved);
  CHECK(refusal(*world, 0, turned_about_y(0.0333)).find("Collider 0 would go up to 0.0235") == 0);
  const auto done = world->advance_frame();  // by what was allowed
  REQUIRE_OK(done);
  finish(*world);
  const auto snapshot = world->snapshot();
  REQUIRE_OK(snapshot);
  CHECK(snapshot->given[0] == turned_about_y(0.0331));
  auto still = world_of(fixture.device(), over(kPlate, kZigzag));
  CHECK(refusal(*still, 0, {}) == "Collider 0 is not one of the 0 that a motion of kind \"given\" moves.");
}
