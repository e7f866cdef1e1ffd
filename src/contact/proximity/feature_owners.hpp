// Who owns a vertex or an edge: the first of its triangles. Iterating over owners visits each feature once.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace weft::contact {

/// For each triangle six bits: 0 to 2 its corners, 3 to 5 the edges from them to the next. Of triangles that
/// share a vertex or an edge the first in this order has the bit. Source: Curtis et al. 2008,
/// Representative-Triangles.
std::vector<std::uint32_t> feature_owners(std::span<const mesh::Triangle> triangles);

}  // namespace weft::contact
