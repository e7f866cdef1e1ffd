#include "sim/grabs.hpp"

#include <algorithm>
#include <cmath>

#include "model/grab_speed.hpp"

namespace weft::sim {
namespace {

Result<void> check_target(std::uint32_t node, const Vec3d& target) {
  if (std::isfinite(target.x) && std::isfinite(target.y) && std::isfinite(target.z)) return {};
  return input_error("The target of node %u is (%g, %g, %g) m, which is not finite.", node, target.x,
                     target.y, target.z);
}

bool ended(const scene::Grab& grab, double time) { return grab.end && *grab.end <= time; }

}  // namespace

Grabs::Grabs(const Model& model) : motion_(model.motion), scripted_(model.grabs), speed_(grab_speed(model)) {
  grabbed_.reserve(scene::kMaxGrabs);
}

std::size_t Grabs::needed_by_scene(double time) const {
  std::size_t most = 0;  // it is reached where a grab starts, or now
  for (const NodeGrab& first : scripted_) {
    if (ended(first.grab, time)) continue;
    const double from = std::max(first.grab.start, time);
    const auto grabs_then = [&](const NodeGrab& other) {
      return other.grab.start <= from && !ended(other.grab, from);
    };
    const auto count = std::count_if(scripted_.begin(), scripted_.end(), grabs_then);
    most = std::max(most, static_cast<std::size_t>(count));
  }
  return most;
}

Result<void> Grabs::check(std::uint32_t node, double time) const {
  if (node >= motion_.size())
    return input_error("Node %u cannot be grabbed: there are %zu nodes, counted from 0.", node,
                       motion_.size());
  if (motion_[node] != 0)
    return input_error("Node %u cannot be grabbed: it is %s.", node,
                       motion_[node] == 1 ? "pinned" : "moved by the scene");
  for (const Grabbed& grabbed : grabbed_)
    if (grabbed.node == node) return input_error("Node %u cannot be grabbed: it is grabbed already.", node);
  return check_scene(node, grabbed_.size(), time);
}

Result<void> Grabs::check_at(double time) const {
  for (const Grabbed& grabbed : grabbed_) WEFT_CHECK(check_scene(grabbed.node, grabbed_.size() - 1, time));
  return {};
}

Result<void> Grabs::check_scene(std::uint32_t node, std::size_t others, double time) const {
  for (const NodeGrab& other : scripted_)
    if (other.node == node && !ended(other.grab, time))
      return input_error("Node %u cannot be grabbed: %s holds it from %g s on.", node,
                         other.grab.where.c_str(), other.grab.start);
  const std::size_t needed = needed_by_scene(time);
  if (others + needed >= scene::kMaxGrabs)
    return make_error(
        ErrorKind::Limit,
        "Node %u cannot be grabbed: %zu nodes are grabbed and the scene's own grabs need %zu; the "
        "limit is %zu at once.",
        node, others, needed, scene::kMaxGrabs);
  return {};
}

Result<void> Grabs::grab(std::uint32_t node, const Vec3d& target, double time) {
  WEFT_CHECK(check(node, time));
  WEFT_CHECK(check_target(node, target));
  grabbed_.push_back({node, target});
  return {};
}

Result<Grabbed*> Grabs::find(std::uint32_t node) {
  for (Grabbed& grabbed : grabbed_)
    if (grabbed.node == node) return &grabbed;
  return input_error("Node %u is not grabbed; %zu of at most %zu nodes are.", node, grabbed_.size(),
                     scene::kMaxGrabs);
}

Result<void> Grabs::drag(std::uint32_t node, const Vec3d& target) {
  WEFT_TRY(grabbed, find(node));
  WEFT_CHECK(check_target(node, target));
  grabbed->target = target;
  return {};
}

Result<void> Grabs::release(std::uint32_t node) {
  WEFT_TRY(grabbed, find(node));
  grabbed_.erase(grabbed_.begin() + (grabbed - grabbed_.data()));
  return {};
}

bool Grabs::any(double from, double to) const {
  return !grabbed_.empty() || std::any_of(scripted_.begin(), scripted_.end(), [&](const NodeGrab& one) {
    return one.grab.start < to && !ended(one.grab, from);
  });
}

void Grabs::fill(StepBlock::Hands& hands, double dt, double time) const {
  hands.node.fill(kNoNode);
  hands.speed = static_cast<float>(speed_);
  // No more than the whole distance in a substep: the follower would swing about its target.
  hands.rate = std::min(static_cast<float>(kGrabRate), 1 / static_cast<float>(dt));
  std::size_t slot = 0;
  const auto put = [&](std::uint32_t node, const Vec3d& target) {
    hands.node[slot] = node;
    hands.goal[slot] = Vec4f::from(target.to<float>(), 0);
    ++slot;
  };
  for (const NodeGrab& one : scripted_)
    if (scene::active_at(one.grab, time)) put(one.node, scene::target_at(one.grab, time));
  for (const Grabbed& grabbed : grabbed_) put(grabbed.node, grabbed.target);
}

}  // namespace weft::sim
