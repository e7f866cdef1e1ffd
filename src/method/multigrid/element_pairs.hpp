// The blocks of a cloth of fabric or a body with volume: of which parts of its membranes, hinges and cords, or
// of its tetrahedra, each is a sum. One rule for the kernels and for the reference.
// Source: docs/solvers/multigrid.md, Fabric.
#pragma once

#include <cstdint>
#include <vector>

#include "base/lists.hpp"
#include "method/multigrid/systems.hpp"
#include "model/model.hpp"

namespace weft {

/// What gives blocks. Mirror: src/method/multigrid/fabric_blocks.wgsl.
enum class PartKind : std::uint8_t { Membrane, Hinge, Cord, Tet };

/// The block that an element gives to two of its nodes. Mirror: src/method/multigrid/element_part.wgsl.
struct ElementPart {
  PartKind kind = PartKind::Membrane;
  std::uint32_t element = 0;          // its number among its kind's: of Cord among cords_of
  std::uint32_t row = 0, column = 0;  // corners of the element

  /// The same in one word; elements up to 2²⁶.
  std::uint32_t packed() const {
    return element << 6 | static_cast<std::uint32_t>(kind) << 4 | row << 2 | column;
  }
};

struct ElementPairs {
  std::vector<mesh::Edge> pairs;  // nodes that share an element, from 0; the first is the smaller number
  Lists<ElementPart> parts;       // of each node's own block, then of each pair's
};
/// `bodies`: elements and nodes are numbered through all of them.
ElementPairs element_pairs(const Model& model, const multigrid::SystemBodies& bodies);

}  // namespace weft
