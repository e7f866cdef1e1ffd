#pragma once

#include <span>

#include "model/model.hpp"

namespace weft {

/// The cloths as pictures draw them, for a file: their nodes in model order, or, where each cell is halved
/// `level` times, the vertices of mesh::upsample, grid after grid. Reads   positions: those of the model's
/// nodes [m]. A level above 0 needs cloths that are grids.
mesh::TriangleMesh drawn_mesh(const Model& model, std::span<const Vec4f> positions, std::uint32_t level);

}  // namespace weft
