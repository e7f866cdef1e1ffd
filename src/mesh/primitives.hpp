// Meshes that are made, not read.
#pragma once

#include "mesh/triangle_mesh.hpp"

namespace weft::mesh {

/// A sphere of radius 1 m around the origin, poles on the y axis: `columns` >= 3 around it, `rows` >= 2 from
/// pole to pole, each pole one vertex. columns * (rows - 1) + 2 vertices and 2 * columns * (rows - 1)
/// triangles, closed and facing outward. 20 x 20 is the sphere of Sung et al.: 382 vertices, 760 triangles.
TriangleMesh make_sphere(int columns, int rows);

/// A sphere of radius 1 m around the origin whose triangles are all of nearly one size: the faces of an icosahedron,
/// each edge in `cells` >= 1 parts, taken to the sphere. 10 cells² + 2 vertices and 20 cells² triangles, closed and
/// facing outward.
TriangleMesh make_geodesic_sphere(int cells);

/// A capsule around the origin: all points within `radius` of the line of `length` along y [m]. `columns` >=
/// 3 around it, `rows` >= 1 from each pole to where the half-sphere ends. 2 * columns * rows + 2 vertices,
/// closed and facing outward.
TriangleMesh make_capsule(double length, double radius, int columns, int rows);

/// A box around the origin with edges of these lengths [m]: 8 vertices and 12 triangles, closed and facing
/// outward.
TriangleMesh make_box(const Vec3d& size);

}  // namespace weft::mesh
