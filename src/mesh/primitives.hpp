// Meshes that are made, not read.
#pragma once

#include "mesh/triangle_mesh.hpp"

namespace weft::mesh {

/// A sphere of radius 1 m around the origin, poles on the y axis: `columns` >= 3 around it, `rows` >= 2 from
/// pole to pole, each pole one vertex. columns * (rows - 1) + 2 vertices and 2 * columns * (rows - 1)
/// triangles, closed and facing outward. 20 x 20 is the sphere of Sung et al.: 382 vertices, 760 triangles.
TriangleMesh make_sphere(int columns, int rows);

/// A box around the origin with edges of these lengths [m]: 8 vertices and 12 triangles, closed and facing
/// outward.
TriangleMesh make_box(const Vec3d& size);

}  // namespace weft::mesh
