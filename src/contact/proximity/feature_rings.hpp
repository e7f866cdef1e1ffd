// The triangles around each vertex, which bound the Voronoi cones of vertices and edges.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace weft::contact {

/// The words of `rings` in src/contact/proximity/cones.wgsl. Rows are the cloth's vertices, then the colliders'
/// points: where the words of each row begin, and where those of the last end; then for each triangle at the
/// row's vertex its next two corners, by their ids (src/state/contact.wgsl). A point of no triangle has none.
std::vector<std::uint32_t> feature_rings(std::size_t vertex_count, std::span<const mesh::Triangle> cloth,
                                         std::size_t point_count, std::span<const mesh::Triangle> colliders);

}  // namespace weft::contact
