// What one node does.
#pragma once

#include "base/vec.hpp"
#include "model/model.hpp"
#include "sim/snapshot.hpp"

namespace weft::sim {

/// A node at the end of the last frame.
struct Probe {
  Vec3d position;      // [m]
  Vec3d rest;          // of the cloth's shape at rest, in the world [m]
  Vec3d velocity;      // [m/s]
  double mass = 0;     // [kg]
  double stretch = 1;  // the largest length of an edge at it, over that at rest
  double tension =
      0;  // force per width at rest, across the direction that bears most [N/m]; of a body with volume 0
};

/// Of a state that World::node_state has given. The tension is that of docs/tearing.md; of a grid of springs half of
/// what those at the node bear, by its part of the cloth's area.
/// Errors  Input: the model has no such node.
Result<Probe> probe(const Model& model, const NodeState& state, std::uint32_t node);

}  // namespace weft::sim
