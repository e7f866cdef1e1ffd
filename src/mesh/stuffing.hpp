// Isosurface stuffing: what a surface leaves of the tetrahedra of a lattice.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/bcc_lattice.hpp"
#include "mesh/tet_mesh.hpp"

namespace weft::mesh {

/// A cut of the surface through a lattice's edge from a to b.
struct LatticeCut {
  std::uint32_t a = 0, b = 0;  // points, the lower first
  double t = 0;                // from 0 at a to 1 at b
};

/// The tetrahedra of the lattice that have a point inside, cut off at the surface. A point that a cut lies too close to
/// moves there, of several cuts to the nearest. This leaves dihedral angles from 10.78° to 164.74° wherever the cuts
/// are. Corners of the tetrahedra that are not points of the lattice are all on the surface.
/// Reads   inside: of each point, whether it is, 0 or 1; of the outermost, none is. cuts: one of each edge with one end
///         inside, sorted by a, then b.
/// Writes  positions are in double, as single precision may not tell them apart; tets name them.
/// Source  Labelle and Shewchuk 2007, Isosurface Stuffing, which proves 10.7° and 164.8°.
struct StuffedLattice {
  std::vector<Vec3d> positions;  // m
  std::vector<Tet> tets;
};
StuffedLattice stuff_lattice(const BccLattice& lattice, const std::vector<std::uint8_t>& inside,
                             const std::vector<LatticeCut>& cuts);

}  // namespace weft::mesh
