// One more iteration of a cycle over every node of a cloth: a Jacobi step of the global system, whose springs stay
// projected as they are, led on by Chebyshev's weight. No node's change is read before the next iteration. One
// invocation per node. Source: docs/solvers/projective_dynamics.md, equations 4 and 5.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "element/spring/neighbour.wgsl"
#include "method/projective_dynamics/relax.wgsl"
//                                                                              elements               unit
@group(0) @binding(0) var<uniform>             step        : StepBlock;
@group(0) @binding(1) var<uniform>             cloth       : RelaxedNodes;
@group(0) @binding(2) var<uniform>             iteration   : Iteration;
@group(0) @binding(3) var<uniform>             springs     : SpringKinds;
@group(0) @binding(4) var<storage, read>       slices      : array<u32>;        // slices + 1: each one's first entry
@group(0) @binding(5) var<storage, read>       neighbours  : array<Neighbour>;  // 2 * springs, and fillers
@group(0) @binding(6) var<storage, read>       change      : array<vec4f>;      // vertex_count           m
@group(0) @binding(7) var<storage, read_write> change_next : array<vec4f>;      // vertex_count           m
@group(0) @binding(8) var<storage, read_write> left        : array<vec4f>;      // vertex_count           m (w: 1/kg)
@group(0) @binding(9) var<storage, read_write> way         : array<vec4f>;      // vertex_count           m (w: 1/kg)
@group(0) @binding(10) var<storage, read_write> aim         : array<vec4f>;      // vertex_count           m

@compute @workgroup_size(kWorkgroupSize)
fn relax_springs(@builtin(global_invocation_id) id : vec3u) {
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
    let neighbour = neighbours[entry];
    let other = neighbour.node_and_kind & ((1u << kNeighbourNodeBits) - 1u);
    let kind = springs.kinds[neighbour.node_and_kind >> kNeighbourNodeBits];
    rest += (mobility * (kind.x + kind.y / dt)) * (change[other].xyz - own);
  }
  relax(node, own, rest, before.w);
}
