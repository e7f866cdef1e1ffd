// What smoothing has left on the finest level, r - A x: the next level's task. One invocation per node.
#include "gpu/index.wgsl"
#include "method/multigrid/fine_operator.wgsl"
//                                                                          elements       unit
@group(0) @binding(0) var<uniform>             step    : StepParams;
@group(0) @binding(1) var<uniform>             grid    : SpringGrid;
@group(0) @binding(2) var<uniform>             levels  : array<Level, 2>;
@group(0) @binding(3) var<storage, read>       place   : array<vec4f>;   // nx * ny        m (w: N/m; 0: held)
@group(0) @binding(4) var<storage, read>       holds   : array<vec4f>;   // method/multigrid/hold.wgsl
@group(0) @binding(5) var<storage, read_write> vectors : array<vec4f>;   // method/multigrid/level.wgsl

fn operand(level : Level, node : u32) -> vec3f { return vectors[vector_at(level, kFirst, node)].xyz; }

@compute @workgroup_size(kWorkgroupSize)
fn residual_fine(@builtin(global_invocation_id) id : vec3u) {
  let node = flat_index(id);
  if (node >= grid.nx * grid.ny) { return; }
  let level = levels[0];
  let j = node / grid.nx;
  var left = vec3f(0.0);
  if (place[node].w > 0.0) { left = vectors[vector_at(level, kResidual, node)].xyz - fine_product(level, node - j * grid.nx, j, node); }
  vectors[vector_at(level, kDirection, node)] = vec4f(left, 0.0);
}
