// The share of the cloth's area that each vertex stands for; times the areal density it is the vertex's mass.
#pragma once

#include <span>
#include <vector>

#include "base/result.hpp"
#include "mesh/grid.hpp"
#include "mesh/triangle_mesh.hpp"

namespace weft::mesh {

/// A third of the area of each triangle at the vertex [m²]. The mesh passes check_mesh.
std::vector<double> vertex_areas(const TriangleMesh& mesh);

/// A quarter of each cell at the node [m²]: a quarter at corners, half at sides, a whole cell inside.
std::vector<double> vertex_areas(const Grid& grid);

/// A vertex without area has no mass, and no motion.
/// Errors  Input: names the first such vertex.
Result<void> check_vertex_areas(std::span<const double> areas);

}  // namespace weft::mesh
