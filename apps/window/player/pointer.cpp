#include "player/pointer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "render/orbit.hpp"

namespace weft::window {
namespace {

constexpr double kHalfTurn = 3.14159265358979324;  // of the camera, for a drag over the picture's height
constexpr double kAtOnce = 3;         // frames whose reports may come together; else the hand has rested
constexpr double kWheel = 0.15;       // zoom exponent of a notch
constexpr double kTwice = 0.4;        // between two presses that are one [s]
constexpr double kTwiceDistance = 6;  // [pixel]

}  // namespace

double Pointer::simulated() const {
  return static_cast<double>(player_.world().totals().frames) * player_.facts().frame_seconds;
}
double Pointer::height() const { return player_.canvas().info().height; }

Place Pointer::clip(const Place& pixel) const {
  return {2 * pixel.x / player_.canvas().info().width - 1, 1 - 2 * pixel.y / height()};
}

Result<void> Pointer::press(Button button, bool shift, double at) {
  if (!player_.has_world() || gesture_ != Gesture::None) return {};
  last_ = place_;
  if (button != Button::Left || shift) {
    gesture_ = Gesture::Pan;
    return {};
  }
  const bool twice = at - pressed_ < kTwice && distance(pressed_place_, place_) < kTwiceDistance;
  pressed_ = twice ? -1 : at;
  pressed_place_ = place_;
  if (!twice) return take_hold();
  const Place here = clip();
  WEFT_TRY(refused, player_.pins().toggle(here.x, here.y));
  if (!refused.empty()) player_.notice.say(refused, Tone::Plain);
  return {};
}

void Pointer::begin_area() {
  if (!player_.has_world() || gesture_ != Gesture::None) return;
  gesture_ = Gesture::Area;
  last_ = place_;
}

Result<void> Pointer::take_hold() {
  gesture_ = Gesture::Orbit;
  const Place at = clip();
  WEFT_CHECK(player_.session().pick(at.x, at.y));
  const auto& picked = player_.session().picked();
  if (!picked) return {};
  if (!player_.pins().has(picked->node)) {
    const Result<void> grabbed = player_.world().grab(picked->node, picked->point);
    if (!grabbed) {  // one that is pinned or moved by the scene cannot be taken
      const ErrorKind kind = grabbed.error().kind;
      return kind == ErrorKind::Input || kind == ErrorKind::Limit ? Result<void>() : grabbed;
    }
  }
  const auto mine = [&](const Pull& pull) { return pull.node == picked->node; };
  trailing_.erase(std::remove_if(trailing_.begin(), trailing_.end(), mine), trailing_.end());
  gesture_ = Gesture::Pull;
  pull_ = Pull{picked->node, picked->point, Hand(place_), simulated()};
  return {};
}

void Pointer::move(const Place& to, double at) {
  place_ = to;
  if (pull_) pull_->hand.follow(to, at);
}

Result<void> Pointer::release() {
  const Result<void> drawn = update();
  gesture_ = Gesture::None;
  if (const auto area = std::exchange(player_.drawn_area, {}); area && drawn)
    return player_.pin_within(*area);
  if (!pull_) return drawn;
  const Pull pull = *pull_;
  pull_.reset();
  WEFT_CHECK(drawn);
  if (!player_.pins().has(pull.node)) return player_.world().release(pull.node);
  if (!pull.hand.arrived()) trailing_.push_back(pull);
  return {};
}

bool Pointer::held_in_world(std::uint32_t node) const {
  const auto& held = player_.world().grabbed();
  return std::any_of(held.begin(), held.end(), [&](const sim::Grabbed& each) { return each.node == node; });
}

Result<void> Pointer::update() {
  if (!player_.has_world()) return {};
  // A reset, another scene or a key may have let go of what was held.
  if (pull_ && !held_in_world(pull_->node)) {
    pull_.reset();
    gesture_ = Gesture::None;
  }
  const auto done = [&](const Pull& pull) { return pull.hand.arrived() || !player_.pins().has(pull.node); };
  trailing_.erase(std::remove_if(trailing_.begin(), trailing_.end(), done), trailing_.end());
  for (Pull& pull : trailing_) WEFT_CHECK(draw(pull));
  if (gesture_ == Gesture::None) return {};
  if (gesture_ == Gesture::Pull) return draw(*pull_);
  if (gesture_ == Gesture::Area) {
    const Place from = clip(last_), to = clip();
    player_.drawn_area = render::PickArea{from.x, from.y, to.x, to.y};
    return {};
  }
  const double dx = (place_.x - last_.x) / height(), dy = (place_.y - last_.y) / height();
  last_ = place_;
  if (dx == 0 && dy == 0) return {};
  const render::Camera& camera = player_.look().camera();
  player_.set_camera(gesture_ == Gesture::Orbit ? render::orbit(camera, -kHalfTurn * dx, kHalfTurn * dy)
                                                : render::pan(camera, dx, -dy));
  return {};
}

Result<void> Pointer::draw(Pull& pull) {
  const double now = simulated();
  const double passed = std::clamp(now - pull.seconds, 0.0, kAtOnce * player_.facts().frame_seconds);
  pull.seconds = now;
  // In a world that stands still, no hand is too fast.
  const Place at =
      clip(pull.hand.after(player_.playing() ? passed : std::numeric_limits<double>::infinity()));
  const Vec3d target = player_.look().point_at(at.x, at.y, pull.point);
  player_.pins().move(pull.node, target);
  return player_.world().drag(pull.node, target);
}

void Pointer::wheel(double notches) {
  if (!player_.has_world()) return;
  player_.set_camera(render::zoom(player_.look().camera(), std::exp(kWheel * notches)));
}

}  // namespace weft::window
