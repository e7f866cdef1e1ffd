// A model whose cloths are attached to colliders.
#pragma once

#include "model/assets.hpp"
#include "model/model.hpp"

namespace weft {

/// Nodes that attachments take along with shapes, at most: each has a motion of its own.
inline constexpr std::size_t kMostAttachedNodes = 4096;

/// The scene's cloths, as build_model (model.hpp) makes them, and their attachments: a node goes with a collider's
/// motion, or, of a mesh that deforms, with its nearest triangle at time 0, from shape to shape, turned as that is.
/// Errors  Input: as there; an attachment's collider is not there, or deforms and has a motion too; a node is further
///         from it than its reach, or is held already. Limit: more nodes than kMostAttachedNodes.
Result<Model> build_model(const scene::Scene& scene, const Assets& assets);

}  // namespace weft
