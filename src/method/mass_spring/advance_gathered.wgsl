// One substep of a cloth of fabric or a body with volume, prediction included: gathers the forces of a node's elements,
// which are computed before, and integrates it. One invocation per node. Source: docs/solvers/mass_spring.md, Fabric.
#include "gpu/index.wgsl"
#include "state/integrate.wgsl"
struct NodeRange {  // mirror: src/method/node_range.hpp
  first : u32,
  count : u32,
}
//                                                                               elements      unit
@group(0) @binding(0) var<uniform>             step         : StepBlock;
@group(0) @binding(1) var<uniform>             nodes        : NodeRange;
@group(0) @binding(2) var<storage, read>       gathers      : array<u32>;      // count + 1 rows, then entries of forces
@group(0) @binding(3) var<storage, read>       forces       : array<vec4f>;    // of elements' corners, N
@group(0) @binding(4) var<storage, read>       position_in  : array<vec4f>;    // vertex_count  m (w: 1/kg)
@group(0) @binding(5) var<storage, read>       velocity_in  : array<vec4f>;    // vertex_count  m/s
@group(0) @binding(6) var<storage, read>       rest         : array<vec4f>;    // vertex_count  m (w: motion)
@group(0) @binding(7) var<storage, read>       motions      : array<vec4f>;    // 3 * motions * substeps
@group(0) @binding(8) var<storage, read_write> position_out : array<vec4f>;    // vertex_count  m
@group(0) @binding(9) var<storage, read_write> velocity_out : array<vec4f>;    // vertex_count  m/s

@compute @workgroup_size(kWorkgroupSize)
fn advance_gathered(@builtin(global_invocation_id) id : vec3u) {
  let index = flat_index(id);
  if (index >= nodes.count) { return; }
  let node = nodes.first + index;
  var force = vec3f(0.0);
  let end = gathers[index + 1u];
  for (var entry = gathers[index]; entry < end; entry++) { force += forces[gathers[entry]].xyz; }
  let after = integrate_node(node, NodeState(position_in[node], velocity_in[node]), force);
  position_out[node] = after.position;
  velocity_out[node] = after.velocity;
}
