#include "player/pins.hpp"

#include <algorithm>

#include "scene/grab.hpp"

namespace weft::window {

std::size_t Pins::most() { return scene::kMaxGrabs - 1; }

bool Pins::has(std::uint32_t node) const {
  return std::any_of(pins_.begin(), pins_.end(), [&](const Pin& pin) { return pin.node == node; });
}

Result<std::string> Pins::let_go(std::uint32_t node) {
  pins_.erase(std::find_if(pins_.begin(), pins_.end(), [&](const Pin& pin) { return pin.node == node; }));
  WEFT_CHECK(session_.world()->release(node));
  return std::string();
}

std::string Pins::refusal(std::size_t more) const {
  if (pins_.size() + more <= most()) return {};
  return std::to_string(pins_.size()) + " nodes are pinned, and there can be " + std::to_string(most()) +
         (more > 1 ? ", but " + std::to_string(more) + " more are meant" : "") + ": the core holds " +
         std::to_string(scene::kMaxGrabs) + ", and the hand needs one.";
}

Result<std::string> Pins::pin(std::uint32_t node) {
  const Vec4f& at = session_.snapshot().position[node];
  const Vec3d point{at.x, at.y, at.z};
  if (const Result<void> grabbed = session_.world()->grab(node, point); !grabbed) {
    const ErrorKind kind = grabbed.error().kind;
    if (kind != ErrorKind::Input && kind != ErrorKind::Limit) return grabbed.error();
    return grabbed.error().message;
  }
  pins_.push_back({node, point});
  return std::string();
}

Result<std::string> Pins::toggle(double x, double y) {
  WEFT_CHECK(session_.pick(x, y));
  if (!session_.picked()) return std::string("There is no cloth to pin there.");
  const std::uint32_t node = session_.picked()->node;
  if (has(node)) return let_go(node);
  if (std::string why = refusal(1); !why.empty()) return why;
  return pin(node);
}

Result<std::string> Pins::toggle_within(const render::PickArea& area) {
  WEFT_CHECK(session_.pick_within(area));
  std::vector<std::uint32_t> loose, pinned;
  for (const std::uint32_t node : session_.picked_within())
    if (has(node))
      pinned.push_back(node);
    else if (session_.snapshot().position[node].w != 0)
      loose.push_back(node);
  if (loose.empty() && pinned.empty()) return std::string("There is no cloth to pin in the rectangle.");
  if (std::string why = loose.empty() ? std::string() : refusal(loose.size()); !why.empty()) return why;
  std::string last;
  const std::size_t before = pins_.size();
  for (const std::uint32_t node : loose) {
    WEFT_TRY(why, pin(node));
    if (!why.empty()) last = why;
  }
  if (pins_.size() > before) return std::string();
  if (pinned.empty()) return last;
  for (const std::uint32_t node : pinned) WEFT_CHECK(let_go(node));
  return std::string();
}

Result<std::string> Pins::toggle_held(std::uint32_t node) {
  if (has(node)) return let_go(node);
  if (std::string why = refusal(1); !why.empty()) return why;
  for (const sim::Grabbed& held : session_.world()->grabbed())
    if (held.node == node) pins_.push_back({node, held.target});
  return std::string();
}

void Pins::move(std::uint32_t node, const Vec3d& point) {
  for (Pin& pin : pins_)
    if (pin.node == node) pin.point = point;
}

Result<void> Pins::remove_all() {
  for (const Pin& pin : pins_) WEFT_CHECK(session_.world()->release(pin.node));
  pins_.clear();
  return {};
}

void Pins::take(const std::vector<sim::Grabbed>& held) {
  pins_.clear();
  for (const sim::Grabbed& each : held) pins_.push_back({each.node, each.target});
}

}  // namespace weft::window
