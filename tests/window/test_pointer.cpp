#include "player/pointer.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "opened_player.hpp"
#include "player/keys.hpp"
#include "scene/grab.hpp"

using namespace weft;
using namespace weft::window;

TEST_CASE("the hand takes hold of the cloth under the pointer and pulls it, and beside it turns the camera") {
  Opened opened;
  Player& player = opened.player;
  Pointer pointer(player);
  pointer.move({kWidth / 2.0, kHeight / 2.0}, 0);
  REQUIRE(pointer.press(Pointer::Button::Left, false, 10));
  REQUIRE(player.world().grabbed().size() == 1);
  REQUIRE(pointer.held());
  CHECK(player.world().grabbed()[0].node == *pointer.held());
  const Vec3d before = player.world().grabbed()[0].target;
  pointer.move({kWidth / 2.0 + 20, kHeight / 2.0}, 0.01);
  REQUIRE(pointer.update());
  CHECK(player.world().grabbed()[0].target.x > before.x + 0.05);
  CHECK(player.world().grabbed()[0].target.y == doctest::Approx(before.y));
  REQUIRE(pointer.release());
  CHECK(player.world().grabbed().empty());

  const Vec3d eye = player.look().camera().eye;
  pointer.move({2, 2}, 1);
  REQUIRE(pointer.press(Pointer::Button::Left, false, 10));
  CHECK(!pointer.held());
  pointer.move({12, 2}, 1.1);
  REQUIRE(pointer.update());
  const Vec3d turned = player.look().camera().eye;
  CHECK(turned.x < eye.x);  // what is pulled to the right is the picture
  CHECK(length(turned - player.look().camera().target) == doctest::Approx(3));
  REQUIRE(pointer.release());
  REQUIRE(pointer.press(Pointer::Button::Left, true, 20));
  pointer.move({22, 2}, 1.2);
  REQUIRE(pointer.update());
  CHECK(player.look().camera().target.x < 0);
  REQUIRE(pointer.release());
  pointer.wheel(1);
  CHECK(length(player.look().camera().eye - player.look().camera().target) ==
        doctest::Approx(3 * std::exp(-0.15)));
}

TEST_CASE("what is pressed twice is pinned where it is, and pressed twice again is free") {
  Opened opened;
  Player& player = opened.player;
  Pointer pointer(player);
  pointer.move({kWidth / 2.0, kHeight / 2.0}, 0);
  const auto click = [&](double at) {
    REQUIRE(pointer.press(Pointer::Button::Left, false, at));
    REQUIRE(pointer.release());
  };
  click(1);
  CHECK(player.world().grabbed().empty());
  click(1.2);
  REQUIRE(player.pins().all().size() == 1);
  CHECK(player.world().grabbed().size() == 1);
  click(1.3);  // a third one is the first of two
  click(3);    // and this is too late to be the second
  CHECK(player.pins().all().size() == 1);
  click(3.1);
  CHECK(player.pins().all().empty());
  CHECK(player.world().grabbed().empty());
}

TEST_CASE("a pin that is pulled stays where the pointer leaves it, also where the hand comes later") {
  Opened opened;
  Player& player = opened.player;
  Pointer pointer(player);
  const Place middle = {kWidth / 2.0, kHeight / 2.0};
  pointer.move(middle, 0);
  REQUIRE(player.pins().toggle(0, 0).value() == "");
  REQUIRE(player.step());
  player.play(true);
  const auto picture = [&] {
    REQUIRE(pointer.update());
    REQUIRE(player.tick(0, true));
  };
  picture();
  REQUIRE(pointer.press(Pointer::Button::Left, false, 1));
  REQUIRE(pointer.held());
  pointer.move({middle.x + 30, middle.y}, 1);  // at once: the hand needs simulated time
  REQUIRE(pointer.release());
  const double before = player.pins().all()[0].point.x;
  for (int i = 0; i < 20; ++i) picture();
  const Vec3d pin = player.pins().all()[0].point;
  CHECK(pin.x > before + 0.05);
  CHECK(player.look().project(pin).x == doctest::Approx(2 * 30.0 / kWidth).epsilon(0.01));
}

TEST_CASE("what lets go of the cloth ends the pull, and the window goes on") {
  Opened opened;
  Player& player = opened.player;
  Pointer pointer(player);
  const auto pull = [&](double at) {
    pointer.move({kWidth / 2.0, kHeight / 2.0}, at);
    REQUIRE(pointer.press(Pointer::Button::Left, false, at));
    REQUIRE(pointer.held());
    pointer.move({kWidth / 2.0 + 9, kHeight / 2.0}, at + 0.1);
  };
  const auto is_over = [&] {
    REQUIRE(pointer.update());
    CHECK(!pointer.held());
    REQUIRE(pointer.release());
    CHECK(player.world().grabbed().empty());
  };
  pull(1);
  REQUIRE(player.reset());
  is_over();
  pull(2);
  REQUIRE(player.change({{"cloths.0.density", "0.3"}}));
  is_over();
  pull(3);
  REQUIRE(act_on_key(player, pointer, "p", false));  // the hand leaves it there
  CHECK(player.pins().all().size() == 1);
  REQUIRE(act_on_key(player, pointer, "u", false));
  is_over();
}

