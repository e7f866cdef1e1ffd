// The forces of a cloth's hinges on their nodes: moments by all bends that have a part in a hinge's triangles. One
// invocation per hinge. Source: docs/elements.md, Bending.
#include "gpu/index.wgsl"
#include "method/fabric_params.wgsl"
#include "element/hinge/law.wgsl"
#include "method/hinge_moment.wgsl"
//                                                                             elements      unit
@group(0) @binding(0) var<uniform>             fabric    : FabricParams;
@group(0) @binding(1) var<storage, read>       hinges    : array<vec4u>;    // hinges        a, b, c, d
@group(0) @binding(2) var<storage, read>       couplings : array<vec2u>;    // rows of hinges and their entries
@group(0) @binding(3) var<storage, read>       position  : array<vec4f>;    // vertex_count  m
@group(0) @binding(4) var<storage, read>       bends     : array<f32>;      // hinges        rad
@group(0) @binding(5) var<storage, read_write> forces    : array<vec4f>;    // 3 * triangles + 4 * hinges, N

@compute @workgroup_size(kWorkgroupSize)
fn fabric_hinges(@builtin(global_invocation_id) id : vec3u) {
  let hinge = flat_index(id);
  if (hinge >= fabric.hinges) { return; }
  let moment = moment_of(hinge);
  let nodes = hinges[hinge];
  let slope = hinge_slope(wing_of(position[nodes.x].xyz, position[nodes.y].xyz, position[nodes.z].xyz,
                                  position[nodes.w].xyz));
  let first = 3u * fabric.triangles + 4u * hinge;
  forces[first] = vec4f(moment * (slope.b + slope.c + slope.d), 0.0);
  forces[first + 1u] = vec4f(-moment * slope.b, 0.0);
  forces[first + 2u] = vec4f(-moment * slope.c, 0.0);
  forces[first + 3u] = vec4f(-moment * slope.d, 0.0);
}
