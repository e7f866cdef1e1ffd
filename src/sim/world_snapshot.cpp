// How a running scene is taken and put back.
#include <algorithm>
#include <cmath>

#include "base/state_hash.hpp"
#include "scene/motion.hpp"
#include "sim/world.hpp"

namespace weft::sim {
namespace {

/// The most by which f32 may be off where a node is R p + t: each of the three products has three roundings (R, p,
/// the product), t has one, and each of the three sums one more, so six units of 2⁻²⁴ for every term. The bound takes
/// eight, |R| <= 1, and the largest t [m].
double place_rounding(const scene::RigidTransform& transform, const Vec3d& rest) {
  const Vec3d& t = transform.translation;
  const double terms = std::abs(rest.x) + std::abs(rest.y) + std::abs(rest.z) +
                       std::max({std::abs(t.x), std::abs(t.y), std::abs(t.z)});
  return std::sqrt(3.0) * 0x1p-21 * terms;
}

}  // namespace

std::string Snapshot::hash() const {
  return state_hash(std::as_bytes(std::span(position)), std::as_bytes(std::span(velocity)));
}

Result<Snapshot> World::snapshot() {
  Snapshot snapshot;
  WEFT_TRY(position, gpu::download(device_, state_.position[parity_]));
  snapshot.position = std::move(position);
  WEFT_TRY(velocity, gpu::download(device_, state_.velocity[parity_]));
  snapshot.velocity = std::move(velocity);
  WEFT_SET(snapshot.contact_forces, contact_.forces(device_));
  WEFT_SET(snapshot.hold_forces, contact_.hold_forces(device_));
  snapshot.time = plan_.time_of(diverged_ ? bad_frame_ : frame_);  // frozen as it was before the bad frame
  snapshot.gusts = steps_.gusts();
  return snapshot;
}

Result<void> World::check_places(const Snapshot& snapshot) const {
  const Model& model = model_.host;
  const double time = snapshot.time.seconds();
  std::vector<scene::RigidTransform> places(2);  // of free and of pinned nodes, then of each motion
  for (const scene::Motion& motion : model.motions)
    // A path may begin elsewhere; until the first step its nodes are at rest.
    places.push_back(time > 0 ? scene::motion_at(motion, time) : scene::RigidTransform{});
  for (std::size_t node = 0; node < model.vertex_count(); ++node) {
    if (!model.kinematic(node)) continue;
    const scene::RigidTransform& place = places[model.motion[node]];
    const double off = length(snapshot.position[node].xyz().to<double>() - place(model.rest_position[node]));
    const double allowed = place_rounding(place, model.rest_position[node]);
    if (off <= allowed) continue;
    return input_error(
        "Node %zu of the snapshot is %g m from where this scene has it at %g s; rounding allows %g m.", node,
        off, time, allowed);
  }
  return {};
}

Result<void> World::restore(const Snapshot& snapshot) {
  if (snapshot.position.size() != model_.vertex_count() || snapshot.velocity.size() != model_.vertex_count())
    return input_error("The snapshot has %zu positions and %zu velocities; this scene has %u nodes.",
                       snapshot.position.size(), snapshot.velocity.size(), model_.vertex_count());
  WEFT_CHECK(check_places(snapshot));
  WEFT_CHECK(grabs_->check_at(snapshot.time.seconds()));
  frame_ = asked_ = plan_.go_on_from(snapshot.time);
  steps_.set_gusts(snapshot.gusts, time());
  std::vector<Vec4f> velocity = snapshot.velocity;
  for (Vec4f& v : velocity) v.w = 0;  // a snapshot has no history
  state_.position[parity_].write(device_, snapshot.position);
  state_.velocity[parity_].write(device_, velocity);
  last_good_->renew(device_, snapshot.position, velocity, 0);
  WEFT_TRY(other_lists, contact_.set_forces(device_, state_, snapshot.contact_forces));
  if (other_lists) {
    WEFT_CHECK(solver_->bind_lists());
    recorder_.forget();
  }
  // Those of a world whose solver holds nothing are none.
  std::vector<std::int32_t> holds = snapshot.hold_forces;
  holds.resize(std::size_t{kHoldWords} * model_.vertex_count());
  contact_.set_hold_forces(device_, holds);
  last_good_->renew_holds(device_, holds);
  return {};
}

}  // namespace weft::sim
