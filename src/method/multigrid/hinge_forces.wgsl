// The forces of a cloth's hinges on their nodes: moments by all bends that have a part in a hinge's triangles. One
// invocation per hinge. Source: docs/elements.md, Bending.
#include "gpu/index.wgsl"
#include "method/fabric_params.wgsl"
#include "method/hinge_moment.wgsl"
//                                                                             elements      unit
@group(0) @binding(0) var<uniform>             fabric    : FabricParams;
@group(0) @binding(1) var<storage, read>       couplings : array<vec2u>;    // rows of hinges and their entries
@group(0) @binding(2) var<storage, read>       wings     : array<vec4f>;    // 4 * hinges    1/m
@group(0) @binding(3) var<storage, read>       bends     : array<f32>;      // hinges        rad
@group(0) @binding(4) var<storage, read_write> forces    : array<vec4f>;    // 3 * triangles + 4 * hinges, N

@compute @workgroup_size(kWorkgroupSize)
fn hinge_forces(@builtin(global_invocation_id) id : vec3u) {
  let hinge = flat_index(id);
  if (hinge >= fabric.hinges) { return; }
  let moment = moment_of(hinge);
  let first = 3u * fabric.triangles + 4u * hinge;
  for (var corner = 0u; corner < 4u; corner++) {
    forces[first + corner] = vec4f(-moment * wings[4u * hinge + corner].xyz, 0.0);
  }
}
