#include <array>
#include <cmath>
#include <thread>

#include "api/scenes.hpp"
#include "scene/load.hpp"
#include "sim/world.hpp"

using namespace weft;

TEST_CASE("a world ends in the bits of the engine's own") {
  auto device = gpu::Device::create();
  REQUIRE_OK(device);
  auto scene = scene::parse_scene(kSheet, "sheet");
  REQUIRE_OK(scene);
  auto assets = load_assets(*scene, std::string());
  REQUIRE_OK(assets);
  auto inner = sim::World::create(**device, *scene, *assets);
  REQUIRE_OK(inner);
  for (int frame = 0; frame < 5; ++frame) {
    const auto advanced = (*inner)->advance_frame();
    REQUIRE_OK(advanced);
  }
  const auto finished = (*inner)->finish();
  REQUIRE_OK(finished);
  const auto snapshot = (*inner)->snapshot();
  REQUIRE_OK(snapshot);

  World world = world_of(scene_of(kSheet));
  CHECK(hash_after(world, 5) == snapshot->hash());
  CHECK(world.totals().frames == 5);
  CHECK(world.frame() == 5);
  CHECK(world.time() == doctest::Approx(5.0 / 60));

  std::vector<Vec3f> positions(world.position().count());
  const auto read = world.position().read(positions);
  REQUIRE_OK(read);
  REQUIRE(positions.size() == snapshot->position.size());
  for (std::size_t node = 0; node < positions.size(); ++node)
    CHECK(positions[node] == snapshot->position[node].xyz());
}

TEST_CASE(
    "a world goes on from saved bytes to the same bits, hand and all, and refuses those of another scene") {
  World world = world_of(scene_of(kSheet));
  hash_after(world, 3);
  REQUIRE(world.grab(210, {0, 1, 0}));
  hash_after(world, 2);
  const auto bytes = world.save_state();
  REQUIRE_OK(bytes);
  const std::string hash = hash_after(world, 3);
  World other = world_of(scene_of(kSheet));
  const auto opened = other.open_state(*bytes);
  REQUIRE_OK(opened);
  CHECK(*opened);
  CHECK(other.frame() == 5);
  CHECK(other.totals().frames == 5);
  CHECK(hash_after(other, 3) == hash);
  CHECK(other.release(210));
  const std::string before = hash_after(other, 0);
  const auto cut = other.open_state(std::span(*bytes).first(100));
  REQUIRE(!cut);
  CHECK(cut.error().kind == ErrorKind::Input);
  Scene heavier = scene_of(kSheet);
  REQUIRE(heavier.set("cloths.0.density", "0.3"));
  World wrong = world_of(heavier);
  CHECK(wrong.open_state(*bytes).error().message.find("The saved state is of another scene: its hash is ") ==
        0);
  CHECK(hash_after(other, 0) == before);
}

TEST_CASE("a buffer is read whole or not at all") {
  World world = world_of(scene_of(kSheet));
  CHECK(world.normal().count() == 400);
  CHECK(world.normal().width() == 3);
  CHECK(world.stretch().width() == 1);
  std::vector<float> values(400);
  const auto wrong = world.normal().read(values);
  REQUIRE(!wrong);
  CHECK(wrong.error().kind == ErrorKind::Shape);
  CHECK(wrong.error().message == "A buffer of 400 x 3 floats does not fit 400 values.");
  std::vector<Vec3f> vectors(400);
  CHECK(world.stretch().read(vectors).error().kind == ErrorKind::Shape);

  const auto stretch = world.stretch().read(values);  // at rest: rounding of f32 apart, 1
  REQUIRE_OK(stretch);
  for (const float one : values) CHECK(one == doctest::Approx(1).epsilon(1e-5).scale(0));
  const auto normal = world.normal().read(vectors);  // the sheet lies flat
  REQUIRE_OK(normal);
  for (const Vec3f& n : vectors) CHECK(std::abs(n.y) == doctest::Approx(1).epsilon(1e-5).scale(0));
}

TEST_CASE("a buffer stays valid when its world is moved") {
  World world = world_of(scene_of(kSheet));
  const Buffer position = world.position();
  World moved = std::move(world);
  const std::string hash = hash_after(moved, 1);
  std::vector<Vec3f> before(400), after(400);
  REQUIRE_OK(position.read(before));
  REQUIRE_OK(moved.position().read(after));
  CHECK(before == after);
}

