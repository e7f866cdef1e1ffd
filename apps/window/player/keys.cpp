#include "player/keys.hpp"

#include "render/orbit.hpp"
#include "scene/names.hpp"

namespace weft::window {
namespace {

constexpr double kArrowTurn = 0.1;  // [radian]
constexpr double kArrowMove = 0.05, kZoom = 1.1;
constexpr double kMiddle = 0.5;  // of the picture's half width and height

bool turn_camera(Player& player, const std::string& key, bool shift) {
  const render::Camera& camera = player.look().camera();
  const auto arrow = [&](double x, double y) {
    player.set_camera(shift ? render::pan(camera, -kArrowMove * x, -kArrowMove * y)
                            : render::orbit(camera, kArrowTurn * x, kArrowTurn * y));
    return true;
  };
  if (key == "Left") return arrow(-1, 0);
  if (key == "Right") return arrow(1, 0);
  if (key == "Up") return arrow(0, 1);
  if (key == "Down") return arrow(0, -1);
  if (key == "+")
    player.set_camera(render::zoom(camera, kZoom));
  else if (key == "-")
    player.set_camera(render::zoom(camera, 1 / kZoom));
  else if (key == "f")
    player.reset_camera();
  else
    return false;
  return true;
}

Result<bool> pin_under(Player& player, const Pointer& pointer) {
  const Place at = pointer.clip();
  const auto held = pointer.held();
  WEFT_TRY(refused, held ? player.pins().toggle_held(*held) : player.pins().toggle(at.x, at.y));
  if (!refused.empty()) player.notice.say(refused, Tone::Plain);
  return true;
}

}  // namespace

Result<bool> act_on_key(Player& player, const Pointer& pointer, const std::string& key, bool shift) {
  if (!player.has_world()) return false;
  if (turn_camera(player, key, shift)) return true;
  const auto view = [&](scene::View wanted) -> Result<bool> {
    WEFT_CHECK(player.set_view(wanted));
    return true;
  };
  if (key.size() == 1 && key[0] >= '1' && key[0] < '1' + static_cast<int>(std::size(scene::kViewNames)))
    return view(static_cast<scene::View>(key[0] - '1'));
  if (key == "x")
    return view(player.view() == scene::View::Wireframe ? player.before_wireframe() : scene::View::Wireframe);
  if (key == "p" && shift) {
    WEFT_CHECK(player.pin_within({-kMiddle, -kMiddle, kMiddle, kMiddle}));
    return true;
  }
  if (key == "p") return pin_under(player, pointer);
  if (key == " ")
    player.play(!player.playing());
  else if (key == ".")
    WEFT_CHECK(player.step());
  else if (key == "r")
    WEFT_CHECK(player.reset());
  else if (key == "u")
    WEFT_CHECK(player.pins().remove_all());
  else
    return false;
  return true;
}

}  // namespace weft::window
