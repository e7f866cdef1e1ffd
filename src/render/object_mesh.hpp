// Obstacles as one mesh with normals, ready to upload.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec.hpp"
#include "render/inputs.hpp"

namespace weft::render {

/// An obstacle that moves or deforms, and where its vertices begin among all.
struct MovingObject {
  std::size_t first_vertex = 0;
  ObjectDraw draw;
};

/// One draw call.
struct ObjectGroup {
  bool moves = false, closed = false;  // closed: the inner side is never seen
  std::uint32_t first_index = 0, index_count = 0;
};

struct ObjectMesh {
  std::vector<Vec4f> positions;        // [m]; w: of one that moves its number in `moving`
  std::vector<Vec4f> normals;          // unit; w: the material
  std::vector<std::uint32_t> indices;  // by group
  std::array<ObjectGroup, 4> groups{{{false, true}, {false, false}, {true, true}, {true, false}}};
  std::vector<MovingObject> moving;
};

/// The normal of each vertex: the sum of its triangles' normals times their areas, made unit.
std::vector<Vec3f> vertex_normals(const mesh::TriangleMesh& mesh);
/// The same into `normals`, one a vertex; `sums` is room that is kept, so that nothing is allocated.
void write_vertex_normals(const mesh::TriangleMesh& mesh, std::vector<Vec3d>& sums, std::span<Vec4f> normals,
                          scene::Material material = scene::Material::Plaster);

/// Whether a mesh is a solid's surface that faces outward: each side of a triangle is that of one other, run
/// through the other way.
bool is_closed(const mesh::TriangleMesh& mesh);

/// All obstacles of `inputs` but planes.
ObjectMesh join_objects(const Inputs& inputs);

}  // namespace weft::render
