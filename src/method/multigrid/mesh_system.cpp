#include "method/multigrid/mesh_system.hpp"

#include "method/fabric_buffers.hpp"

namespace weft {

Result<BlockParts> BlockParts::create(gpu::Device& device, const ElementPairs& pairs,
                                      std::span<const BlockEntries> blocks) {
  std::vector<std::uint32_t> packed;
  packed.reserve(pairs.parts.items.size());
  for (const ElementPart& part : pairs.parts.items) packed.push_back(part.packed());
  BlockParts made;
  WEFT_SET(made.parts, gpu::Buffer<std::uint32_t>::create_from(
                           device, rows_then_entries(pairs.parts.starts, packed), "parts of blocks"));
  WEFT_SET(made.targets, gpu::Buffer<BlockEntries>::create_from(device, blocks, "entries of blocks"));
  return made;
}

}  // namespace weft
