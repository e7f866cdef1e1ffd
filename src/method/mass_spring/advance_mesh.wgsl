// One substep of a cloth of any shape, prediction included: gathers the forces of a node's springs over its neighbours
// and integrates it. One invocation per node. Source: docs/solvers/mass_spring.md, "node-centric".
#include "gpu/index.wgsl"
#include "state/integrate.wgsl"
#include "element/spring/neighbour.wgsl"
#include "element/spring/law.wgsl"
struct MeshParams {  // mirror: src/method/mass_spring/advance_mesh.hpp
  first : u32,
  count : u32,
  kinds : array<vec4f, kNeighbourKinds>,  // N/m, N·s/m: stiffness and damping
}
//                                                                               elements               unit
@group(0) @binding(0) var<uniform>             step         : StepBlock;
@group(0) @binding(1) var<uniform>             mesh         : MeshParams;
@group(0) @binding(2) var<storage, read>       slices       : array<u32>;        // slices + 1: each one's first entry
@group(0) @binding(3) var<storage, read>       neighbours   : array<Neighbour>;  // 2 * springs, and fillers
@group(0) @binding(4) var<storage, read>       position_in  : array<vec4f>;      // vertex_count           m (w: 1/kg)
@group(0) @binding(5) var<storage, read>       velocity_in  : array<vec4f>;      // vertex_count           m/s
@group(0) @binding(6) var<storage, read>       rest         : array<vec4f>;      // vertex_count           m (w: motion)
@group(0) @binding(7) var<storage, read>       motions      : array<vec4f>;      // 3 * motions * substeps
@group(0) @binding(8) var<storage, read_write> position_out : array<vec4f>;      // vertex_count           m
@group(0) @binding(9) var<storage, read_write> velocity_out : array<vec4f>;      // vertex_count           m/s

override kDamped : bool = true;  // no spring damps: velocities of neighbours are not read

@compute @workgroup_size(kWorkgroupSize)
fn advance_mesh(@builtin(global_invocation_id) id : vec3u) {
  let index = flat_index(id);
  if (index >= mesh.count) { return; }
  let node = mesh.first + index;
  let before = NodeState(position_in[node], velocity_in[node]);
  var force = vec3f(0.0);
  let end = slices[index / kSlice + 1u];
  for (var entry = slices[index / kSlice] + index % kSlice; entry < end; entry += kSlice) {
    let neighbour = neighbours[entry];
    let other = neighbour.node_and_kind & ((1u << kNeighbourNodeBits) - 1u);
    let kind = mesh.kinds[neighbour.node_and_kind >> kNeighbourNodeBits];
    let span = position_in[other].xyz - before.position.xyz;
    var rate = vec3f(0.0);
    if (kDamped) { rate = velocity_in[other].xyz - before.velocity.xyz; }
    let spring = spring_state(span, rate, neighbour.rest_length, kind.x, kind.y);
    force += (spring.tension * spring.per_length) * span;
  }
  let after = integrate_node(node, before, force);
  position_out[node] = after.position;
  velocity_out[node] = after.velocity;
}
