// Whether a point is inside a closed mesh.
#pragma once

#include "base/vec.hpp"
#include "mesh/triangle_mesh.hpp"

namespace weft::reference {

/// How often the mesh winds around the point: the sum of its triangles' solid angles over 4 pi. 1 inside a
/// closed mesh that faces outward, 0 outside; in between for an open one. For host tools and tests: it calls
/// atan2. Source: Van Oosterom and Strackee 1983, The Solid Angle of a Plane Triangle.
double winding_number(const Vec3d& point, const mesh::TriangleMesh& mesh);

bool inside(const Vec3d& point, const mesh::TriangleMesh& mesh);

}  // namespace weft::reference
