// Truncates the motion of vertices at planes that they would pass, in double.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/vec.hpp"

namespace weft::reference {

/// The side of a plane that a vertex must end on: normal . x >= offset.
struct SidePlane {
  std::uint32_t node = 0;
  Vec3d normal;           // unit
  double offset = 0;      // [m]
  bool obstacle = false;  // the plane is where an obstacle's feature ends, so it may come towards the vertex
};

/// Moves each position back towards its previous one until it is beyond no plane, and no further than `reach`
/// [m] from there. What is between two such planes of cloth cannot touch, whatever the other vertices do: the
/// half space holds the previous position and the new one. A plane of an obstacle that has come past a vertex
/// takes it along. Nodes with inverse mass 0 stay. Returns how many were moved.
/// Source: the bounded displacements of Chen et al. 2025, Offset Geometric Contact, with a plane for each
/// pair.
std::uint32_t truncate(std::span<const SidePlane> planes, std::span<const Vec3d> previous,
                       std::span<const double> inverse_mass, double reach, std::span<Vec3d> position);

}  // namespace weft::reference
