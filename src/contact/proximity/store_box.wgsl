// Stores a box of an implicit tree, and leaves the cells of its triangles as they are. The including kernel binds
// `trees`.
#include "contact/proximity/tree.wgsl"
fn store_box(word : u32, box : Box) {
  trees[word] = vec4u(bitcast<vec3u>(box.low), trees[word].w);
  trees[word + 1u] = vec4u(bitcast<vec3u>(box.high), trees[word + 1u].w);
}
