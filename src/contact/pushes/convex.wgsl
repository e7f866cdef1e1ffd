// Contacts of cloth triangles with convex bodies. One invocation per triangle and body: the triangle's point that is
// nearest to the body is moved to the thickness outside, by pushes that the three nodes share by their weights in it.
// Source: docs/collision.md, Convex bodies; Sung et al., future work.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "state/hash_pair.wgsl"
#include "state/statistics.wgsl"
#include "contact/pushes/gjk.wgsl"

const kConvexId = 0xc0000000u;  // kConvexId of colliders_convex.hpp: its pairs' ids differ from all others'
const kLeastWeight = 0.000244140625;  // 2^-12: a node that has less of the point is not touched
//                                                                                      elements      unit
@group(0) @binding(0) var<uniform>             step            : StepBlock;          // 1
@group(0) @binding(1) var<storage, read>       predicted       : array<vec4f>;       // vertex_count  m; w: 1/kg
@group(0) @binding(2) var<storage, read>       previous        : array<vec4f>;       // vertex_count  m; w: 1/kg
@group(0) @binding(3) var<storage, read>       cloth_triangles : array<u32>;         // 3 * cloth triangles
@group(0) @binding(4) var<storage, read>       bodies          : array<ConvexBody>;
@group(0) @binding(5) var<storage, read>       places          : array<vec4f>;       // points and faces  m
@group(0) @binding(6) var<storage, read>       words           : array<u32>;         // edges and rings
@group(0) @binding(7) var<storage, read_write> pushes          : array<atomic<i32>>; // 4 * vertex_count: push, count
@group(0) @binding(8) var<storage, read_write> statistics      : array<atomic<u32>>; // state/statistics.wgsl

@compute @workgroup_size(kWorkgroupSize)
fn convex(@builtin(global_invocation_id) id : vec3u) {
  let cloth_count = arrayLength(&cloth_triangles) / 3u;
  let pair = flat_index(id);
  if (pair >= cloth_count * arrayLength(&bodies)) { return; }
  let triangle = pair % cloth_count;
  let number = pair / cloth_count;
  let body = bodies[number];
  var nodes = array<u32, 3>(cloth_triangles[3u * triangle], cloth_triangles[3u * triangle + 1u],
                            cloth_triangles[3u * triangle + 2u]);
  let corners = array<vec3f, 3>(predicted[nodes[0]].xyz, predicted[nodes[1]].xyz, predicted[nodes[2]].xyz);
  if (!is_finite(corners[0]) || !is_finite(corners[1]) || !is_finite(corners[2])) { return; }
  let thickness = step.contact.thickness;
  // Boxes further apart than the thickness: rounding of a difference and of the product is 2^-23 of them.
  let low = min(min(corners[0], corners[1]), corners[2]);
  let high = max(max(corners[0], corners[1]), corners[2]);
  let between = max(low - body.high.xyz, body.low.xyz - high);
  if (max(max(between.x, between.y), between.z) > 1.00001 * thickness) { return; }
  let contact = convex_contact(corners, body, thickness);
  if (!(contact.distance < thickness)) { return; }

  var weights = contact.weights;
  for (var k = 0u; k < 3u; k++) { weights[k] = select(0.0, weights[k], weights[k] >= kLeastWeight); }
  var distance = 0.0;  // of the same point of the triangle at the previous positions, along the normal
  var finite = is_finite(contact.normal);
  for (var k = 0u; k < 3u; k++) {
    let offset = previous[nodes[k]].xyz - contact.point;
    finite = finite && is_finite(offset);
    distance += contact.weights[k] * dot_fused(contact.normal, offset);
  }
  let push = clamp(thickness - distance, 0.0, step.contact.max_push);
  let shared_push = push / dot_fused(weights, weights);
  for (var k = 0u; k < 3u; k++) {
    let node = nodes[k];
    if (weights[k] == 0.0 || previous[node].w == 0.0) { continue; }
    let amount = min(weights[k] * shared_push, step.contact.max_push);
    let units = select(vec3i(0), vec3i(round((step.contact.push_scale * amount) * contact.normal)), finite);
    for (var axis = 0u; axis < 3u; axis++) { atomicAdd(&pushes[4u * node + axis], units[axis]); }
    atomicAdd(&pushes[4u * node + 3u], 1);
  }
  atomicAdd(&statistics[kStatContacts], 1u);
  atomicAdd(&statistics[kStatContactHash], hash_pair(triangle, kConvexId + number));
}
