// The moment at each hinge of a cloth before a sweep, by all bends that have a part in it, and what it resists further
// bending with. One invocation per hinge. Source: docs/solvers/vbd.md, equation 6.
#include "gpu/index.wgsl"
#include "method/begun_hinge.wgsl"
#include "method/fabric_params.wgsl"
//                                                                              elements       unit
@group(0) @binding(0) var<uniform>             fabric      : FabricParams;
@group(0) @binding(1) var<storage, read>       rest_angles : array<f32>;      // hinges         rad
@group(0) @binding(2) var<storage, read>       couplings   : array<vec2u>;    // rows of hinges and their entries
@group(0) @binding(3) var<storage, read>       bends       : array<vec2f>;    // hinges         rad: bend_hinges.wgsl
@group(0) @binding(4) var<storage, read_write> moments     : array<vec4f>;    // hinges         N·m, N·m, rad, rad

@compute @workgroup_size(kWorkgroupSize)
fn weigh_hinges(@builtin(global_invocation_id) id : vec3u) {
  let hinge = flat_index(id);
  if (hinge >= fabric.hinges) { return; }
  let begun = begun_hinge(hinge);
  let bend = bends[hinge];
  moments[hinge] = vec4f(begun.moment, begun.resistance, bend.x + rest_angles[hinge], bend.y);
}