TEST_CASE("a change acts, a refused one does not, and reset keeps the first") {
  World plain = world_of(scene_of(kSheet)), changed = world_of(scene_of(kSheet));
  REQUIRE_OK(changed.change("gravity", "[0, -1.62, 0]"));
  const auto refused = changed.change("cloths.0.density", "0.3");
  REQUIRE(!refused);
  CHECK(refused.error().kind == ErrorKind::Input);
  CHECK(refused.error().message.find("cloths[0].density cannot change") == 0);
  const std::string moon = hash_after(changed, 3);
  CHECK(moon != hash_after(plain, 3));
  REQUIRE_OK(changed.reset());
  CHECK(changed.time() == 0);
  CHECK(hash_after(changed, 3) == moon);
}

TEST_CASE("a grabbed node goes where it is pulled") {
  World world = world_of(scene_of(kSheet));
  const std::uint32_t node = 19 * 20 + 10;  // in the free row
  CHECK(world.drag(node, {}).error().kind == ErrorKind::Input);
  CHECK(world.grab(0, {}).error().kind == ErrorKind::Input);  // pinned
  std::vector<Vec3f> positions(400);
  REQUIRE_OK(world.position().read(positions));
  const Vec3d target = positions[node].to<double>() + Vec3d{0, 0.1, 0};
  REQUIRE_OK(world.grab(node, target));
  REQUIRE_OK(world.advance(30));
  REQUIRE_OK(world.position().read(positions));
  // kGrabRate is 20 1/s, so after 0.5 s e^-10 of the 0.1 m is left; positions below 1 m round by 6e-8.
  CHECK(length(positions[node].to<double>() - target) < 0.1 * std::exp(-10) + 1e-6);
  REQUIRE_OK(world.release(node));
}

TEST_CASE("a world that diverges says so, and shows its last good state") {
  Scene scene = scene_of(kSheet);
  REQUIRE_OK(scene.set("cloths.0.stiffness", R"({ "structural": 1e8, "shear": 1e8, "bend": 1e8 })"));
  REQUIRE_OK(scene.set("time.substeps", "1"));
  World world = world_of(scene);
  auto ended = world.advance(300);
  if (ended) ended = world.finish();
  REQUIRE(!ended);
  CHECK(ended.error().kind == ErrorKind::Diverged);
  std::vector<float> values(3 * 400);
  REQUIRE_OK(world.position().read(values));
  for (const float value : values) CHECK(std::isfinite(value));
}

TEST_CASE("a picture has the size and the view that were asked for, and the same state the same picture") {
  World world = world_of(scene_of(kSheet));
  PictureOptions options;
  options.width = 160;
  options.height = 90;
  auto first = world.draw(options), again = world.draw(options);
  REQUIRE_OK(first);
  REQUIRE_OK(again);
  CHECK(first->width == 160);
  CHECK(first->height == 90);
  CHECK(first->rgba.size() == 4 * 160 * 90);
  CHECK(first->rgba == again->rgba);

  options.view = View::Normals;
  auto normals = world.draw(options);
  REQUIRE_OK(normals);
  CHECK(normals->rgba != first->rgba);

  options.view.reset();
  options.camera = Camera{{0, 5, 0.1}, {0, 0, 0}, 20};
  auto above = world.draw(options);
  REQUIRE_OK(above);
  CHECK(above->rgba != first->rgba);
  options.camera.reset();
  auto back = world.draw(options);
  REQUIRE_OK(back);
  CHECK(back->rgba == first->rgba);

  options.width = 0;
  CHECK(world.draw(options).error().kind == ErrorKind::Input);
}

TEST_CASE("an adapter of a name that no adapter has is missed by that name") {
  const auto found = adapters();
  REQUIRE_OK(found);
  REQUIRE(!found->empty());
  World world = world_of(scene_of(kSheet));
  CHECK(!world.adapter().name.empty());
  const auto none = World::create(scene_of(kSheet), {.adapter = "no such card"});
  REQUIRE(!none);
  CHECK(none.error().kind == ErrorKind::NoAdapter);
  CHECK(none.error().message.find("no such card") != std::string::npos);
}

TEST_CASE("worlds on two threads end in the bits of one alone") {
  World alone = world_of(scene_of(kSheet));
  const std::string expected = hash_after(alone, 10);
  std::array<std::string, 2> hashes;
  std::array<std::thread, 2> threads;
  for (std::size_t k = 0; k < 2; ++k)
    threads[k] = std::thread([&, k] {
      auto world = World::create(scene_of(kSheet));
      if (!world || !world->advance(10)) return;
      if (auto hash = world->state_hash()) hashes[k] = *hash;
    });
  for (std::thread& thread : threads) thread.join();
  CHECK(hashes[0] == expected);
  CHECK(hashes[1] == expected);
}
