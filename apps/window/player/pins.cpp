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

std::string Pins::refusal() const {
  if (pins_.size() < most()) return {};
  return std::to_string(pins_.size()) + " nodes are pinned, and there can be " + std::to_string(most()) +
         ": the core holds " + std::to_string(scene::kMaxGrabs) + ", and the hand needs one.";
}

Result<std::string> Pins::toggle(double x, double y) {
  WEFT_CHECK(session_.pick(x, y));
  if (!session_.picked()) return std::string("There is no cloth to pin there.");
  const std::uint32_t node = session_.picked()->node;
  if (has(node)) return let_go(node);
  if (std::string why = refusal(); !why.empty()) return why;
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

Result<std::string> Pins::toggle_held(std::uint32_t node) {
  if (has(node)) return let_go(node);
  if (std::string why = refusal(); !why.empty()) return why;
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
