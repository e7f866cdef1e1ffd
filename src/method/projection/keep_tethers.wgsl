// Moves every node that is farther from what holds its cloth than a tether lets it be straight back to where that ends.
// Held nodes do not move: one invocation per node. Source: docs/solvers/xpbd.md, equations 14 and 14a.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
//                                                                              elements       unit
@group(0) @binding(0) var<uniform>             step        : StepBlock;
@group(0) @binding(1) var<storage, read>       tethers     : array<vec2u>;   // rows of nodes, then their tethers
@group(0) @binding(2) var<storage, read>       position_in : array<vec4f>;   // vertex_count   m
@group(0) @binding(3) var<storage, read_write> way         : array<vec4f>;   // vertex_count   m (w: 1/kg; 0: driven)

// How many times as long a node's tethers are, so that what they hold it to is not farther apart than two of them.
fn lengthening(row : vec2u) -> f32 {
  var longer = 1.0;
  for (var k = row.x + 1u; k < row.y; k++) {
    let b = tethers[k];
    let place = position_in[b.x].xyz + way[b.x].xyz;
    for (var m = row.x; m < k; m++) {
      let a = tethers[m];
      let apart = length(place - (position_in[a.x].xyz + way[a.x].xyz));
      let both = bitcast<f32>(a.y) + bitcast<f32>(b.y);
      if (apart > longer * both) { longer = apart / both; }
    }
  }
  return longer;
}

@compute @workgroup_size(kWorkgroupSize)
fn keep_tethers(@builtin(global_invocation_id) id : vec3u) {
  let node = flat_index(id);
  if (node >= step.nodes.count) { return; }
  let row = tethers[node];  // the first, and the one behind the last
  var own = way[node];
  if (row.x == row.y || own.w == 0.0) { return; }
  let longer = lengthening(row);
  for (var k = row.x; k < row.y; k++) {
    let tether = tethers[k];  // a held node, and the bits of a length, m
    let span = (position_in[node].xyz - position_in[tether.x].xyz) + (own.xyz - way[tether.x].xyz);
    let longest = longer * bitcast<f32>(tether.y);
    let far = length(span);
    if (far > longest) { own = vec4f(own.xyz - (1.0 - longest / far) * span, own.w); }
  }
  way[node] = own;
}