TEST_CASE("a rectangle pins all nodes under it where they are, and once all are pinned lets them go") {
  Opened opened;
  Player& player = opened.player;
  Pointer pointer(player);
  REQUIRE(player.step());
  const auto draw = [&](const Place& from, const Place& to) {
    pointer.move(from, 0);
    pointer.begin_area();
    pointer.move(to, 0.1);
    REQUIRE(pointer.update());
    REQUIRE(player.drawn_area);
    REQUIRE(pointer.release());
    CHECK(!player.drawn_area);
  };
  const Vec3d eye = player.look().camera().eye;
  draw({kWidth - 1.0, kHeight - 1.0}, {kWidth / 2.0, 0});  // the right half, from below
  CHECK(player.look().camera().eye.x == eye.x);
  const auto now = player.world().snapshot();
  REQUIRE(now);
  std::vector<std::uint32_t> right;  // but for the corner that the scene holds
  for (std::uint32_t node = 0; node < now->position.size(); ++node) {
    const Vec4f& at = now->position[node];
    if (at.w != 0 && player.look().project({at.x, at.y, at.z}).x >= 0) right.push_back(node);
  }
  CHECK(right.size() > 30);
  std::vector<std::uint32_t> pinned;
  for (const Pin& pin : player.pins().all()) {
    pinned.push_back(pin.node);
    CHECK(length(pin.point - now->position[pin.node].xyz().to<double>()) == 0);
  }
  std::sort(pinned.begin(), pinned.end());
  CHECK(pinned == right);
  CHECK(player.world().grabbed().size() == right.size());

  draw({0, 0}, {kWidth - 1.0, kHeight - 1.0});  // some are pinned: the others are now too
  CHECK(player.pins().all().size() == 81 - 2);
  draw({0, 0}, {kWidth - 1.0, kHeight - 1.0});
  CHECK(player.pins().all().empty());
  CHECK(player.world().grabbed().empty());
  CHECK(player.notice.sentence().empty());
  draw({0, 0}, {3, 3});
  CHECK(player.notice.sentence() == "There is no cloth to pin in the rectangle.");
  REQUIRE(act_on_key(player, pointer, "p", true));
  // At 3 m the picture is 2 · 3 m · tan 17.5° = 1.89 m high, and its middle half has seven rows of the nine, and all of
  // each, since it is wider.
  CHECK(player.pins().all().size() == 7 * 9);
}

TEST_CASE("a rectangle over more nodes than can be held pins none, and says so") {
  Opened opened;
  Player& player = opened.player;
  REQUIRE(player.open(wanted("large sheet", sheet(35))));
  REQUIRE(player.pin_within({-1, -1, 1, 1}));
  CHECK(player.pins().all().empty());
  CHECK(
      player.notice.sentence() ==
      "0 nodes are pinned, and there can be 1023, but 1223 more are meant: the core holds 1024, and the hand "
      "needs one.");
}

TEST_CASE("keys do what the page's do") {
  Opened opened;
  Player& player = opened.player;
  Pointer pointer(player);
  pointer.move({kWidth / 2.0, kHeight / 2.0}, 0);
  const auto press = [&](const std::string& key, bool shift = false) {
    const auto done = act_on_key(player, pointer, key, shift);
    REQUIRE(done);
    return *done;
  };
  CHECK(press(" "));
  CHECK(player.playing());
  CHECK(press("."));
  CHECK(!player.playing());
  CHECK(player.world().frame() == 1);
  CHECK(press("4"));
  CHECK(player.view() == scene::View::Stretch);
  CHECK(press("x"));
  CHECK(player.view() == scene::View::Wireframe);
  CHECK(press("x"));
  CHECK(player.view() == scene::View::Stretch);
  CHECK(press("6"));  // there is no contact in this scene
  CHECK(player.view() == scene::View::Stretch);
  CHECK(!player.notice.sentence().empty());
  CHECK(press("p"));
  REQUIRE(player.pins().all().size() == 1);
  CHECK(player.world().grabbed().size() == 1);
  CHECK(press("p"));
  CHECK(player.pins().all().empty());
  CHECK(press("p"));
  CHECK(press("u"));
  CHECK(player.world().grabbed().empty());
  const double x = player.look().camera().eye.x;
  CHECK(press("Right"));
  CHECK(player.look().camera().eye.x > x);
  CHECK(press("Up", true));
  CHECK(player.look().camera().target.y > 0);
  CHECK(press("+"));
  CHECK(press("f"));
  CHECK(player.look().camera().eye.x == x);
  CHECK(press("r"));
  CHECK(player.world().frame() == 0);
  CHECK(!press("q"));
}

TEST_CASE("one grab is kept for the hand") {
  Opened opened;
  Player& player = opened.player;
  REQUIRE(player.open(wanted("large sheet", sheet(35))));
  const std::uint32_t nodes = player.world().model().vertex_count();
  for (std::size_t k = 2; k < scene::kMaxGrabs; ++k)
    REQUIRE(player.world().grab(nodes - static_cast<std::uint32_t>(k), {}));
  player.pins().take(player.world().grabbed());
  CHECK(player.pins().toggle(0.1, 0.5).value() == "");  // near the upper edge, where none is pinned yet
  CHECK(player.pins().all().size() == scene::kMaxGrabs - 1);
  const auto refused = player.pins().toggle(-0.1, 0.5);
  CHECK(player.pins().all().size() == scene::kMaxGrabs - 1);
  CHECK(refused.value() ==
        "1023 nodes are pinned, and there can be 1023: the core holds 1024, and the hand needs one.");
  CHECK(player.pins().toggle(-0.99, 0.99).value() == "There is no cloth to pin there.");
}
