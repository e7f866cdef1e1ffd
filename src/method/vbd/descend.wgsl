// Moves every node of one colour to where its own part of what the substep minimises is least by Newton's method, its
// neighbours where they are. No two nodes of a colour are ends of one spring. One invocation per node.
// Source: docs/solvers/vbd.md, equations 3 and 4.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "element/spring/law.wgsl"
#include "element/spring/neighbour.wgsl"
#include "method/vbd/descended.wgsl"

struct NodesOfColor {  // mirror: src/method/vbd/solver_vbd.hpp
  first : u32,       // in `order`
  count : u32,
  first_node : u32,  // of the cloth
  kinds : array<vec4f, kNeighbourKinds>,  // N/m, N·s/m: stiffness and damping
}
//                                                                              elements               unit
@group(0) @binding(0) var<uniform>             step        : StepBlock;
@group(0) @binding(1) var<uniform>             color       : NodesOfColor;
@group(0) @binding(2) var<storage, read>       order       : array<u32>;        // nodes, colour after colour
@group(0) @binding(3) var<storage, read>       slices      : array<u32>;        // slices + 1: each one's first entry
@group(0) @binding(4) var<storage, read>       neighbours  : array<Neighbour>;  // 2 * springs, and fillers
@group(0) @binding(5) var<storage, read>       position_in : array<vec4f>;      // vertex_count           m
@group(0) @binding(6) var<storage, read_write> aim         : array<vec4f>;      // vertex_count           m
@group(0) @binding(7) var<storage, read_write> way         : array<vec4f>;      // vertex_count           m (w: 1/kg)

@compute @workgroup_size(kWorkgroupSize)
fn descend(@builtin(global_invocation_id) id : vec3u) {
  let index = flat_index(id);
  if (index >= color.count) { return; }
  let node = order[color.first + index];
  let own = way[node];
  if (own.w == 0.0) { return; }
  let place = position_in[node].xyz;
  let dt = step.time.dt;
  let mobility = dt * dt * own.w;  // m/N
  var slope = aim[node].xyz - own.xyz;
  var hessian = identity(1.0);
  let row = node - color.first_node;
  let end = slices[row / kSlice + 1u];
  for (var entry = slices[row / kSlice] + row % kSlice; entry < end; entry += kSlice) {
    let neighbour = neighbours[entry];
    let other = neighbour.node_and_kind & ((1u << kNeighbourNodeBits) - 1u);
    let kind = color.kinds[neighbour.node_and_kind >> kNeighbourNodeBits];
    // Ways are short: their difference keeps digits that the difference of places has lost.
    let turn = way[other].xyz - own.xyz;
    let span = (position_in[other].xyz - place) + turn;
    let spring = spring_state(span, turn / dt, neighbour.rest_length, kind.x, kind.y);
    slope += (mobility * spring.tension * spring.per_length) * span;
    let across = mobility * kind.x * max(0.0, 1.0 - neighbour.rest_length * spring.per_length);
    let along = mobility * (kind.x + kind.y / dt) - across;
    hessian = sum_of(hessian, identity(select(across, 0.0, spring.per_length == 0.0)));
    hessian = sum_of(hessian, outer(spring.per_length * span, along));
  }
  way[node] = vec4f(descended(node, own.xyz, hessian, slope), own.w);
}
