// Obstacles as one mesh with normals, ready to upload.
#pragma once

#include <cstdint>
#include <vector>

#include "base/vec.hpp"
#include "render/inputs.hpp"

namespace weft::render {

struct ObjectMesh {
  std::vector<Vec4f> positions;  // [m]
  std::vector<Vec4f> normals;    // unit
  std::vector<std::uint32_t> indices;
  std::size_t closed_index_count = 0;  // at the front: of meshes whose inner side is never seen
};

/// The normal of each vertex: the sum of its triangles' normals times their areas, made unit.
std::vector<Vec3f> vertex_normals(const mesh::TriangleMesh& mesh);

/// Whether a mesh is a solid's surface that faces outward: each side of a triangle is that of one other, run
/// through the other way.
bool is_closed(const mesh::TriangleMesh& mesh);

/// All meshes and spheres of `inputs`: first those that are closed, then the others.
ObjectMesh join_objects(const Inputs& inputs);

}  // namespace weft::render
