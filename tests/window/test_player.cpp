#include "player/player.hpp"

#include <cmath>

#include "opened_player.hpp"

using namespace weft;
using namespace weft::window;

TEST_CASE("the state after N frames is that of a run, whatever the pace of the window") {
  const std::string expected = [] {
    auto device = gpu::Device::create();
    REQUIRE(device);
    auto inputs = read(wanted("sheet", sheet(9)).scene, nullptr);
    REQUIRE(inputs);
    auto world = sim::World::create(**device, std::move(inputs->scene), inputs->assets);
    REQUIRE(world);
    for (int frame = 0; frame < 12; ++frame) {
      REQUIRE((*world)->advance_frame());
      REQUIRE((*world)->finish());
    }
    auto snapshot = (*world)->snapshot();
    REQUIRE(snapshot);
    return snapshot->hash();
  }();
  Opened counted;
  CHECK(counted.hash_after(12) == expected);
  Opened uneven;
  constexpr double kPaces[] = {0.04, 0.002, 1 / 60.0, 0.5};  // from one picture to the next [s]
  for (std::size_t picture = 0; uneven.player.world().frame() < 12; ++picture) {
    uneven.player.play(picture % 5 != 4);  // a pause now and then
    REQUIRE(uneven.player.tick(kPaces[picture % 4], false));
    REQUIRE(uneven.player.world().finish());
  }
  CHECK(uneven.player.state_hash().value() == expected);
}

TEST_CASE("one frame is simulated for each picture, and none while the cloth waits") {
  Opened opened;
  opened.player.play(true);
  const double frame = opened.player.facts().frame_seconds;
  REQUIRE(opened.player.tick(10 * frame, false));
  CHECK(opened.player.dropped_seconds() == doctest::Approx(8 * frame));
  CHECK(opened.player.world().frame() == 1);
  REQUIRE(opened.player.tick(0, false));
  CHECK(opened.player.world().frame() == 2);
  REQUIRE(opened.player.tick(0, false));
  CHECK(opened.player.world().frame() == 2);
  CHECK(opened.player.until_due() > 0);
}

TEST_CASE("a frame is stepped, and all is at rest after a reset") {
  Opened opened;
  const std::string rest = opened.hash_after(0);
  REQUIRE(opened.player.step());
  CHECK(opened.player.world().frame() == 1);
  CHECK(opened.player.state_hash().value() != rest);
  REQUIRE(opened.player.reset());
  CHECK(opened.player.state_hash().value() == rest);
}

TEST_CASE("a scene that is refused leaves the one before, with its camera") {
  Opened opened;
  opened.player.look().set_camera(render::Camera{{1, 2, 3}, {0, 0, 0}, 40});
  const auto refused = opened.player.open(wanted("bad", R"({"format": "weft-scene/1", "cloths": [{}]})"));
  REQUIRE(!refused);
  CHECK(refused.error().kind == ErrorKind::Input);
  CHECK(refused.error().message.find("bad.json") != std::string::npos);
  CHECK(opened.player.shown().name == "sheet");
  CHECK(opened.player.look().camera().eye.x == 1);
  opened.hash_after(2);
}

TEST_CASE("a parameter changes the running cloth or opens it anew, and goes back to the scene's") {
  Opened opened;
  Player& player = opened.player;
  REQUIRE(player.step());
  REQUIRE(player.change_live({{"gravity", "[0,-1,0]"}}));
  CHECK(player.world().frame() == 1);
  CHECK(player.world().scene().gravity.y == -1);
  CHECK(player.values().changed("gravity"));
  CHECK(player.values().now("gravity")->values[1].number == -1);
  CHECK(player.values().own("gravity")->values[1].number == -9.81);
  REQUIRE(player.change({{"cloths.0.density", "0.4"}}));
  CHECK(player.world().frame() == 0);
  CHECK(player.world().scene().gravity.y == -1);  // what was set stays
  CHECK(player.values().now("cloths.0.density")->number == 0.4);
  REQUIRE(player.change_live({{"gravity", std::nullopt}}));
  CHECK(player.world().scene().gravity.y == -9.81);
  CHECK(!player.values().changed("gravity"));
}

TEST_CASE(
    "a look is taken by the running cloth, in colours of its own, and a fabric takes the springs' place") {
  Opened opened;
  Player& player = opened.player;
  REQUIRE(player.step());
  REQUIRE(player.change_live({{"cloths.0.color", "[1,0,0]"}}));
  REQUIRE(player.change_live({{"cloths.0.look", "\"silk\""}}));
  CHECK(player.world().frame() == 1);
  CHECK(player.world().scene().cloths[0].look.name == "silk");
  CHECK(player.world().scene().cloths[0].color == Vec3d{1, 0, 0});  // chosen, so it stays
  REQUIRE(player.change_live({{"cloths.0.color", std::nullopt}}));
  CHECK(!player.world().scene().cloths[0].color);
  REQUIRE(player.change({{"cloths.0.fabric", "\"denim_11oz\""}}));
  CHECK(player.notice.sentence() == "");
  CHECK(player.facts().springs == 0);
  CHECK(player.facts().membranes == 2 * 8 * 8);
  CHECK(player.world().scene().cloths[0].density == 0.324);
  CHECK(player.world().scene().cloths[0].look.name == "silk");
  CHECK(player.values().now("cloths.0.density") == nullptr);
  CHECK(player.values().now("solver.kind")->text == "auto");
  REQUIRE(player.change_live({{"cloths.0.look", std::nullopt}}));
  CHECK(player.world().scene().cloths[0].look.name == "denim");
  REQUIRE(player.change({{"cloths.0.fabric", std::nullopt}}));
  CHECK(player.facts().membranes == 0);
  CHECK(player.values().now("cloths.0.density")->number == 0.2);
}

TEST_CASE("a value that is refused is said, and the cloth goes on as it was") {
  Opened opened;
  Player& player = opened.player;
  REQUIRE(player.step());
  REQUIRE(player.change_live({{"drag", "-1"}}));
  CHECK(player.notice.tone() == Tone::Error);
  CHECK(player.notice.sentence().find("drag") != std::string::npos);
  CHECK(player.world().scene().drag == 0.5);
  REQUIRE(player.change({{"cloths.0.density", "0"}}));
  CHECK(player.notice.sentence().find("density") != std::string::npos);
  CHECK(!player.values().changed("cloths.0.density"));
  CHECK(player.world().frame() == 1);
  opened.hash_after(2);
}

TEST_CASE("a canvas of another size is drawn on, and a camera that was turned stays") {
  Opened opened;
  Player& player = opened.player;
  const double far_away = player.look().camera().eye.z;
  REQUIRE(player.resize(30, 160));  // narrower than the cloth is, by this camera
  CHECK(player.canvas().info().width == 30);
  opened.hash_after(2);
  CHECK(player.look().camera().eye.z > far_away);
  for (const Vec3d& node : player.world().model().host.start_position)
    CHECK(std::abs(player.look().project(node).x) < 1);
  player.set_camera(render::Camera{{1, 2, 3}, {0, 0, 0}, 40});
  REQUIRE(player.resize(kWidth, kHeight));
  CHECK(player.look().camera().eye.x == 1);
  player.reset_camera();
  CHECK(player.look().camera().eye.z == far_away);
  REQUIRE(player.open(wanted("sheet", sheet(5))));  // the next scene is drawn there too
  opened.hash_after(2);
}
