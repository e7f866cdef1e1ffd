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

Vec4f goal(const Vec3d& target) { return Vec4f::from(target.to<float>(), 1); }

bool ended(const scene::Grab& grab, double time) { return grab.end && *grab.end <= time; }

}  // namespace

std::size_t most_scripted(const Model& model, double frame) {
  std::vector<scene::Hold> holds;
  for (const NodeGrab& one : model.grabs) {
    scene::Hold hold = scene::hold_of(one.grab);
    hold.start -= 2 * frame;  // begins of frames that it acts in, and what rounding could add
    holds.push_back(hold);
  }
  return scene::most_at_once(std::move(holds)).count;
}

Grabs::Grabs(const Model& model) : motion_(model.motion), scripted_(model.grabs), speed_(grab_speed(model)) {
  std::stable_sort(scripted_.begin(), scripted_.end(),
                   [](const NodeGrab& a, const NodeGrab& b) { return a.node < b.node; });
}

std::size_t Grabs::needed_by_scene(double time) const {
  std::vector<scene::Hold> holds;
  for (const NodeGrab& one : scripted_) {
    if (ended(one.grab, time)) continue;
    holds.push_back(scene::hold_of(one.grab));
    holds.back().start = std::max(holds.back().start, time);
  }
  return scene::most_at_once(std::move(holds)).count;
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

void Grabs::find(double from, double to, FrameGrabs& found) const {
  found.nodes.clear();
  found.still.clear();
  found.moving.clear();
  found.scripted.clear();
  found.slots.clear();
  for (const Grabbed& grabbed : grabbed_) {
    found.nodes.push_back(grabbed.node);
    found.still.push_back(goal(grabbed.target));
  }
  for (std::size_t k = 0; k < scripted_.size(); ++k) {
    const NodeGrab& one = scripted_[k];
    if (one.grab.start >= to || ended(one.grab, from)) continue;
    const bool again = !found.scripted.empty() && scripted_[found.scripted.back()].node == one.node;
    if (!again) found.nodes.push_back(one.node);
    found.scripted.push_back(k);
    found.slots.push_back(found.nodes.size() - found.still.size() - 1);
  }
}

void Grabs::append_goals(FrameGrabs& found, double time) const {
  const std::size_t first = found.moving.size();
  found.moving.resize(first + found.nodes.size() - found.still.size());
  for (std::size_t k = 0; k < found.scripted.size(); ++k) {
    const scene::Grab& grab = scripted_[found.scripted[k]].grab;
    if (scene::active_at(grab, time))
      found.moving[first + found.slots[k]] = goal(scene::target_at(grab, time));
  }
}

void Grabs::fill(StepBlock::Hands& hands, double dt) const {
  hands.speed = static_cast<float>(speed_);
  // No more than the whole distance in a substep: the follower would swing about its target.
  hands.rate = std::min(static_cast<float>(kGrabRate), 1 / static_cast<float>(dt));
}

}  // namespace weft::sim
