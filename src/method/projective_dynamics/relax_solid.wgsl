// One more iteration of a cycle over every node of a body, after pull_tets_back. One invocation per node.
// Source: docs/solvers/projective_dynamics.md, equation 4 and Bodies.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "method/projective_dynamics/relax.wgsl"
#include "method/projective_dynamics/gathered_pulls.wgsl"
//                                                                              elements      unit
@group(0) @binding(0) var<uniform>             step        : StepBlock;
@group(0) @binding(1) var<uniform>             cloth       : RelaxedNodes;
@group(0) @binding(2) var<uniform>             iteration   : Iteration;
@group(0) @binding(3) var<storage, read>       gathers     : array<u32>;    // rows of nodes, then places in `pulls`
@group(0) @binding(4) var<storage, read>       pulls       : array<vec4f>;  // 4 * tets      N
@group(0) @binding(5) var<storage, read>       change      : array<vec4f>;  // vertex_count  m
@group(0) @binding(6) var<storage, read_write> change_next : array<vec4f>;  // vertex_count  m
@group(0) @binding(7) var<storage, read_write> left        : array<vec4f>;  // vertex_count  m (w: 1/kg)
@group(0) @binding(8) var<storage, read_write> way         : array<vec4f>;  // vertex_count  m (w: 1/kg)
@group(0) @binding(9) var<storage, read_write> aim         : array<vec4f>;  // vertex_count  m

@compute @workgroup_size(kWorkgroupSize)
fn relax_solid(@builtin(global_invocation_id) id : vec3u) {
  let row = flat_index(id);
  if (row >= cloth.count) { return; }
  let node = cloth.first_node + row;
  let own = change[node].xyz;
  let before = left[node];
  let mobility = step.time.dt * step.time.dt * before.w;  // m/N; 0: neither it nor what is left changes
  relax(node, own, before.xyz - own + mobility * pull_at(row), before.w);
}
