#pragma once

#include <span>

#include "element/table.hpp"
#include "mesh/adjacency.hpp"

namespace weft {

/// Node -> where it stands in a list of nodes, ascending: row i is that of node first + i, of `count` nodes.
mesh::Adjacency places_in(std::span<const std::uint32_t> nodes, std::uint32_t first, std::size_t count);

/// Node -> the elements at it, ascending: row i is that of node first + i, of the `count` nodes of all elements.
mesh::Adjacency incidence(const ElementTable& table, std::uint32_t first, std::size_t count);

}  // namespace weft
