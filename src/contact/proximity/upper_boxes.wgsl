// The boxes of an implicit tree from its fourth level up. One workgroup for the whole tree: a level has an eighth of
// the nodes of the one below, and only within a workgroup may a dispatch read its own writes.
#include "contact/proximity/tree.wgsl"
#include "contact/proximity/store_box.wgsl"
#include "state/statistics.wgsl"
#include "contact/proximity/tree_params.wgsl"
@group(0) @binding(0) var<uniform>             params     : TreeParams;
@group(0) @binding(1) var<storage, read>       statistics : array<u32>;
@group(0) @binding(2) var<storage, read_write> trees      : array<vec4u>;
const kThreads = 256u;

@compute @workgroup_size(kThreads)
fn upper_boxes(@builtin(local_invocation_index) local : u32) {
  let due = statistics[kStatDue] != 0u;
  for (var level = 3u; level <= params.top; level++) {
    let below = trees[params.tree + level];
    let place = trees[params.tree + 1u + level];
    for (var node = local; due && node < place.y; node += kThreads) {
      var box = empty_box();
      let end = min(kTreeArity * (node + 1u), below.y);
      for (var child = kTreeArity * node; child < end; child++) {
        box = united(box, Box(bitcast<vec3f>(trees[below.x + 2u * child].xyz),
                              bitcast<vec3f>(trees[below.x + 2u * child + 1u].xyz)));
      }
      store_box(place.x + 2u * node, box);
    }
    storageBarrier();
  }
}
