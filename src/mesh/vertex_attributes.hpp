// What a mesh file says of each vertex beside its place.
#pragma once

#include <array>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace weft::mesh {

/// Each list has an entry for every vertex, or none at all: then files do without.
struct VertexAttributes {
  std::vector<Vec3f> normals;                 // unit vectors
  std::vector<std::array<float, 2>> texture;  // u to the right, v up; a picture fills 0 to 1
};

/// Unit normals, each the sum over its triangles by area; up where there is none, since glTF asks for unit
/// length.
std::vector<Vec3f> smooth_normals(const TriangleMesh& mesh);

}  // namespace weft::mesh
