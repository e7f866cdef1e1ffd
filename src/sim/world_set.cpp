// What a host sets in a running scene.
#include <algorithm>
#include <cmath>

#include "scene/motion.hpp"
#include "scene/screw.hpp"
#include "sim/world.hpp"

namespace weft::sim {
namespace {

bool finite(const Vec3f& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

constexpr double kSpeedRounding = 1e-5;  // of places in f32 that a program spaces by the speed itself

/// One vector for each node, all finite. Errors  Shape, Input.
Result<void> check_values(std::span<const Vec3f> values, std::size_t nodes, const char* what) {
  if (values.size() != nodes) return shape_error("%zu %s do not fit %zu nodes.", values.size(), what, nodes);
  for (std::size_t k = 0; k < nodes; ++k)
    if (!finite(values[k]))
      return input_error("Number %zu of the %s is not finite: (%g, %g, %g).", k, what, values[k].x,
                         values[k].y, values[k].z);
  return {};
}

/// Frames that have not reported may be repeated: their ways are kept.
constexpr std::uint32_t kKeptFrames = 4;

}  // namespace

Result<void> World::set_positions(std::span<const Vec3f> positions) {
  WEFT_CHECK(check_values(positions, model_.vertex_count(), "positions"));
  WEFT_CHECK(finish());
  WEFT_TRY(now, node_state());
  for (std::size_t node = 0; node < positions.size(); ++node) {
    Vec4f& place = now.position[node];
    const Vec3f& wanted = positions[node];
    if (model_.host.kinematic(node) && wanted != place.xyz())
      return input_error("Node %zu is pinned or moved, and stays at (%g, %g, %g), not (%g, %g, %g).", node,
                         place.x, place.y, place.z, wanted.x, wanted.y, wanted.z);
    place = Vec4f::from(wanted, place.w);
  }
  // Pairs that act are those of the places before.
  WEFT_CHECK(contact_.set_forces(device_, state_, {}));
  const std::vector<std::int32_t> no_holds(std::size_t{kHoldWords} * model_.vertex_count());
  contact_.set_hold_forces(device_, no_holds);
  last_good_->renew_holds(device_, no_holds);
  return write_state(now);
}

Result<void> World::set_velocities(std::span<const Vec3f> velocities) {
  WEFT_CHECK(check_values(velocities, model_.vertex_count(), "velocities"));
  WEFT_CHECK(finish());
  WEFT_TRY(now, node_state());
  for (std::size_t node = 0; node < velocities.size(); ++node)
    if (!model_.host.kinematic(node)) now.velocity[node] = Vec4f::from(velocities[node], 0);
  return write_state(now);
}

Result<void> World::push(std::span<const Vec3f> impulses) {
  WEFT_CHECK(check_values(impulses, model_.vertex_count(), "impulses"));
  WEFT_CHECK(finish());
  WEFT_TRY(now, node_state());
  for (std::size_t node = 0; node < impulses.size(); ++node) {
    const float inverse_mass = now.position[node].w;  // of a kinematic node 0
    now.velocity[node] = Vec4f::from(now.velocity[node].xyz() + inverse_mass * impulses[node], 0);
  }
  return write_state(now);
}

const scene::MotionGiven* World::given(std::size_t node) const {
  const std::uint32_t motion = model_.host.motion[node];
  return motion < 2 ? nullptr : std::get_if<scene::MotionGiven>(&model_.host.motions[motion - 2].shape);
}

void World::set_given(std::size_t node, const scene::MotionGiven& way) {
  model_.host.motions[model_.host.motion[node] - 2].shape = way;
}

std::vector<std::uint32_t> World::given_nodes() const {
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t node = 0; node < model_.vertex_count(); ++node)
    if (given(node) != nullptr) nodes.push_back(node);
  return nodes;
}

Result<void> World::move(std::span<const std::uint32_t> nodes, std::span<const Vec3f> places) {
  WEFT_CHECK(check_values(places, nodes.size(), "places"));
  WEFT_CHECK(finish());
  const double begin = time(), frame = scene_.time.frame;
  std::vector<scene::MotionGiven> ways;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const scene::MotionGiven* before = nodes[k] < model_.vertex_count() ? given(nodes[k]) : nullptr;
    if (before == nullptr)
      return input_error("Node %u is not one of the %zu that a motion of kind \"given\" holds.", nodes[k],
                         given_nodes().size());
    const Vec3d from = scene::motion_at(*before, begin).translation;
    const Vec3d to = places[k].to<double>() - model_.host.rest_position[nodes[k]];
    const double speed = length(to - from) / frame;
    if (speed > before->speed * (1 + kSpeedRounding))
      return input_error("Node %u would go %g m in a frame, at %g m/s; its motion has a speed of %g m/s.",
                         nodes[k], length(to - from), speed, before->speed);
    ways.push_back({before->speed, begin, begin + frame, from, to});
  }
  for (std::size_t k = 0; k < nodes.size(); ++k) set_given(nodes[k], ways[k]);
  return {};
}

