#pragma once

#include "element/table.hpp"
#include "mesh/adjacency.hpp"

namespace weft {

/// Node -> the elements at it, ascending: row i is that of node first + i, of the `count` nodes of all elements.
mesh::Adjacency incidence(const ElementTable& table, std::uint32_t first, std::size_t count);

}  // namespace weft
