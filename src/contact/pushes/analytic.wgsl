// Contacts of nodes with spheres and planes. One invocation per vertex. The push is that of the triangles, from the
// signed distance and the surface normal at the previous position; a node within the thickness of the surface at its
// predicted position gets it.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "state/hash_pair.wgsl"
#include "state/statistics.wgsl"
#include "contact/pushes/triangle_pair.wgsl"  // is_finite, dot_fused

// Mirror: AnalyticCollider in src/contact/pushes/colliders_analytic.hpp.
struct AnalyticCollider {
  point : vec4f,   // m, a sphere's centre or a point of the plane; w: the sphere's radius, m
  normal : vec4f,  // the plane's unit normal; w: 0 for a sphere, 1 for a plane
}
const kAnalyticId = 0x80000000u;  // kAnalyticId of colliders_analytic.hpp: its pairs' ids differ from object triangles'
//                                                                                 elements      unit
@group(0) @binding(0) var<uniform>             step       : StepBlock;          // 1
@group(0) @binding(1) var<storage, read>       predicted  : array<vec4f>;       // vertex_count  m; w: 1/kg
@group(0) @binding(2) var<storage, read>       previous   : array<vec4f>;       // vertex_count  m; w: 1/kg
@group(0) @binding(3) var<storage, read>       colliders  : array<AnalyticCollider>;
@group(0) @binding(4) var<storage, read_write> pushes     : array<atomic<i32>>; // 4 * vertex_count: push, count
@group(0) @binding(5) var<storage, read_write> statistics : array<atomic<u32>>; // state/statistics.wgsl

// xyz: the outward normal of the nearest surface point; w: the signed distance, m. A sphere's centre is pushed up.
fn surface(collider : AnalyticCollider, at : vec3f) -> vec4f {
  let offset = at - collider.point.xyz;
  if (collider.normal.w != 0.0) { return vec4f(collider.normal.xyz, dot_fused(collider.normal.xyz, offset)); }
  let size = largest(offset);  // scaled by it, no square can overflow or vanish
  if (size == 0.0) { return vec4f(0.0, 1.0, 0.0, -collider.point.w); }
  let scaled = offset / size;
  let len = sqrt(dot_fused(scaled, scaled));
  return vec4f(scaled / len, fma(len, size, -collider.point.w));
}

@compute @workgroup_size(kWorkgroupSize)
fn analytic(@builtin(global_invocation_id) id : vec3u) {
  let node = flat_index(id);
  if (node >= arrayLength(&predicted)) { return; }
  let now = predicted[node];
  let before = previous[node];
  if (before.w == 0.0 || !is_finite(now.xyz) || !is_finite(before.xyz)) { return; }
  var sum = vec3i(0);
  var hits = 0u;
  var hash = 0u;
  for (var c = 0u; c < arrayLength(&colliders); c++) {
    let collider = colliders[c];
    if (surface(collider, now.xyz).w >= step.contact.thickness) { continue; }
    let start = surface(collider, before.xyz);
    let push = clamp(step.contact.thickness - start.w, 0.0, step.contact.max_push);
    sum += vec3i(round((step.contact.push_scale * push) * start.xyz));
    hits++;
    hash += hash_pair(node, kAnalyticId + c);
  }
  if (hits == 0u) { return; }
  for (var axis = 0u; axis < 3u; axis++) { atomicAdd(&pushes[4u * node + axis], sum[axis]); }
  atomicAdd(&pushes[4u * node + 3u], i32(hits));
  atomicAdd(&statistics[kStatContacts], hits);
  atomicAdd(&statistics[kStatContactHash], hash);
}
