#pragma once

#include <span>

#include "mesh/mesh_part.hpp"
#include "mesh/vertex_attributes.hpp"
#include "model/model.hpp"

namespace weft {

/// The cloths as pictures draw them, for a file.
struct DrawnMesh {
  mesh::TriangleMesh shape;
  mesh::VertexAttributes attributes;
};

/// The cloths' nodes in model order, or, where each cell is halved `level` times, the vertices of mesh::upsample, grid
/// after grid; smooth normals; texture coordinates, by which a square picture covers the longer side of a sheet at rest
/// from 0 to 1, upright where the sheet's top is above.
/// Reads   positions: those of the model's nodes [m]. A level above 0 needs cloths that are grids.
DrawnMesh drawn_mesh(const Model& model, std::span<const Vec4f> positions, std::uint32_t level);

/// The parts of that mesh, a cloth or body each, without names.
std::vector<mesh::MeshPart> drawn_parts(const Model& model, std::uint32_t level);

}  // namespace weft
