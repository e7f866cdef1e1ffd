// The start of a cycle over every node of a cloth of fabric, after pull_membranes: what its bending pulls it by, what
// the global system then has left, and the first Jacobi step of its relaxation. One invocation per node.
// Source: docs/solvers/projective_dynamics.md, Fabric.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "element/spring/neighbour.wgsl"
#include "method/projective_dynamics/begin_cycle.wgsl"
#include "method/projective_dynamics/fabric_pair.wgsl"
//                                                                              elements              unit
@group(0) @binding(0)  var<uniform>             step        : StepBlock;
@group(0) @binding(1)  var<uniform>             cloth       : RelaxedNodes;
@group(0) @binding(2)  var<storage, read>       slices      : array<u32>;         // slices + 1: each one's first entry
@group(0) @binding(3)  var<storage, read>       pairs       : array<FabricPair>;  // 2 * pairs, and fillers
@group(0) @binding(4)  var<storage, read>       position_in : array<vec4f>;       // vertex_count         m
@group(0) @binding(5)  var<storage, read>       way         : array<vec4f>;       // vertex_count         m (w: 1/kg)
@group(0) @binding(6)  var<storage, read_write> way_next    : array<vec4f>;       // vertex_count         m (w: 1/kg)
@group(0) @binding(7)  var<storage, read_write> left        : array<vec4f>;       // vertex_count         m (w: 1/kg)
@group(0) @binding(8)  var<storage, read_write> change      : array<vec4f>;       // vertex_count         m
@group(0) @binding(9)  var<storage, read_write> aim         : array<vec4f>;       // vertex_count         m

@compute @workgroup_size(kWorkgroupSize)
fn project_fabric(@builtin(global_invocation_id) id : vec3u) {
  let row = flat_index(id);
  if (row >= cloth.count) { return; }
  let node = cloth.first_node + row;
  let own = way[node];
  let place = position_in[node].xyz;
  let dt = step.time.dt;
  var pull = vec3f(0.0);
  let end = slices[row / kSlice + 1u];
  for (var entry = slices[row / kSlice] + row % kSlice; entry < end; entry += kSlice) {
    let pair = pairs[entry];
    let turn = way[pair.other].xyz - own.xyz;
    pull += pair.bending * ((position_in[pair.other].xyz - place) + turn);
  }
  begin_cycle(node, own, left[node].xyz + (dt * dt * own.w) * pull);
}
