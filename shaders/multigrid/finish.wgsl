// The last step of smoothing, and with it the substep's end: the node's new position and velocity. One invocation per node. Source:
// docs/solvers/multigrid.md, equations 8 and 9.
#include "shared/index.wgsl"
#include "multigrid/chebyshev.wgsl"
#include "multigrid/fine_operator.wgsl"
//                                                                               elements       unit
@group(0) @binding(0) var<uniform>             step         : StepParams;
@group(0) @binding(1) var<uniform>             grid         : SpringGrid;
@group(0) @binding(2) var<uniform>             levels       : array<Level, 2>;
@group(0) @binding(3) var<storage, read>       place        : array<vec4f>;   // nx * ny        m (w: N/m; 0: held)
@group(0) @binding(4) var<storage, read>       holds        : array<vec4f>;   // multigrid/hold.wgsl
@group(0) @binding(5) var<storage, read>       vectors      : array<vec4f>;   // multigrid/level.wgsl
@group(0) @binding(6) var<storage, read>       position_in  : array<vec4f>;   // vertex_count   m (w: inverse mass, 1/kg)
@group(0) @binding(7) var<storage, read>       velocity_in  : array<vec4f>;   // vertex_count   m/s (w: as in predict)
@group(0) @binding(8) var<storage, read_write> position_out : array<vec4f>;   // vertex_count   m; comes as it was a step before
@group(0) @binding(9) var<storage, read_write> velocity_out : array<vec4f>;   // vertex_count   m/s

fn operand(level : Level, node : u32) -> vec3f { return vectors[vector_at(level, kSecond, node)].xyz; }

@compute @workgroup_size(kWorkgroupSize)
fn finish(@builtin(global_invocation_id) id : vec3u) {
  let index = flat_index(id);
  if (index >= grid.nx * grid.ny) { return; }
  let node = grid.first_vertex + index;
  let now = position_in[node];
  let held_at = place[index];
  if (held_at.w == 0.0) {
    position_out[node] = vec4f(held_at.xyz, now.w);
    velocity_out[node] = vec4f((held_at.xyz - now.xyz) / step.dt, 1.0);
    return;
  }
  let level = levels[0];
  let j = index / grid.nx;
  let left = vectors[vector_at(level, kResidual, index)].xyz - fine_product(level, index - j * grid.nx, j, index);
  let d = vectors[vector_at(level, kDirection, index)].xyz;
  let solution = operand(level, index) + kKeep * d + kTake * times(inverse_at(level, index), left);
  let velocity = velocity_in[node];
  let pressed = is_pressed(index);
  let formula = formula_of(select(step.step_ratio * velocity.w, 0.0, pressed));
  let way = step.dt * velocity.xyz + solution;
  let before = position_out[node].xyz;
  position_out[node] = vec4f(now.xyz + way, now.w);
  velocity_out[node] = vec4f((way - formula.c * (now.xyz - before)) / formula.he, select(1.0, 0.0, pressed));
}
