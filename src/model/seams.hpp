// Finds what the seams of a scene's cloths sew together.
#pragma once

#include "model/assets.hpp"
#include "model/model.hpp"

namespace weft {

/// Gives the cloths with seams their patterns, none of which is sewn yet. Nodes that a seam joins get one place at
/// rest_position, so that contact takes them for neighbours: half way, or where the scene holds one of them; where they
/// begin stays.
/// Reads   model: as build_model makes it, with its attachments.
/// Where rows have unequal numbers of nodes, the one that has fewer gets more, and its cloth more triangles
/// (eased_rows.hpp).
/// Errors  Input: a row is no single run of a panel's rim, or cannot have as many nodes as that which it is sewn
///         to; a seam joins a triangle with itself, or two nodes that the scene holds.
Result<void> add_seams(Model& model, const scene::Scene& scene, const Assets& assets);

/// Of all seams.
std::size_t pair_count(const CutPattern& pattern);

}  // namespace weft
