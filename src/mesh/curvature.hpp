// How a surface of triangles is curved, where it stands for a smooth one.
#pragma once

#include <span>
#include <vector>

#include "base/mat3.hpp"
#include "mesh/triangle_mesh.hpp"

namespace weft::mesh {

/// An edge at which a surface turns by more than this is a crease of it, which no smooth surface has [rad].
inline constexpr double kCrease = 0.35;
/// What lies on one side of the creases at a vertex faces within twice that angle of its normal: the cosine.
inline constexpr double kSameSector = 0.765;

/// A surface at a vertex.
struct Curvature {
  Vec3d
      normal;  // of the triangles around it, by their areas; at a crease of its curved side; 0 where there is none
  Mat3
      shape;  // dn/dx, symmetric; positive where the surface is convex on the side that the normal shows [1/m]
};

/// At each vertex what the edges at it turn, half of each, over the vertex's part of the area. Creases and edges that
/// have not two triangles turn nothing. Where a crease parts a flat side from a curved one, as at the rim of a tube's
/// cap, all three are of the curved side alone.
/// Source: Cohen-Steiner and Morvan 2003, Restricted Delaunay Triangulations and Normal Cycle (the tensor); Meyer et
/// al. 2003, Discrete Differential-Geometry Operators (the area).
std::vector<Curvature> vertex_curvatures(std::span<const Vec3d> positions,
                                         std::span<const Triangle> triangles);

}  // namespace weft::mesh
