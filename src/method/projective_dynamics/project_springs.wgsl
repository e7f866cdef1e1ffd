// The start of a cycle over every node of a cloth: its springs are projected, each to its rest length; what the global
// system then has left, and the first Jacobi step of its relaxation. One invocation per node.
// Source: docs/solvers/projective_dynamics.md, equations 2 to 4.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "element/spring/law.wgsl"
#include "element/spring/neighbour.wgsl"
#include "method/projective_dynamics/begin_cycle.wgsl"
//                                                                              elements               unit
@group(0) @binding(0) var<uniform>             step        : StepBlock;
@group(0) @binding(1) var<uniform>             cloth       : RelaxedNodes;
@group(0) @binding(2) var<uniform>             springs     : SpringKinds;
@group(0) @binding(3) var<storage, read>       slices      : array<u32>;        // slices + 1: each one's first entry
@group(0) @binding(4) var<storage, read>       neighbours  : array<Neighbour>;  // 2 * springs, and fillers
@group(0) @binding(5) var<storage, read>       position_in : array<vec4f>;      // vertex_count           m
@group(0) @binding(6) var<storage, read_write> aim         : array<vec4f>;      // vertex_count           m
@group(0) @binding(7) var<storage, read>       way         : array<vec4f>;      // vertex_count           m (w: 1/kg)
@group(0) @binding(8) var<storage, read_write> way_next    : array<vec4f>;      // vertex_count           m (w: 1/kg)
@group(0) @binding(9) var<storage, read_write> left        : array<vec4f>;      // vertex_count           m (w: 1/kg)
@group(0) @binding(10) var<storage, read_write> change      : array<vec4f>;      // vertex_count           m

@compute @workgroup_size(kWorkgroupSize)
fn project_springs(@builtin(global_invocation_id) id : vec3u) {
  let row = flat_index(id);
  if (row >= cloth.count) { return; }
  let node = cloth.first_node + row;
  let own = way[node];
  let place = position_in[node].xyz;
  let dt = step.time.dt;
  let mobility = dt * dt * own.w;  // m/N
  var rest = aim[node].xyz - own.xyz;
  let end = slices[row / kSlice + 1u];
  for (var entry = slices[row / kSlice] + row % kSlice; entry < end; entry += kSlice) {
    let neighbour = neighbours[entry];
    let other = neighbour.node_and_kind & ((1u << kNeighbourNodeBits) - 1u);
    let kind = springs.kinds[neighbour.node_and_kind >> kNeighbourNodeBits];
    // Ways are short: their difference keeps digits that the difference of places has lost.
    let turn = way[other].xyz - own.xyz;
    let span = (position_in[other].xyz - place) + turn;
    let spring = spring_state(span, turn / dt, neighbour.rest_length, kind.x, kind.y);
    rest += (mobility * spring.tension * spring.per_length) * span;
  }
  begin_cycle(node, own, rest);
}
