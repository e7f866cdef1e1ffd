// GJK on a list of pairs: for the tests of contact/pushes/gjk.wgsl.
#include "gpu/index.wgsl"
#include "contact/pushes/gjk.wgsl"
//                                                                       elements
@group(0) @binding(0) var<storage, read>       corners : array<vec4f>; // 3 * pairs; w of the first: the body's number
@group(0) @binding(1) var<storage, read>       bodies  : array<ConvexBody>;
@group(0) @binding(2) var<storage, read>       places  : array<vec4f>;
@group(0) @binding(3) var<storage, read>       words   : array<u32>;
@group(0) @binding(4) var<storage, read_write> results : array<vec4f>; // 3 * pairs: weights, distance; normal,
                                                                       // iterations; point, by_features

@compute @workgroup_size(kWorkgroupSize)
fn gjk_pairs(@builtin(global_invocation_id) id : vec3u) {
  let i = 3u * flat_index(id);
  if (i >= arrayLength(&results)) { return; }
  let triangle = array<vec3f, 3>(corners[i].xyz, corners[i + 1u].xyz, corners[i + 2u].xyz);
  let contact = convex_contact(triangle, bodies[u32(corners[i].w)], kNowhere);
  results[i] = vec4f(contact.weights, contact.distance);
  results[i + 1u] = vec4f(contact.normal, f32(contact.iterations));
  results[i + 2u] = vec4f(contact.point, select(0.0, 1.0, contact.by_features));
}
