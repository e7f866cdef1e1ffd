#include <cmath>
#include <limits>

#include "api/scenes.hpp"

using namespace weft;

namespace {

constexpr double kGravity = 9.81;  // m/s²

std::vector<Vec3f> read(const Buffer& buffer) {
  std::vector<Vec3f> values(buffer.count());
  REQUIRE_OK(buffer.read(values));
  return values;
}

Vec3d sum(const std::vector<Vec3f>& values) {
  Vec3d all;
  for (const Vec3f& v : values) all += v.to<double>();
  return all;
}

/// kSheet without pins.
Scene free_sheet() {
  Scene scene = scene_of(kSheet);
  REQUIRE_OK(scene.set("cloths.0.pins", "[]"));
  return scene;
}

}  // namespace

TEST_CASE("a state that is set as it is goes on as if it were not") {
  World alone = world_of(scene_of(kSheet)), set = world_of(scene_of(kSheet));
  REQUIRE_OK(set.advance(3));
  REQUIRE_OK(set.set_positions(read(set.position())));
  REQUIRE_OK(set.set_velocities(read(set.velocity())));
  CHECK(hash_after(set, 3) == hash_after(alone, 6));
}

TEST_CASE("a cloth that is set elsewhere goes on from there, with its velocity") {
  World world = world_of(free_sheet());
  REQUIRE_OK(world.advance(6));
  std::vector<Vec3f> places = read(world.position());
  const Vec3d fallen = sum(places);
  for (Vec3f& place : places) place += Vec3f{2, 0.5F, 0};
  REQUIRE_OK(world.set_positions(places));
  CHECK(read(world.position()) == places);
  REQUIRE_OK(world.advance(6));
  // A fall from rest: the second half second of n frames is three times as far as the first, less the steps' rounding
  // of the speed, and moves nothing aside. Semi-implicit Euler of step h falls g t (t + h) / 2 in t.
  const double t = 6.0 / 60, h = world.describe().step_seconds;
  const Vec3d went = sum(read(world.position())) - fallen;
  CHECK(went.x / 400 == doctest::Approx(2).epsilon(1e-6).scale(0));
  CHECK(went.y / 400 == doctest::Approx(0.5 - kGravity * t * (3 * t + h) / 2).epsilon(1e-5).scale(0));
}

TEST_CASE("normals and stretch are those of the positions that were set") {
  World world = world_of(free_sheet());
  std::vector<Vec3f> places = read(world.position());
  for (Vec3f& place : places) place = {2 * place.x, place.z, 0};  // upright, and twice as wide
  REQUIRE_OK(world.set_positions(places));
  for (const Vec3f& n : read(world.normal()))
    CHECK(std::abs(n.z) == doctest::Approx(1).epsilon(1e-5).scale(0));
  std::vector<float> stretch(400);
  REQUIRE_OK(world.stretch().read(stretch));
  for (const float one : stretch) CHECK(one == doctest::Approx(2).epsilon(1e-4).scale(0));
}

TEST_CASE("the momentum of a free cloth is the sum of its impulses") {
  Scene scene = free_sheet();
  REQUIRE_OK(scene.set("gravity", "[0, 0, 0]"));
  World world = world_of(scene);
  std::vector<Vec3f> impulses(400);
  impulses[0] = {0.001F, 0.002F, 0};
  impulses[250] = {0, -0.0005F, 0.003F};
  REQUIRE_OK(world.push(impulses));
  REQUIRE_OK(world.push(impulses));
  const Vec3d given = 2.0 * sum(impulses);
  REQUIRE_OK(world.advance(3));
  // 0.2 kg; a node weighs by the area around it, so that a corner has a quarter and a side the half of the others.
  const std::vector<Vec3f> velocity = read(world.velocity());
  Vec3d momentum;
  for (int j = 0; j < 20; ++j)
    for (int i = 0; i < 20; ++i) {
      const double part = (i % 19 == 0 ? 0.5 : 1) * (j % 19 == 0 ? 0.5 : 1) / (19.0 * 19);
      momentum += 0.2 * part * velocity[20 * j + i].to<double>();
    }
  CHECK(length(momentum - given) < 1e-4 * length(given));
}

