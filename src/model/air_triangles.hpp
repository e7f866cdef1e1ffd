#pragma once

#include <array>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "model/model.hpp"

namespace weft {

/// A triangle that the air pushes on, and the part of its area that each corner stands for: as in the corners' masses,
/// so that even wind moves all nodes of a flat sheet alike. Source: docs/air.md.
struct AirTriangle {
  mesh::Triangle corners;
  std::array<double, 3> shares;  // their sum is 1
};

/// Of all cloths, in the model's order. A third at each corner of a mesh's; of a grid's, where each cell gives a
/// quarter of itself to each of its nodes, half at the right angle and a quarter at the ends of the diagonal.
std::vector<AirTriangle> air_triangles(const Model& model);

}  // namespace weft
