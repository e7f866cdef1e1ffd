// A model whose cloths are attached to colliders.
#pragma once

#include "model/assets.hpp"
#include "model/model.hpp"

namespace weft {

/// Nodes that are attached to meshes, at most: each looks for its nearest triangle, and has a motion of its own.
inline constexpr std::size_t kMostAttachedNodes = 4096;
/// Of the nodes that go with shapes, how many of them all have together.
inline constexpr std::size_t kMostAttachedShapes = std::size_t{1} << 22U;

/// The scene's cloths, as build_model (model.hpp) makes them, and their attachments: a node goes with a collider's
/// motion, or, of a mesh that deforms, with its nearest triangle at time 0, from shape to shape, turned as that is.
/// Errors  Input: as there; an attachment's collider is not there, or deforms and has a motion too; a node is further
///         from it than its reach, or is held already. Limit: more nodes than kMostAttachedNodes, more
///         shapes than kMostAttachedShapes.
Result<Model> build_model(const scene::Scene& scene, const Assets& assets);

}  // namespace weft