TEST_CASE("the implicit solver goes on from what is set") {
  Scene scene = free_sheet();
  REQUIRE_OK(scene.set("solver", R"({"kind": "multigrid"})"));
  REQUIRE_OK(scene.set("gravity", "[0, 0, 0]"));
  World world = world_of(scene);
  REQUIRE_OK(world.advance(2));
  REQUIRE_OK(world.set_velocities(std::vector<Vec3f>(400, {0, 3, 0})));
  const Vec3d before = sum(read(world.position()));
  REQUIRE_OK(world.advance(4));
  const Vec3d went = sum(read(world.position())) - before;
  CHECK(went.y / 400 == doctest::Approx(3 * 4.0 / 60).epsilon(1e-4).scale(0));
}

TEST_CASE("cloth that is set onto an obstacle is found there") {
  Scene scene = free_sheet();
  REQUIRE_OK(scene.set("contact", R"({"method": "proximity"})"));
  REQUIRE_OK(scene.set("colliders", R"([{"kind": "plane", "point": [0, -5, 0], "normal": [0, 1, 0]}])"));
  World world = world_of(scene);
  REQUIRE_OK(world.advance(2));
  std::vector<Vec3f> places = read(world.position());
  for (Vec3f& place : places) place.y = -4.98F;
  REQUIRE_OK(world.set_positions(places));
  REQUIRE_OK(world.set_velocities(std::vector<Vec3f>(400)));
  REQUIRE_OK(world.advance(30));
  for (const Vec3f& place : read(world.position())) CHECK(place.y > -5);
}

TEST_CASE("what cannot be set is refused, and nothing changes") {
  World world = world_of(scene_of(kSheet));
  REQUIRE_OK(world.advance(2));
  const std::string hash = hash_after(world, 0);
  const auto refuses = [&](const Result<void>& result, ErrorKind kind, const std::string& sentence) {
    REQUIRE(!result);
    CHECK(result.error().kind == kind);
    CHECK(result.error().message == sentence);
  };
  std::vector<Vec3f> places = read(world.position());
  refuses(world.set_velocities(std::vector<Vec3f>(399)), ErrorKind::Shape,
          "399 velocities do not fit 400 nodes.");
  refuses(world.push(std::vector<Vec3f>(1)), ErrorKind::Shape, "1 impulses do not fit 400 nodes.");
  places[0].y += 0.5F;
  refuses(world.set_positions(places), ErrorKind::Input,
          "Node 0 is pinned or moved, and stays at (-0.5, 0, -0.5), not (-0.5, 0.5, -0.5).");
  places[0].y -= 0.5F;
  places[7].z = std::numeric_limits<float>::quiet_NaN();
  const auto refused = world.set_positions(places);
  REQUIRE(!refused);
  CHECK(refused.error().message.find("Number 7 of the positions is not finite: (") == 0);
  CHECK(hash_after(world, 0) == hash);
}

namespace {

/// The upper row is the program's; 2 m/s are a thirtieth of a metre a frame.
Scene held_sheet() {
  Scene scene = scene_of(kSheet);
  REQUIRE_OK(scene.set("cloths.0.pins", "[]"));
  REQUIRE_OK(scene.set("cloths.0.motions", R"([{"kind": "given", "nodes": "top", "speed": 2}])"));
  return scene;
}

}  // namespace

TEST_CASE("nodes that a program moves go where it takes them, and stay there") {
  World world = world_of(held_sheet());
  const std::vector<std::uint32_t> nodes = world.given_nodes();
  REQUIRE(nodes.size() == 20);
  const std::vector<Vec3f> rest = read(world.position());
  std::vector<Vec3f> places;
  for (const std::uint32_t node : nodes) places.push_back(rest[node]);
  REQUIRE_OK(world.advance(2));
  for (int frame = 0; frame < 5; ++frame) {
    for (std::size_t k = 0; k < nodes.size(); ++k)
      places[k] += Vec3f{0, 0.03F, 0.0005F * static_cast<float>(k)};
    REQUIRE_OK(world.move(nodes, places));
    REQUIRE_OK(world.advance());
    const std::vector<Vec3f> now = read(world.position()), velocity = read(world.velocity());
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      CHECK(length(now[nodes[k]] - places[k]) < 2e-7F);
      // Of the last substep: places below 1 m round by 6e-8 m.
      CHECK(velocity[nodes[k]].y ==
            doctest::Approx(60 * 0.03).epsilon(2 * 6e-8 / world.describe().step_seconds));
    }
  }
  REQUIRE_OK(world.advance(3));
  std::vector<Vec3f> now = read(world.position());
  for (std::size_t k = 0; k < nodes.size(); ++k) CHECK(length(now[nodes[k]] - places[k]) < 2e-7F);
  REQUIRE_OK(
      world.move(std::span(nodes).first(1), std::span(places).first(1)));  // some may move without the others
  REQUIRE_OK(world.reset());
  REQUIRE_OK(world.advance(1));
  now = read(world.position());
  for (const std::uint32_t node : nodes) CHECK(now[node] == rest[node]);
}

