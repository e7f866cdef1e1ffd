// The order of the triangles of a deforming mesh in its tree: neighbours on the sheet are
// neighbours in the list. It never changes; the boxes follow.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "model/model.hpp"

namespace weft::contact {

/// The triangles of all cloths, cloth after cloth, each along a Z curve over its sheet (Model::uv).
std::vector<std::uint32_t> cloth_order(const Model& model);
/// The triangles of a mesh along a Z curve in space.
std::vector<std::uint32_t> mesh_order(const mesh::TriangleMesh& mesh);

}  // namespace weft::contact
