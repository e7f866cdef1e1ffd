// Three nodes of a grid in a row, as rows of a table: a, b, c; nothing at rest, since sheets are flat; material:
// stiffness [N/m]. The energy is k/2 |x_a - 2 x_b + x_c|². Source: docs/solvers/mass_spring.md, Bending.
#pragma once

#include <array>
#include <cstdint>

#include "element/table.hpp"
#include "mesh/springs.hpp"

namespace weft {

/// Along i and along j: B dj / di³ and B di / dj³ [N/m], where `bending` is B [N·m].
std::array<double, 2> triple_stiffness(const mesh::Grid& grid, double bending);

/// How many build_triples makes.
std::uint64_t triple_count(const mesh::Grid& grid, double bending);

/// Row by row, then column by column; none without bending. Those along the boundary count as its springs do.
ElementTable build_triples(const mesh::Grid& grid, double bending, mesh::BoundaryWeights weights,
                           std::uint32_t first);

}  // namespace weft