TEST_CASE("nodes that a program moves evenly take their cloth where a path does") {
  World given = world_of(held_sheet());
  Scene with_path = held_sheet();
  REQUIRE_OK(with_path.set("cloths.0.motions",
                           R"([{"kind": "path", "nodes": "top", "points": [[1, [0, 1.5, 0]]]}])"));
  World path = world_of(with_path);
  const std::vector<std::uint32_t> nodes = given.given_nodes();
  const std::vector<Vec3f> rest = read(given.position());
  for (int frame = 1; frame <= 4; ++frame) {
    std::vector<Vec3f> places;
    for (const std::uint32_t node : nodes) places.push_back(rest[node] + Vec3f{0, 1.5F * frame / 60, 0});
    REQUIRE_OK(given.move(nodes, places));
    REQUIRE_OK(given.advance());
  }
  REQUIRE_OK(path.advance(4));
  const std::vector<Vec3f> a = read(given.position()), b = read(path.position());
  // f32 of the offsets differ in their last bits, 4e-9 m; springs carry that on.
  for (std::size_t node = 0; node < a.size(); ++node) CHECK(length(a[node] - b[node]) < 2e-6F);
}

TEST_CASE("a program may move nodes as fast as their motion says, and no faster") {
  Scene scene = held_sheet();
  REQUIRE_OK(scene.set("contact", R"({"method": "proximity"})"));
  REQUIRE_OK(scene.set("time.substeps", "4"));
  REQUIRE_OK(scene.set("solver", R"({"kind": "multigrid"})"));
  World slow = world_of(scene);
  REQUIRE_OK(scene.set("cloths.0.motions.0.speed", "50"));
  World fast = world_of(scene);
  const std::vector<std::uint32_t> nodes = fast.given_nodes();
  std::vector<Vec3f> rest = read(fast.position()), places;
  for (const std::uint32_t node : nodes) places.push_back(rest[node] + Vec3f{0, 0.5F, 0});
  const auto refused = slow.move(nodes, places);
  REQUIRE(!refused);
  CHECK(refused.error().kind == ErrorKind::Input);
  CHECK(refused.error().message ==
        "Node 0 would go 0.5 m in a frame, at 30 m/s; its motion has a speed of 2 m/s.");
  REQUIRE_OK(fast.move(nodes, places));
  REQUIRE_OK(fast.advance());
  rest = read(fast.position());
  for (std::size_t k = 0; k < nodes.size(); ++k) CHECK(length(rest[nodes[k]] - places[k]) < 2e-7F);
}

TEST_CASE("only nodes that are given can be moved") {
  World world = world_of(held_sheet());
  const std::vector<std::uint32_t> free = {0, 200};
  const auto refused = world.move(free, std::vector<Vec3f>(2, {-0.5F, 0, -0.5F}));
  REQUIRE(!refused);
  CHECK(refused.error().message == "Node 200 is not one of the 20 that a motion of kind \"given\" holds.");
  CHECK(world.move(free, {}).error().kind == ErrorKind::Shape);
  REQUIRE_OK(world.advance(1));
  CHECK(read(world.position())[0] == Vec3f{-0.5F, 0, -0.5F});
  World pinned = world_of(scene_of(kSheet));
  CHECK(pinned.given_nodes().empty());
}

