// The moment at each hinge of a cloth before a sweep, by all bends that have a part in it, and what it resists further
// bending with. One invocation per hinge. Source: docs/solvers/vbd.md, equation 6.
#include "gpu/index.wgsl"
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
  let row = couplings[hinge];  // the first entry, and the one behind the last
  var moment = 0.0;
  var resistance = 0.0;
  for (var entry = row.x; entry < row.y; entry++) {
    let coupling = couplings[entry];  // a hinge, and N·m as the bits of f32
    let other = bends[coupling.x];
    moment += bitcast<f32>(coupling.y) * (other.x + other.y);
    resistance += abs(bitcast<f32>(coupling.y));
  }
  let begun = bends[hinge];
  moments[hinge] = vec4f(moment, resistance, begun.x + rest_angles[hinge], begun.y);
}
