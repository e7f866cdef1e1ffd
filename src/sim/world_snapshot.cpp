// How a running scene is taken and put back.
#include <algorithm>
#include <cmath>

#include "base/state_hash.hpp"
#include "contact/proximity/rigid_bodies.hpp"
#include "contact/rules/rigid_body.hpp"
#include "scene/motion.hpp"
#include "scene/screw.hpp"
#include "sim/scene_hash.hpp"
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

constexpr std::uint32_t kMostFrames = 1000000000;  // that a saved state may have behind it

}  // namespace

std::string Snapshot::hash() const {
  return state_hash(std::as_bytes(std::span(position)), std::as_bytes(std::span(velocity)));
}

Result<NodeState> World::node_state() const {
  NodeState state;
  WEFT_SET(state.position, gpu::download(device_, state_.position[parity_]));
  WEFT_SET(state.velocity, gpu::download(device_, state_.velocity[parity_]));
  if (state_.creases.size() > 0) WEFT_SET(state.creases, gpu::download(device_, state_.creases));
  return state;
}

Result<Snapshot> World::snapshot() {
  WEFT_TRY(nodes, node_state());
  Snapshot snapshot{std::move(nodes)};
  WEFT_SET(snapshot.contact_forces, contact_.forces(device_));
  WEFT_SET(snapshot.hold_forces, contact_.hold_forces(device_));
  if (rigid() != nullptr) WEFT_SET(snapshot.rigid, rigid()->states(device_));
  snapshot.time = plan_.time_of(diverged_ ? bad_frame_ : frame_);  // frozen as it was before the bad frame
  for (const std::size_t collider : given_colliders())
    snapshot.given.push_back(
        scene::placement_at(*scene::carried_of(scene_.colliders[collider]), snapshot.time.seconds()));
  snapshot.gusts = steps_.gusts();
  if (plan_.method().history == 0 || snapshot.time.frame == 0) return snapshot;
  WEFT_SET(snapshot.position_before, gpu::download(device_, state_.position[1 - parity_]));
  WEFT_SET(snapshot.velocity_before, gpu::download(device_, state_.velocity[1 - parity_]));
  snapshot.step = snapshot.time.length / plan_.substeps_of(snapshot.time.frame - 1);
  return snapshot;
}

Result<std::vector<RigidPlace>> World::rigid_places() const {
  std::vector<RigidPlace> places;
  if (rigid() == nullptr) return places;
  WEFT_TRY(words, rigid()->states(device_));
  const std::vector<ColliderSolid> solids = solids_of(scene_, assets_.objects, assets_.object_colliders);
  const contact::RigidWords states(words);
  for (std::size_t c = 0, k = 0; c < solids.size(); ++c) {
    if (!solids[c].rigid()) continue;
    const RigidState state = states.state(k++);
    const Quaternion& axes = solids[c].axes;
    places.push_back(
        {c, state.place, product(state.turn, conjugate(axes)), state.velocity, spin_of(solids[c], state)});
  }
  return places;
}

Result<void> World::check_nodes(const Snapshot& snapshot) const {
  const std::size_t bodies = rigid() != nullptr ? rigid()->count() : 0;
  if (snapshot.rigid.size() != contact::kRigidStateWords * bodies)
    return input_error("The snapshot has %zu rigid bodies; this scene has %zu.",
                       snapshot.rigid.size() / contact::kRigidStateWords, bodies);
  const std::vector<std::size_t> given = given_colliders();
  if (snapshot.given.size() != given.size())
    return input_error("The snapshot has %zu colliders that a program moves; this scene has %zu.",
                       snapshot.given.size(), given.size());
  for (const Placement& placement : snapshot.given)
    if (const auto unit = scene::checked_placement(placement); !unit) return unit.error();
  if (snapshot.creases.size() != state_.creases.size())
    return input_error("The snapshot has %zu facets that keep bends; this scene has %zu.",
                       snapshot.creases.size(), state_.creases.size());
  if (snapshot.position.size() != model_.vertex_count() || snapshot.velocity.size() != model_.vertex_count())
    return input_error("The snapshot has %zu positions and %zu velocities; this scene has %u nodes.",
                       snapshot.position.size(), snapshot.velocity.size(), model_.vertex_count());
  return check_places(snapshot);
}

