// Closest points and crossings on a list of features: for the tests of contact/proximity/{closest,crossing}.wgsl. A
// case has five words of results, four used. For the first point and the triangle of the next three: apart; (s, t,
// crosses, 0), crosses being of the segment from the first point to the fifth. For the edges of the first and second
// two points: apart; (s, t, both places inside, 0).
#include "gpu/index.wgsl"
#include "contact/proximity/closest.wgsl"
#include "contact/proximity/crossing.wgsl"
//                                                                        elements
@group(0) @binding(0) var<storage, read>       points  : array<vec4f>;  // 5 * cases: m
@group(0) @binding(1) var<storage, read_write> results : array<vec4f>;  // 5 * cases

@compute @workgroup_size(kWorkgroupSize)
fn contact_features(@builtin(global_invocation_id) id : vec3u) {
  let i = flat_index(id);
  let k = 5u * i;
  if (k >= arrayLength(&results)) { return; }
  let p = points[k].xyz;
  let a = points[k + 1u].xyz;
  let b = points[k + 2u].xyz;
  let c = points[k + 3u].xyz;
  let q = points[k + 4u].xyz;
  let corner = closest_on_triangle(p, a, b, c);
  let edges = closest_on_edges(p, a, b, c);
  results[k] = vec4f(corner.apart, 0.0);
  results[k + 1u] = vec4f(corner.s, corner.t, select(0.0, 1.0, crosses(p, q, a, b, c)), 0.0);
  results[k + 2u] = vec4f(edges.apart, 0.0);
  results[k + 3u] = vec4f(edges.s, edges.t, select(0.0, 1.0, edges.inside), 0.0);
}
