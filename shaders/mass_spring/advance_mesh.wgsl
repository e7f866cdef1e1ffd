// One substep of a cloth of any shape, prediction included: gathers the forces of a node's springs over its list of
// neighbours and integrates it. One invocation per node. Source: docs/solvers/mass_spring.md, "node-centric".
#include "shared/index.wgsl"
#include "shared/integrate.wgsl"
#include "shared/neighbour.wgsl"
#include "shared/spring_force.wgsl"
struct VertexRange {  // mirror: src/solver/mass_spring/advance_mesh.hpp
  first : u32,
  count : u32,
}
//                                                                               elements               unit
@group(0) @binding(0) var<uniform>             step         : StepParams;
@group(0) @binding(1) var<uniform>             range        : VertexRange;
@group(0) @binding(2) var<storage, read>       offsets      : array<u32>;        // range.count + 1
@group(0) @binding(3) var<storage, read>       neighbours   : array<Neighbour>;  // 2 * springs
@group(0) @binding(4) var<storage, read>       position_in  : array<vec4f>;      // vertex_count           m (w: inverse mass)
@group(0) @binding(5) var<storage, read>       velocity_in  : array<vec4f>;      // vertex_count           m/s
@group(0) @binding(6) var<storage, read>       rest         : array<vec4f>;      // vertex_count           m (w: motion)
@group(0) @binding(7) var<storage, read>       motions      : array<vec4f>;      // 3 * motions * substeps
@group(0) @binding(8) var<storage, read_write> position_out : array<vec4f>;      // vertex_count           m
@group(0) @binding(9) var<storage, read_write> velocity_out : array<vec4f>;      // vertex_count           m/s

@compute @workgroup_size(kWorkgroupSize)
fn advance_mesh(@builtin(global_invocation_id) id : vec3u) {
  let index = flat_index(id);
  if (index >= range.count) { return; }
  let node = range.first + index;
  let before = NodeState(position_in[node], velocity_in[node]);
  var after : NodeState;
  if (before.position.w == 0.0) {
    after = integrate_held(before, rest[node]);
  } else if (is_grabbed(node)) {
    after = integrate_grabbed(node, before);
  } else {
    var force = vec3f(0.0);
    for (var entry = offsets[index]; entry < offsets[index + 1u]; entry++) {
      let neighbour = neighbours[entry];
      let span = position_in[neighbour.node].xyz - before.position.xyz;
      let rate = velocity_in[neighbour.node].xyz - before.velocity.xyz;
      let spring = spring_state(span, rate, neighbour.rest_length, neighbour.stiffness, neighbour.damping);
      force += spring.tension * spring.direction;
    }
    after = integrate_free(before, force);
  }
  position_out[node] = after.position;
  velocity_out[node] = after.velocity;
}
