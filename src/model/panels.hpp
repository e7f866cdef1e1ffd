// What a cloth that is made of panels has of each.
#pragma once

#include "model/assets.hpp"
#include "model/model.hpp"

namespace weft {

/// Gives the triangles of fabric that is made of panels the warp of their panel: of a grid the way along its rows, of a
/// mesh `fabric.warp_direction`, turned as the panel is.
/// Reads   model: as build_model makes it, unsewn.
void add_warps(Model& model, const scene::Scene& scene, const Assets& assets);

}  // namespace weft
