#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/vec.hpp"
#include "sim/frame_steps.hpp"
#include "sim/plan/frame_plan.hpp"
#include "weft/placement.hpp"

namespace weft::sim {

/// Where all nodes are and how fast, in model order.
struct NodeState {
  std::vector<Vec4f> position;  // [m]; w: inverse mass [1/kg]
  std::vector<Vec4f> velocity;  // [m/s]; w: not 0 where the state a substep before is known (Method::history)
  std::vector<Vec4f> creases;   // what facets keep of their bends: State::creases
};

/// The same and when it was so: all that the next substep reads from those before it.
struct Snapshot : NodeState {
  FrameTime time;
  Gusts gusts;  // of the wind then
  std::vector<std::uint32_t>
      contact_forces;  // with which pairs of features act: contact::SceneContact::forces
  std::vector<std::int32_t>
      hold_forces;                   // of vertices that the solver holds: contact::SceneContact::hold_forces
  std::vector<std::uint32_t> rigid;  // of the scene's rigid bodies: contact::RigidBodies::states
  std::vector<Placement> given;      // of the colliders that a program moves
  /// That state a substep before, `step` [s] long; empty where the method has no history.
  std::vector<Vec4f> position_before, velocity_before;
  double step = 0;
  /// XXH3-64 of the bits of position, then velocity, as 16 hexadecimal digits.
  std::string hash() const;
};

/// Where a rigid body is and how it moves.
struct RigidPlace {
  std::size_t collider = 0;      // of the scene's
  Vec3d place;                   // of its centre of mass [m]
  std::array<double, 4> turn{};  // from where the scene puts it, unit quaternion x, y, z, w
  Vec3d velocity, spin;          // [m/s], [rad/s]
};

}  // namespace weft::sim
