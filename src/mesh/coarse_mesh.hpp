// A mesh of about a third of the nodes of another, of one with volume about a sixth, and linear interpolation from it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/adjacency.hpp"
#include "mesh/tet_mesh.hpp"

namespace weft::mesh {

/// Nodes in space, what joins two of them, and the triangles and tetrahedra among those; an edge need not have a
/// triangle. Where there are tetrahedra, the triangles are those of their surface.
struct Network {
  std::vector<Vec3d> positions;  // [m]
  std::vector<Edge> edges;       // each once
  std::vector<Triangle> triangles;
  std::vector<Tet> tets;
};

/// How much of what stands elsewhere: with weight 0 nothing.
struct Share {
  std::uint32_t index = 0;
  float weight = 0;
};
/// Of a finer node; the last has a weight only where there are tetrahedra.
using Taps = std::array<Share, 4>;

struct CoarseMesh {
  Network network;                // in its own numbers
  std::vector<std::uint32_t> of;  // the fine node that each of its nodes is
  std::vector<Taps> taps;         // of each fine node: weights of coarse nodes, whose sum is 1
};

/// Keeps nodes of which no two are joined, as many as can be, those of the boundary first; of a mesh with
/// volume then those that are joined to most; then by number.
/// Every other node belongs to the nearest kept one that it is joined to; where three such regions meet in a
/// triangle is a coarse triangle, where two meet along an edge a coarse edge, where four meet in a tetrahedron a coarse
/// one. A fine node takes from the corners of the nearest coarse triangle or tetrahedron by its barycentric
/// coordinates, or else from the ends of an edge.
CoarseMesh coarsened(const Network& fine);

}  // namespace weft::mesh
