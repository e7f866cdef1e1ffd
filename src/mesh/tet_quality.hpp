// How well shaped the tetrahedra of a mesh are.
#pragma once

#include "mesh/tet_mesh.hpp"

namespace weft::mesh {

/// Dihedral angles, of which each tetrahedron has six, say how well it carries a strain: small and large ones make
/// its equations stiff. A volume is negative where a tetrahedron is inside out.
struct TetQuality {
  double least_angle = 0, largest_angle = 0;    // degrees
  double least_volume = 0, largest_volume = 0;  // m³
  double volume = 0;                            // m³, of all together
};
/// Of a mesh that passes check_tets; all zero for one without tetrahedra. Angles are by the machine's arctangent.
TetQuality tet_quality(const TetMesh& mesh);

}  // namespace weft::mesh
