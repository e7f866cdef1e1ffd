#pragma once

#include <span>

#include "gpu/buffer.hpp"
#include "method/multigrid/element_pairs.hpp"
#include "method/multigrid/mesh_lists.hpp"

namespace weft {

/// What a mesh's linear system binds besides its own.
struct MeshSystem {
  const gpu::RawBuffer &levels, &place, &vectors, &row_starts, &entries, &blocks;
};

/// Of which parts of elements each block of a mesh's finest level is a sum, and where it stands.
struct BlockParts {
  gpu::Buffer<std::uint32_t>
      parts;  // rows of blocks, then their parts: src/method/multigrid/element_part.wgsl
  gpu::Buffer<BlockEntries> targets;

  /// `blocks`: the entries of each. Errors  Limit, OutOfMemory.
  static Result<BlockParts> create(gpu::Device& device, const ElementPairs& pairs,
                                   std::span<const BlockEntries> blocks);
};

}  // namespace weft
