// The nodes of a partial sum, in partial_sums.wgsl and add_up.wgsl.
const kChunk = 64u;  // mirror: src/method/multigrid/cycle.hpp
fn chunk_count(node_count : u32) -> u32 { return (node_count + kChunk - 1u) / kChunk; }
