// Counts a word up: next to nothing, so that a chain of these shows what a dispatch costs. One invocation.
//                                                                          elements
@group(0) @binding(0) var<storage, read_write> word : array<u32>;           // 1

@compute @workgroup_size(1)
fn count_up() { word[0] = word[0] + 1u; }
