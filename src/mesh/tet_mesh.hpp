// A tetrahedral mesh as plain data: what a body with volume is made of.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/result.hpp"
#include "base/vec.hpp"
#include "mesh/triangle_mesh.hpp"

namespace weft::mesh {

/// Vertices a, b, c, d with (b - a) x (c - a) · (d - a) > 0: seen from d, a b c goes round counter-clockwise.
using Tet = std::array<std::uint32_t, 4>;

struct TetMesh {
  std::vector<Vec3f> positions;  // m
  std::vector<Tet> tets;
};

/// Six times the volume of a tetrahedron, negative where it is inside out [m³].
double six_volumes(const std::array<Vec3d, 4>& corners);

/// The sides that one tetrahedron alone has, facing outward, by the mesh's own vertices.
std::vector<Triangle> boundary(std::span<const Tet> tets);

/// A block of nx * ny * nz cells of five tetrahedra each, mirrored from cell to cell, from -size/2 to size/2 [m].
/// Vertex (k * (ny + 1) + j) * (nx + 1) + i is at i of x, j of y, k of z.
TetMesh block(const std::array<std::uint32_t, 3>& cells, const Vec3d& size);

}  // namespace weft::mesh
