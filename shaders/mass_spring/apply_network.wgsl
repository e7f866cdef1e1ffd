// y = A x for A = M^-1/2 K M^-1/2, where K sums k n n^T over the springs at rest (or, for the damping, c n n^T). One
// invocation per node. Source: docs/solvers/mass_spring.md, "the stability limit".
#include "shared/index.wgsl"
#include "shared/neighbour.wgsl"
struct PowerParams {  // mirror: src/solver/mass_spring/stability.hpp
  count : u32,
  use_damping : u32,
}
//                                                                             elements               unit
@group(0) @binding(0) var<uniform>             params     : PowerParams;
@group(0) @binding(1) var<storage, read>       offsets    : array<u32>;        // count + 1
@group(0) @binding(2) var<storage, read>       neighbours : array<Neighbour>;  // 2 * springs
@group(0) @binding(3) var<storage, read>       position   : array<vec4f>;      // count                  m (w: inverse mass, 1/kg)
@group(0) @binding(4) var<storage, read>       x          : array<vec4f>;      // count
@group(0) @binding(5) var<storage, read_write> y          : array<vec4f>;      // count                  1/s² (damping: 1/s)

@compute @workgroup_size(kWorkgroupSize)
fn apply_network(@builtin(global_invocation_id) id : vec3u) {
  let node = flat_index(id);
  if (node >= params.count) { return; }
  let here = position[node];
  let root = sqrt(here.w);
  let value = root * x[node].xyz;
  var sum = vec3f(0.0);
  for (var entry = offsets[node]; entry < offsets[node + 1u]; entry++) {
    let spring = neighbours[entry];
    let there = position[spring.node];
    let span = there.xyz - here.xyz;
    let direction = span / length(span);
    let coefficient = select(spring.stiffness, spring.damping, params.use_damping == 1u);
    sum += coefficient * dot(direction, value - sqrt(there.w) * x[spring.node].xyz) * direction;
  }
  y[node] = vec4f(root * sum, 0.0);
}
