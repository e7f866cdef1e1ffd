// Where a substep is linearised at first, where its unknown starts from, and what inertia, air and gravity leave of the
// equation there. One invocation per node of a cloth. A velocity's w is 1 where the state before it is that of the step
// before; a place's w is the inertia on the matrix's diagonal, 0 where the node is fixed.
// Source: docs/solvers/multigrid.md, equations 1 to 4.
#include "gpu/index.wgsl"
#include "state/integrate.wgsl"
#include "method/multigrid/cloth.wgsl"
#include "method/multigrid/inertia.wgsl"
//                                                                                  elements       unit
@group(0) @binding(0) var<uniform>             step            : StepBlock;
@group(0) @binding(1) var<uniform>             nodes           : ClothNodes;
@group(0) @binding(2) var<storage, read>       position_in     : array<vec4f>;   // vertex_count   m (w: 1/kg)
@group(0) @binding(3) var<storage, read>       velocity_in     : array<vec4f>;   // vertex_count   m/s (w: 0 or 1)
@group(0) @binding(4) var<storage, read>       position_before : array<vec4f>;   // vertex_count   m
@group(0) @binding(5) var<storage, read>       velocity_before : array<vec4f>;   // vertex_count   m/s
@group(0) @binding(6) var<storage, read>       rest            : array<vec4f>;   // vertex_count   m (w: motion)
@group(0) @binding(7) var<storage, read>       motions         : array<vec4f>;   // 3 * motions * substeps
@group(0) @binding(8) var<storage, read_write> place           : array<vec4f>;   // count          m (w: N/m)
@group(0) @binding(9) var<storage, read_write> vectors         : array<vec4f>;   // cloth.wgsl: the finest

@compute @workgroup_size(kWorkgroupSize)
fn predict(@builtin(global_invocation_id) id : vec3u) {
  let index = flat_index(id);
  if (index >= nodes.count) { return; }
  let among_all = id.z * nodes.count + index;
  let node = nodes.first_vertex + among_all;
  let now = NodeState(position_in[node], velocity_in[node]);
  let first = id.z * nodes.vectors + index;
  let residual_at = first + kResidual * nodes.count;
  let start_at = first + kFirst * nodes.count;
  let start_velocity_at = first + kSecond * nodes.count;
  let guess_at = first + kSearch * nodes.count;
  let way_at = first + kWay * nodes.count;
  if (is_prescribed(node, now)) {
    let after = integrate_prescribed(node, now);
    place[among_all] = vec4f(after.position.xyz, 0.0);
    vectors[residual_at] = vec4f(0.0);
    vectors[start_at] = vec4f(0.0);
    vectors[start_velocity_at] = vec4f(after.velocity.xyz, 0.0);
    vectors[guess_at] = vec4f(0.0);
    vectors[way_at] = vec4f(after.position.xyz - now.position.xyz, 0.0);
    return;
  }
  let formula = formula_of(step.time.step_ratio * max(now.velocity.w, 0.0));
  let x = now.position.xyz;
  let v = now.velocity.xyz;
  let start = step.time.dt * v;
  let change = v - velocity_before[node].xyz;
  let start_velocity = (start - formula.c * (x - position_before[node].xyz)) / formula.he;
  let guess = formula.he * (v + step.time.step_ratio * change - start_velocity);
  place[among_all] = vec4f(x, inertia_stiffness(now, formula));
  vectors[residual_at] = vec4f(inertia_residual(now, velocity_before[node].xyz, start_velocity, formula), 0.0);
  vectors[start_at] = vec4f(start, 0.0);
  vectors[start_velocity_at] = vec4f(start_velocity, 0.0);
  vectors[way_at] = vec4f(start, 0.0);
  let has_guess = now.velocity.w == 1.0 && step.time.step_ratio > 0.0;
  vectors[guess_at] = vec4f(select(vec3f(0.0), guess, has_guess), 0.0);
}