Result<void> World::check_places(const Snapshot& snapshot) const {
  const Model& model = model_.host;
  const double time = snapshot.time.seconds();
  std::vector<scene::RigidTransform> places(2);  // of free and of pinned nodes, then of each motion
  const std::vector<std::size_t> given_ones = given_colliders();
  for (const scene::Motion& motion : model.motions) {
    if (const auto* tied = std::get_if<scene::MotionCarried>(&motion.shape)) {
      const auto found = std::find(given_ones.begin(), given_ones.end(), tied->collider);
      places.push_back(
          scene::transform_of(snapshot.given[static_cast<std::size_t>(found - given_ones.begin())]));
      continue;
    }
    // A path may begin elsewhere; until the first step its nodes are at rest.
    places.push_back(time > 0 ? scene::motion_at(motion, time) : scene::RigidTransform{});
  }
  for (std::size_t node = 0; node < model.vertex_count(); ++node) {
    if (!model.kinematic(node)) continue;
    const bool finite = std::isfinite(length(snapshot.position[node].xyz()));
    if (finite && given(node) != nullptr) continue;  // wherever a program had moved it
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

bool World::takes_history(const Snapshot& snapshot) const {
  const FrameTime& time = snapshot.time;
  return plan_.method().history > 0 && snapshot.position_before.size() == model_.vertex_count() &&
         snapshot.velocity_before.size() == model_.vertex_count() && time.length == scene_.time.frame &&
         time.frame > 0 && snapshot.step == time.length / plan_.substeps_of(time.frame - 1);
}

void World::hold_given(std::span<const Vec4f> positions) {
  for (std::size_t node = 0; node < positions.size(); ++node) {
    const scene::MotionGiven* motion = given(node);
    if (motion == nullptr) continue;
    const Vec3d& rest = model_.host.rest_position[node];
    const scene::RigidTransform place = scene::motion_at(*motion, time());
    const Vec3d there = positions[node].xyz().to<double>();
    // Where it is there but for the rounding it keeps its own numbers, and so its bits.
    if (length(there - place(rest)) > place_rounding(place, rest))
      set_given(node, {motion->speed, 0, 0, there - rest, there - rest});
  }
}

Result<void> World::restore(const Snapshot& snapshot) {
  WEFT_CHECK(check_nodes(snapshot));
  WEFT_CHECK(grabs_->check_at(snapshot.time.seconds()));
  return put_back(snapshot);
}

Result<void> World::put_back(const Snapshot& snapshot) {
  frame_ = asked_ = plan_.go_on_from(snapshot.time);
  steps_.set_gusts(snapshot.gusts, time());
  hold_given(snapshot.position);
  const std::vector<std::size_t> given_ones = given_colliders();
  for (std::size_t k = 0; k < given_ones.size(); ++k)
    set_ways(given_ones[k], {{0, 0, snapshot.given[k], snapshot.given[k]}});
  std::vector<Vec4f> velocity = snapshot.velocity;
  if (takes_history(snapshot)) {
    state_.position[1 - parity_].write(device_, snapshot.position_before);
    state_.velocity[1 - parity_].write(device_, snapshot.velocity_before);
    last_good_->renew_before(device_, snapshot.position_before, snapshot.velocity_before);
  } else {
    // A method that does not look back marks what obstacles hold, and makes that anew in each substep.
    const bool looks_back = plan_.method().history > 0;
    for (Vec4f& v : velocity) v.w = looks_back ? 0 : std::min(v.w, 0.0F);
  }
  state_.position[parity_].write(device_, snapshot.position);
  state_.velocity[parity_].write(device_, velocity);
  last_good_->renew(device_, snapshot.position, velocity, 0);
  WEFT_TRY(other_lists, contact_.set_forces(device_, state_, snapshot.contact_forces));
  if (other_lists) {
    WEFT_CHECK(solver_->bind_lists());
    recorder_.forget();
  }
  state_.creases.write(device_, snapshot.creases);
  last_good_->renew_creases(device_, snapshot.creases);
  // Those of a world whose solver holds nothing are none.
  std::vector<std::int32_t> holds = snapshot.hold_forces;
  holds.resize(std::size_t{kHoldWords} * model_.vertex_count());
  contact_.set_hold_forces(device_, holds);
  last_good_->renew_holds(device_, holds);
  if (rigid() != nullptr) {
    rigid()->set_states(device_, snapshot.rigid);
    gpu::CommandList list;
    last_good_->record_rigid(list);
    WEFT_CHECK(device_.submit(list));
  }
  return submit_surface();
}

Result<SavedState> World::save(const std::string& build) {
  WEFT_CHECK(finish());
  WEFT_TRY(snapshot, this->snapshot());
  return SavedState{build,
                    device_.adapter().name,
                    scene_hash(scene_, assets_),
                    std::move(snapshot),
                    grabs_->held(),
                    totals_,
                    tears_,
                    sewing_};
}

Result<void> World::open(const SavedState& saved) {
  if (const std::uint64_t own = scene_hash(scene_, assets_); saved.scene != own)
    return input_error("The saved state is of another scene: its hash is %s, that of this one %s.",
                       hash_text(saved.scene).c_str(), hash_text(own).c_str());
  if (!(saved.tears == tears_))
    return input_error("The saved state has torn at %zu nodes, and this world otherwise, at %zu.",
                       saved.tears.splits(), tears_.splits());
  if (!(saved.sewing == sewing_))
    return input_error("The saved state is sewn at %zu pairs of nodes, and this world otherwise, at %zu.",
                       saved.sewing.sewn(), sewing_.sewn());
  const Snapshot& snapshot = saved.snapshot;
  if (snapshot.time.length != scene_.time.frame || snapshot.time.frame > kMostFrames)
    return input_error("The saved state is of frame %u of %g s each; this scene has up to %u of %g s.",
                       snapshot.time.frame, snapshot.time.length, kMostFrames, scene_.time.frame);
  WEFT_CHECK(check_nodes(snapshot));
  for (std::size_t node = 0; node < snapshot.position.size(); ++node)
    if (snapshot.position[node].w != static_cast<float>(model_.host.inverse_mass(node)))
      return input_error(
          "Node %zu of the saved state has an inverse mass of %g 1/kg; in this scene it has %g.", node,
          static_cast<double>(snapshot.position[node].w), model_.host.inverse_mass(node));
  Grabs grabs = *grabs_;
  grabs.release_all();
  for (const Grabbed& grabbed : saved.grabs)
    WEFT_CHECK(grabs.grab(grabbed.node, grabbed.target, snapshot.time.seconds()));
  WEFT_CHECK(device_.wait());
  reports_.drop();  // they are about discarded frames
  clear_statistics();
  diverged_.reset();
  *grabs_ = std::move(grabs);
  totals_ = saved.totals;
  return put_back(snapshot);
}

}  // namespace weft::sim
