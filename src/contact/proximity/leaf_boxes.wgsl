// The boxes of an implicit tree's leaves and of the two levels above them, for cloth of all that it may reach.
// One invocation per leaf; a workgroup's leaves fill whole nodes of those levels, since its size is a multiple of 64.
#include "gpu/index.wgsl"
#include "contact/proximity/tree.wgsl"
#include "contact/proximity/store_box.wgsl"
#include "state/statistics.wgsl"
#include "contact/proximity/tree_params.wgsl"
#include "state/step.wgsl"
//                                                                           elements
@group(0) @binding(0) var<uniform>             step       : StepBlock;
@group(0) @binding(1) var<uniform>             params     : TreeParams;
@group(0) @binding(2) var<storage, read>       position   : array<vec4f>; // m; of cloth: tree.wgsl
@group(0) @binding(3) var<storage, read>       triangles  : array<vec4u>; // corners; w: find_pairs.wgsl
@group(0) @binding(4) var<storage, read_write> statistics : array<u32>;
@group(0) @binding(5) var<storage, read_write> trees      : array<vec4u>;
var<workgroup> low : array<vec4f, kWorkgroupSize>;
var<workgroup> high : array<vec4f, kWorkgroupSize>;

fn store(level : u32, node : u32, box : Box) {
  let place = trees[params.tree + 1u + level];
  if (node >= place.y) { return; }
  store_box(place.x + 2u * node, box);
}

fn leaf_box(leaf : u32) -> Box {
  var box = empty_box();
  let is_cloth = params.tree == 0u;
  let first = select(0u, step.nodes.count, is_cloth);
  let end = min(kLeafTriangles * (leaf + 1u), params.triangle_count);
  for (var t = kLeafTriangles * leaf; t < end; t++) {
    let corner = triangles[params.first_triangle + t];
    let a = position[first + corner.x];
    let b = position[first + corner.y];
    let c = position[first + corner.z];
    if (!(is_finite(a.xyz) && is_finite(b.xyz) && is_finite(c.xyz))) { continue; }
    var own = box_of(a.xyz, b.xyz, c.xyz);
    if (is_cloth) {
      own = grown(swept_box(a.xyz, b.xyz, c.xyz, position[2u * first + corner.x].xyz,
                            position[2u * first + corner.y].xyz, position[2u * first + corner.z].xyz),
                  largest_reach(a, b, c));
    }
    box = united(box, own);
  }
  return box;
}

fn children(first : u32) -> Box {
  var box = empty_box();
  for (var k = 0u; k < kTreeArity; k++) { box = united(box, Box(low[first + k].xyz, high[first + k].xyz)); }
  return box;
}

@compute @workgroup_size(kWorkgroupSize)
fn leaf_boxes(@builtin(global_invocation_id) id : vec3u, @builtin(local_invocation_index) local : u32) {
  let leaf = flat_index(id);
  let due = statistics[kStatDue] != 0u;
  var box = empty_box();
  if (due && leaf == 0u && params.tree == 0u) { statistics[kStatDetect] = 0u; }
  if (due) {
    box = leaf_box(leaf);
    store(0u, leaf, box);
  }
  low[local] = vec4f(box.low, 0.0);
  high[local] = vec4f(box.high, 0.0);
  workgroupBarrier();
  let first = leaf - local;  // of the workgroup
  if (local < kWorkgroupSize / kTreeArity) { box = children(kTreeArity * local); }
  workgroupBarrier();
  if (local < kWorkgroupSize / kTreeArity) {
    if (due) { store(1u, first / kTreeArity + local, box); }
    low[local] = vec4f(box.low, 0.0);
    high[local] = vec4f(box.high, 0.0);
  }
  workgroupBarrier();
  if (due && params.top >= 2u && local < kWorkgroupSize / (kTreeArity * kTreeArity)) {
    store(2u, first / (kTreeArity * kTreeArity) + local, children(kTreeArity * local));
  }
}
