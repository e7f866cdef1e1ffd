#pragma once

#include <cstdint>
#include <vector>

#include "model/model.hpp"

namespace weft {

/// Parts of the cloth on whose nodes nothing from outside is sure to act: none of them is pinned or moved. Nodes are in
/// their order within a piece, pieces in that of their first nodes.
struct FreePieces {
  std::vector<std::uint32_t> nodes;   // piece after piece
  std::vector<std::uint32_t> starts;  // in `nodes`, and the end of the last
  std::size_t count() const { return starts.size() - 1; }
};

/// Of nodes that elements hold together; or of whole bodies, for methods in whose steps parts of one act on each other.
/// Solids: all bodies with volume together, where there are several, and nothing else; for methods that have these in
/// one matrix.
enum class PiecesOf { Elements, Bodies, Solids };
FreePieces free_pieces(const Model& model, PiecesOf of);

}  // namespace weft
