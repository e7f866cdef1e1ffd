// The blocks of elements in the matrix of a mesh, in double. Source: docs/solvers/multigrid.md, Fabric.
#pragma once

#include "method/multigrid/element_pairs.hpp"
#include "method/multigrid/reference/implicit_step.hpp"

namespace weft::reference {

/// Adds the sums of blocks to the matrix of a step. `block_of`: that of an ElementPart.
template <class BlockOf>
void add_blocks(MeshStep& step, const ElementPairs& parts, const BlockOf& block_of) {
  step.matrix.skews.resize(step.matrix.blocks.size());
  for (std::size_t block = 0; block < parts.parts.size(); ++block) {
    Mat3 sum{};
    for (const ElementPart& part : parts.parts.of(block)) sum += block_of(part);
    const bool own = block < step.fixed.size();
    const std::array<std::uint32_t, 2> nodes =
        own ? std::array{static_cast<std::uint32_t>(block), static_cast<std::uint32_t>(block)}
            : parts.pairs[block - step.fixed.size()];
    if (step.fixed[nodes[0]] || step.fixed[nodes[1]]) continue;
    step.matrix.blocks[block] += Sym3::symmetric_part(sum);
    if (!own) step.matrix.skews[block] = 0.5 * Vec3d{sum.z.y - sum.y.z, sum.x.z - sum.z.x, sum.y.x - sum.x.y};
  }
  step.matrix.diagonal_part = multigrid::kElementDiagonalPart;
}

}  // namespace weft::reference
