// The narrow phase on a list of pairs, one result each: for the tests of contact/pushes/triangle_pair.wgsl.
#include "gpu/index.wgsl"
#include "contact/pushes/triangle_pair.wgsl"
//                                                                        elements
@group(0) @binding(0) var<storage, read>       corners : array<vec4f>;  // 6 * pairs: cloth a, b, c, object a, b, c
@group(0) @binding(1) var<storage, read_write> results : array<u32>;    // pairs: 1 an edge hits, 2 the boxes overlap

@compute @workgroup_size(kWorkgroupSize)
fn triangle_pairs(@builtin(global_invocation_id) id : vec3u) {
  let i = flat_index(id);
  if (i >= arrayLength(&results)) { return; }
  let k = 6u * i;
  let cloth = TrianglePoints(corners[k].xyz, corners[k + 1u].xyz, corners[k + 2u].xyz);
  let object = TrianglePoints(corners[k + 3u].xyz, corners[k + 4u].xyz, corners[k + 5u].xyz);
  let hit = edges_hit(cloth, object) || edges_hit(object, cloth);
  let boxes = boxes_overlap(query_box(cloth), box_of(object));
  results[i] = select(0u, 1u, hit) | select(0u, 2u, boxes);
}
