// Moves every node that is farther from what holds its cloth than a tether lets it be straight back to where that ends.
// Held nodes do not move: one invocation per node. Source: docs/solvers/xpbd.md, equation 14.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
//                                                                              elements       unit
@group(0) @binding(0) var<uniform>             step        : StepBlock;
@group(0) @binding(1) var<storage, read>       tethers     : array<vec2u>;   // rows of nodes, then their tethers
@group(0) @binding(2) var<storage, read>       position_in : array<vec4f>;   // vertex_count   m
@group(0) @binding(3) var<storage, read_write> way         : array<vec4f>;   // vertex_count   m (w: 1/kg; 0: driven)

@compute @workgroup_size(kWorkgroupSize)
fn keep_tethers(@builtin(global_invocation_id) id : vec3u) {
  let node = flat_index(id);
  if (node >= step.nodes.count) { return; }
  let row = tethers[node];  // the first, and the one behind the last
  var own = way[node];
  if (row.x == row.y || own.w == 0.0) { return; }
  for (var k = row.x; k < row.y; k++) {
    let tether = tethers[k];  // a held node, and the bits of a length, m
    let span = (position_in[node].xyz - position_in[tether.x].xyz) + (own.xyz - way[tether.x].xyz);
    let longest = bitcast<f32>(tether.y);
    let far = length(span);
    if (far > longest) { own = vec4f(own.xyz - (1.0 - longest / far) * span, own.w); }
  }
  way[node] = own;
}
