// Finds the nodes that selectors mean.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/result.hpp"
#include "scene/scene.hpp"

namespace weft::scene {

/// The nodes that a selector chooses from.
struct Selection {
  std::span<const Vec3d> positions;  // rest pose in the world [m]
  std::uint32_t nx = 0, ny = 0;      // of a grid, whose node (i, j) is j * nx + i; 0 for a mesh
};

/// The nodes of one selector, or of any of several: rising, each once.
/// Errors  Input: a selector that selects nothing; an index past the last node; a grid's part on a mesh.
Result<std::vector<std::uint32_t>> select_nodes(const Selector& selector, const Selection& from);
Result<std::vector<std::uint32_t>> select_nodes(std::span<const Selector> selectors, const Selection& from);

/// The nodes of a cloth that the scene pins or moves: no force reaches them.
struct KinematicNodes {
  std::vector<std::uint32_t> pins;
  std::vector<std::vector<std::uint32_t>> motions;  // of each of Cloth::motions
};

/// A cloth's pinned and moved nodes.
/// Errors  Input: as select_nodes; a node both pinned and moved, or moved twice.
Result<KinematicNodes> kinematic_nodes(const Cloth& cloth, const Selection& from);

}  // namespace weft::scene
