// Membranes as rows of a table: three nodes; rest: the slopes of the second and third corner's shape functions along
// warp and weft [1/m]; material: C11, C12, C22, C33 [N/m] and τ [s].
#pragma once

#include <cstdint>

#include "element/membrane/law.hpp"
#include "element/table.hpp"

namespace weft::membrane {

/// A membrane for each triangle, in their order. Nodes are numbered from `first`.
ElementTable build_membranes(const RestSheet& sheet, const Law& law, std::uint32_t first);

/// A row of the table. What the table does not have follows: slopes sum to zero, and the area from their determinant.
Rest rest_of(const ElementTable& table, std::size_t element);

}  // namespace weft::membrane
