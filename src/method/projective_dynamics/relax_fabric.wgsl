// One more iteration of a cycle over every node of a cloth of fabric: relax_springs.wgsl, by its pairs of nodes. One
// invocation per node. Source: docs/solvers/projective_dynamics.md, equations 4 and 15.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "element/spring/neighbour.wgsl"
#include "method/projective_dynamics/fabric_pair.wgsl"
#include "method/projective_dynamics/relax.wgsl"
//                                                                              elements              unit
@group(0) @binding(0)  var<uniform>             step        : StepBlock;
@group(0) @binding(1)  var<uniform>             cloth       : RelaxedNodes;
@group(0) @binding(2)  var<uniform>             iteration   : Iteration;
@group(0) @binding(3)  var<storage, read>       slices      : array<u32>;         // slices + 1: each one's first entry
@group(0) @binding(4)  var<storage, read>       pairs       : array<FabricPair>;  // 2 * pairs, and fillers
@group(0) @binding(5)  var<storage, read>       change      : array<vec4f>;       // vertex_count         m
@group(0) @binding(6)  var<storage, read_write> change_next : array<vec4f>;       // vertex_count         m
@group(0) @binding(7)  var<storage, read_write> left        : array<vec4f>;       // vertex_count         m (w: 1/kg)
@group(0) @binding(8)  var<storage, read_write> way         : array<vec4f>;       // vertex_count         m (w: 1/kg)
@group(0) @binding(9)  var<storage, read_write> aim         : array<vec4f>;       // vertex_count         m

@compute @workgroup_size(kWorkgroupSize)
fn relax_fabric(@builtin(global_invocation_id) id : vec3u) {
  let row = flat_index(id);
  if (row >= cloth.count) { return; }
  let node = cloth.first_node + row;
  let own = change[node].xyz;
  let dt = step.time.dt;
  let before = left[node];
  let mobility = dt * dt * before.w;  // m/N; 0: neither it nor what is left changes
  var rest = before.xyz - own;
  let end = slices[row / kSlice + 1u];
  for (var entry = slices[row / kSlice] + row % kSlice; entry < end; entry += kSlice) {
    let pair = pairs[entry];
    rest += (mobility * (pair.pull + pair.damping / dt)) * (change[pair.other].xyz - own);
  }
  relax(node, own, rest, before.w);
}
