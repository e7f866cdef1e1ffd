// What a host sets in a running scene.
#include <cmath>

#include "sim/world.hpp"

namespace weft::sim {
namespace {

bool finite(const Vec3f& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// One vector for each node, all finite. Errors  Shape, Input.
Result<void> check_values(std::span<const Vec3f> values, std::size_t nodes, const char* what) {
  if (values.size() != nodes) return shape_error("%zu %s do not fit %zu nodes.", values.size(), what, nodes);
  for (std::size_t node = 0; node < nodes; ++node)
    if (!finite(values[node]))
      return input_error("Of the %s that of node %zu is not finite: (%g, %g, %g).", what, node,
                         values[node].x, values[node].y, values[node].z);
  return {};
}

}  // namespace

Result<void> World::set_positions(std::span<const Vec3f> positions) {
  WEFT_CHECK(check_values(positions, model_.vertex_count(), "positions"));
  WEFT_CHECK(finish());
  WEFT_TRY(now, snapshot());
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
  WEFT_TRY(now, snapshot());
  for (std::size_t node = 0; node < velocities.size(); ++node)
    if (!model_.host.kinematic(node)) now.velocity[node] = Vec4f::from(velocities[node], 0);
  return write_state(now);
}

Result<void> World::push(std::span<const Vec3f> impulses) {
  WEFT_CHECK(check_values(impulses, model_.vertex_count(), "impulses"));
  WEFT_CHECK(finish());
  WEFT_TRY(now, snapshot());
  for (std::size_t node = 0; node < impulses.size(); ++node) {
    const float inverse_mass = now.position[node].w;  // of a kinematic node 0
    now.velocity[node] = Vec4f::from(now.velocity[node].xyz() + inverse_mass * impulses[node], 0);
  }
  return write_state(now);
}

Result<void> World::write_state(Snapshot& state) {
  for (Vec4f& velocity : state.velocity) velocity.w = 0;  // the state before leads elsewhere
  state_.position[parity_].write(device_, state.position);
  state_.velocity[parity_].write(device_, state.velocity);
  last_good_->renew(device_, state.position, state.velocity, 0);
  return submit_surface();  // for what is drawn before the next frame
}

}  // namespace weft::sim
