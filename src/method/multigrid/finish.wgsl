// The end of a substep: each node's new position and velocity, and what the solution took. One invocation per node.
// Source: docs/solvers/multigrid.md, equation 9.
#include "gpu/finite.wgsl"
#include "gpu/index.wgsl"
#include "method/multigrid/cloth.wgsl"
#include "method/multigrid/hold.wgsl"
#include "method/multigrid/solve.wgsl"
#include "method/multigrid/spring.wgsl"
#include "state/statistics.wgsl"
//                                                                               elements       unit
@group(0) @binding(0) var<uniform>             step         : StepBlock;
@group(0) @binding(1) var<uniform>             nodes        : ClothNodes;
@group(0) @binding(2) var<storage, read>       place        : array<vec4f>;   // count          m (w: N/m; 0: fixed)
@group(0) @binding(3) var<storage, read>       holds        : array<vec4f>;   // method/multigrid/hold.wgsl
@group(0) @binding(4) var<storage, read>       vectors      : array<vec4f>;   // method/multigrid/cloth.wgsl: the finest
@group(0) @binding(5) var<storage, read>       position_in  : array<vec4f>;   // vertex_count   m (w: 1/kg)
@group(0) @binding(6) var<storage, read>       velocity_in  : array<vec4f>;   // vertex_count   m/s (w: as in predict)
@group(0) @binding(7) var<storage, read_write> position_out : array<vec4f>;   // vertex_count   m; came as a step before
@group(0) @binding(8) var<storage, read_write> velocity_out : array<vec4f>;   // vertex_count   m/s
@group(0) @binding(9) var<storage, read_write> statistics   : array<atomic<u32>>;

fn finish_held(among_all : u32) {
  let node = nodes.first_vertex + among_all;
  let now = position_in[node];
  let held_at = place[among_all].xyz;
  position_out[node] = vec4f(held_at, now.w);
  velocity_out[node] = vec4f((held_at - now.xyz) / step.time.dt, 1.0);
}

fn finish_free(among_all : u32, solution : vec3f) {
  let node = nodes.first_vertex + among_all;
  let now = position_in[node];
  let velocity = velocity_in[node];
  let pressed = is_pressed(among_all);
  let formula = formula_of(select(step.time.step_ratio * velocity.w, 0.0, pressed));
  let way = step.time.dt * velocity.xyz + solution;
  let before = position_out[node].xyz;
  position_out[node] = vec4f(now.xyz + way, now.w);
  var after = (way - formula.c * (now.xyz - before)) / formula.he;
  if (pressed) { after -= holds[restored_at(among_all)].xyz; }
  velocity_out[node] = vec4f(after, select(1.0, 0.0, pressed));
}

fn report() {
  let state = solve_state();
  atomicMax(&statistics[kStatIterations], max(state.turn, 1u) - 1u);
  let has_norm = is_finite(vec3f(state.first, state.left, 0.0));
  if (has_norm && state.first > 0.0) {
    atomicMax(&statistics[kStatResidual], bitcast<u32>(sqrt(state.left / state.first)));
  }
  if (state.done && has_norm) { return; }
  if (nodes.may_retry == 1u && has_norm) {
    atomicStore(&statistics[kStatRolledBack], 1u);
  } else {
    atomicAdd(&statistics[kStatUnsolved], 1u);
  }
}

@compute @workgroup_size(kWorkgroupSize)
fn finish(@builtin(global_invocation_id) id : vec3u) {
  cloth = id.z;
  let index = flat_index(id);
  if (index >= nodes.count) { return; }
  if (index == 0u) { report(); }
  let among_all = cloth * nodes.count + index;
  if (place[among_all].w == 0.0) {
    finish_held(among_all);
  } else {
    finish_free(among_all, vectors[cloth * nodes.vectors + kSolution * nodes.count + index].xyz);
  }
}