std::vector<std::size_t> World::given_colliders() const {
  std::vector<std::size_t> colliders;
  for (std::size_t c = 0; c < scene_.colliders.size(); ++c)
    if (scene::carried_of(scene_.colliders[c]) != nullptr) colliders.push_back(c);
  return colliders;
}

void World::set_ways(std::size_t collider, const std::vector<scene::CarriedWay>& ways) {
  scene::carried_of(scene_.colliders[collider])->ways = ways;
  for (scene::Motion& motion : model_.host.motions) {
    auto* tied = std::get_if<scene::MotionCarried>(&motion.shape);
    if (tied != nullptr && tied->collider == collider) tied->ways = ways;
  }
}

Result<void> World::set_collider(std::size_t collider, const Placement& placement) {
  const scene::MotionCarried* motion =
      collider < scene_.colliders.size() ? scene::carried_of(scene_.colliders[collider]) : nullptr;
  if (motion == nullptr)
    return input_error("Collider %zu is not one of the %zu that a motion of kind \"given\" moves.", collider,
                       given_colliders().size());
  WEFT_TRY(to, scene::checked_placement(placement));
  const double begin = time(), frame = scene_.time.frame;
  std::vector<scene::CarriedWay> ways = motion->ways;
  Placement from = ways.empty() ? Placement{} : ways.back().to;
  if (!ways.empty() && ways.back().begin == begin) {  // it was set for this frame already
    from = ways.back().from;
    ways.pop_back();
  }
  const scene::Screw way(from, to);
  const scene::RigidTransform start = scene::transform_of(from);
  double most = 0;  // along a screw, the speed is convex in the point
  for (const Vec3d& corner : extents_[collider].corners())
    most = std::max(most, way.length_of(start(corner)));
  if (most / frame > motion->speed * (1 + kSpeedRounding))
    return input_error(
        "Collider %zu would go up to %g m in a frame, at %g m/s; its motion has a speed of %g m/s.", collider,
        most, most / frame, motion->speed);
  const double kept = plan_.begin_of(frame_ - std::min(frame_, kKeptFrames));
  ways.erase(ways.begin(),
             std::find_if(ways.begin(), ways.end(), [&](const auto& old) { return old.end > kept; }));
  ways.push_back({begin, begin + frame, from, to});
  set_ways(collider, ways);
  return {};
}

Result<void> World::write_state(NodeState& state) {
  for (Vec4f& velocity : state.velocity) velocity.w = 0;  // the state before leads elsewhere
  state_.position[parity_].write(device_, state.position);
  state_.velocity[parity_].write(device_, state.velocity);
  last_good_->renew(device_, state.position, state.velocity, 0);
  return submit_surface();  // for what is drawn before the next frame
}

}  // namespace weft::sim
