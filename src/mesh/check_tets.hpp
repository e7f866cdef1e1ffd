// What is asked of every tetrahedral mesh.
#pragma once

#include "base/result.hpp"
#include "mesh/tet_mesh.hpp"

namespace weft::mesh {

/// A tetrahedron is flat where six times its volume is at most this part of its longest edge's cube: rounding the
/// corners to single precision moves them by 2^-25 of such an edge, and so makes that much of nothing.
constexpr double kFlatTet = 1.0 / 16777216.0;  // 2^-24

/// Makes a mesh usable, or says why it is not. Every reader ends with it.
/// Writes  Tetrahedra that are inside out have two vertices swapped, since files have both orders. Vertices that no
///         tetrahedron has are dropped, as they would have no mass; the others keep their order.
/// Errors  Input: no tetrahedron, more vertices or tetrahedra than a 32-bit index can name, a coordinate that is not
///         finite, a vertex that is not there or twice in a tetrahedron, a flat tetrahedron, a face of three
///         tetrahedra, or of two that lie on the same side of it. Numbers are those before vertices are dropped. The
///         mesh may be changed all the same.
Result<void> check_tets(TetMesh& mesh);

}  // namespace weft::mesh
