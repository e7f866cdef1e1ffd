// What a node of a piece has where nodes have ways and know those without elements. The including kernel binds
// `position_in`, `aim` and `way`, and says whether a node goes free. Source: docs/momentum.md, equation 2.
#include "method/pieces/sum_chunks.wgsl"

fn sums_of(node : u32, first_node : u32) -> mat4x4f {
  if (!goes_free(node)) { return held_sums(); }
  let q = position_in[node].xyz - position_in[first_node].xyz;
  return node_sums(1.0 / way[node].w, q, way[node].xyz - aim[node].xyz, vec3f(0.0));
}