namespace {

/// kSheet, soft enough for eight substeps, over a collider with this motion; times are exact, and 1.5 m/s are 3/128 m a
/// frame.
World over(const std::string& collider, const std::string& motion) {
  Scene scene = scene_of(kSheet);
  REQUIRE_OK(scene.set("time", R"({"frame": 0.015625, "substeps": 8})"));
  REQUIRE_OK(scene.set("cloths.0.stiffness", R"({"structural": 40, "shear": 10, "bend": 0.3})"));
  REQUIRE_OK(scene.set("cloths.0.damping", "0.005"));
  REQUIRE_OK(scene.set("contact", R"({"method": "proximity"})"));
  REQUIRE_OK(scene.set("colliders", "[{" + collider + R"(, "motion": )" + motion + "}]"));
  REQUIRE_OK(scene.set("render", R"({"size": [160, 100]})"));
  REQUIRE_OK(scene.set("camera", R"({"eye": [1, 1, 2], "target": [0, 0, 0]})"));
  return world_of(scene);
}

}  // namespace

TEST_CASE("a collider that a program carries is felt and drawn where a path takes it") {
  for (const std::string collider : {R"("kind": "sphere", "center": [0, -0.25, 0], "radius": 0.2)",
                                     R"("kind": "plane", "point": [0, -0.1, 0], "normal": [0, 1, 0])"}) {
    INFO(collider);
    World path = over(collider, R"({"kind": "path", "points": [[1, [0, 1.5, 0]]]})");
    World given = over(collider, R"({"kind": "given", "speed": 1.5})");
    const auto still = given.draw();
    REQUIRE_OK(still);
    CHECK(given.given_colliders() == std::vector<std::size_t>{0});
    for (int frame = 1; frame <= 8; ++frame) {
      REQUIRE_OK(given.set_collider(0, {{0, 1.5 * frame / 64, 0}}));
      REQUIRE_OK(given.advance());
    }
    CHECK(hash_after(given, 0) == hash_after(path, 8));
    const auto a = given.draw(), b = path.draw();
    REQUIRE_OK(a);
    REQUIRE_OK(b);
    CHECK(a->rgba == b->rgba);
    CHECK(a->rgba != still->rgba);
    REQUIRE_OK(given.reset());  // it is where the scene puts it, and drawn there
    const auto back = given.draw();
    REQUIRE_OK(back);
    CHECK(back->rgba == still->rgba);
  }
}

TEST_CASE("a collider is where a saved state has it") {
  const std::string ball = R"("kind": "sphere", "center": [0, -0.25, 0], "radius": 0.2)",
                    motion = R"({"kind": "given", "speed": 1.5})";
  World world = over(ball, motion), other = over(ball, motion);
  for (int frame = 1; frame <= 4; ++frame) {
    REQUIRE_OK(world.set_collider(0, {{0, 1.5 * frame / 64, 0}}));
    REQUIRE_OK(world.advance());
  }
  const auto bytes = world.save_state();
  REQUIRE_OK(bytes);
  REQUIRE_OK(other.open_state(*bytes));
  CHECK(hash_after(other, 6) == hash_after(world, 6));
  const auto a = world.draw(), b = other.draw();
  REQUIRE_OK(a);
  REQUIRE_OK(b);
  CHECK(a->rgba == b->rgba);
}

TEST_CASE("a collider goes no faster than its motion says, and only where a rigid thing can be") {
  World world = over(R"("kind": "sphere", "center": [0, -0.25, 0], "radius": 0.2)",
                     R"({"kind": "given", "speed": 1.5})");
  const auto refuses = [&](std::size_t collider, const Placement& placement, const std::string& sentence) {
    const auto refused = world.set_collider(collider, placement);
    REQUIRE(!refused);
    CHECK(refused.error().kind == ErrorKind::Input);
    CHECK(refused.error().message == sentence);
  };
  refuses(0, {{0, 0.5, 0}},
          "Collider 0 would go up to 0.5 m in a frame, at 32 m/s; its motion has a speed of 1.5 m/s.");
  refuses(2, {}, "Collider 2 is not one of the 1 that a motion of kind \"given\" moves.");
  refuses(0, {{}, {1, 1, 0, 0}},
          "The rotation has length 1.41421; a unit quaternion's is within 0.001 of 1.");
  World none = world_of(scene_of(kSheet));
  CHECK(none.given_colliders().empty());
}
