// Nodes that stay where they were put, as a hand would hold them. Each is a grab of the world; one of its
// grabs is kept for the hand.
#pragma once

#include <string>
#include <vector>

#include "session/session.hpp"

namespace weft::window {

struct Pin {
  std::uint32_t node = 0;
  Vec3d point;  // where it stays [m]
};

class Pins {
 public:
  explicit Pins(Session& session) : session_(session) {}

  static std::size_t most();
  const std::vector<Pin>& all() const { return pins_; }
  bool has(std::uint32_t node) const;

  /// Pins the node under (x, y) in clip coordinates where it is now, or lets it go. Why it cannot; empty: it did.
  /// Errors  DeviceLost.
  Result<std::string> toggle(double x, double y);
  /// The same for a node that the hand holds, which leaves it where it is.
  Result<std::string> toggle_held(std::uint32_t node);
  /// Pins all nodes in an area of the picture, seen or hidden, where they are now; where all are pinned that can be,
  /// lets them go. Why it cannot; empty: it did. Errors  DeviceLost.
  Result<std::string> toggle_within(const render::PickArea& area);
  /// A pinned node was pulled elsewhere, and stays there [m].
  void move(std::uint32_t node, const Vec3d& point);
  /// Errors  DeviceLost.
  Result<void> remove_all();
  /// The world holds these, and no other.
  void take(const std::vector<sim::Grabbed>& held);
  /// The world holds nothing any more.
  void forget() { pins_.clear(); }

 private:
  Result<std::string> let_go(std::uint32_t node);
  /// Why no `more` nodes can be pinned; empty: they can.
  std::string refusal(std::size_t more) const;
  /// Why the world does not hold the node; empty: it does, and the node is pinned. Errors  DeviceLost.
  Result<std::string> pin(std::uint32_t node);

  Session& session_;
  std::vector<Pin> pins_;
};

}  // namespace weft::window
