// Tetrahedra in a closed surface.
#pragma once

#include <cstdint>

#include "base/result.hpp"
#include "mesh/tet_mesh.hpp"
#include "mesh/triangle_mesh.hpp"

namespace weft::mesh {

/// Points of the lattice of fill_surface. Where all are inside they make a hundred million tetrahedra, 1.6 GB.
constexpr std::uint32_t kMaxFillPoints = std::uint32_t{1} << 24U;

/// Fills the inside of a closed surface (closed_surface.hpp says what is inside) with tetrahedra of nearly one size by
/// isosurface stuffing on a body-centred cubic lattice whose cubes have the edge `cell` [m]. Its middle is that of the
/// surface's bounds, and its cubes end at the bounds where these are a multiple of the cell. Dihedral angles are from
/// 10.78° to 164.74°, before coordinates are rounded. Vertices on the boundary lie on the surface, so a smooth one is
/// met to second order in the cell; edges and corners are cut off within a cell, and parts thinner than a cell may be
/// lost or hang by a vertex. The same bits on every machine.
/// Errors  Input: ClosedSurface::create; a cell that is not a positive number, so large that no tetrahedron is left, so
///         small that the lattice has more than kMaxFillPoints, or too small for the single precision of the
///         coordinates.
/// Source  Labelle and Shewchuk 2007, Isosurface Stuffing: Fast Tetrahedral Meshes with Good Dihedral Angles.
Result<TetMesh> fill_surface(const TriangleMesh& surface, double cell);

}  // namespace weft::mesh
