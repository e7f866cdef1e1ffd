// Where a system behind the first is linearised, and what inertia, air and gravity leave of the equation there. What a
// pair or an obstacle holds now has no history. One invocation per node of a cloth; see predict.wgsl.
// Source: docs/solvers/multigrid.md, equations 1 to 4.
#include "gpu/index.wgsl"
#include "state/pair_sums.wgsl"
#include "contact/proximity/press_sums.wgsl"
#include "method/multigrid/cloth.wgsl"
#include "method/multigrid/inertia.wgsl"
//                                                                                  elements       unit
@group(0) @binding(0) var<uniform>             step            : StepBlock;
@group(0) @binding(1) var<uniform>             nodes           : ClothNodes;
@group(0) @binding(2) var<storage, read>       position_in     : array<vec4f>;   // vertex_count   m (w: 1/kg)
@group(0) @binding(3) var<storage, read_write> velocity_in     : array<vec4f>;   // vertex_count   m/s (w: 0 or 1)
@group(0) @binding(4) var<storage, read>       position_before : array<vec4f>;   // vertex_count   m
@group(0) @binding(5) var<storage, read>       velocity_before : array<vec4f>;   // vertex_count   m/s
@group(0) @binding(6) var<storage, read_write> place           : array<vec4f>;   // count          m (w: N/m)
@group(0) @binding(7) var<storage, read_write> vectors         : array<vec4f>;   // cloth.wgsl: the finest
@group(0) @binding(8) var<storage, read_write> pair_sums       : array<u32>;     // state/pair_holds.wgsl
@group(0) @binding(9) var<storage, read>       presses         : array<i32>;     // press_sums.wgsl
override kPairs : bool = false;
override kHolds : bool = false;  // whether obstacles may hold nodes

fn has_presses(vertex : u32) -> bool {
  let weight = press_words(vertex) + kPressWeight;
  return presses[weight] != 0 || presses[weight + kPressWraps] != 0;
}

@compute @workgroup_size(kWorkgroupSize)
fn predict_again(@builtin(global_invocation_id) id : vec3u) {
  let index = flat_index(id);
  if (index >= nodes.count) { return; }
  let among_all = id.z * nodes.count + index;
  let node = nodes.first_vertex + among_all;
  let first = id.z * nodes.vectors + index;
  let way = vectors[first + kWay * nodes.count].xyz;
  vectors[first + kFirst * nodes.count] = vec4f(0.0);
  if (place[among_all].w == 0.0) {
    vectors[first + kResidual * nodes.count] = vec4f(0.0);
    vectors[first + kSecond * nodes.count] = vec4f(way / step.time.dt, 0.0);
    return;
  }
  let now = NodeState(position_in[node], velocity_in[node]);
  var history = max(now.velocity.w, 0.0);
  if ((kPairs && is_held_by_pairs(node)) || (kHolds && has_presses(node))) {
    history = 0.0;
    velocity_in[node].w = 0.0;
  }
  let formula = formula_of(step.time.step_ratio * history);
  let x = now.position.xyz;
  let start_velocity = (way - formula.c * (x - position_before[node].xyz)) / formula.he;
  place[among_all] = vec4f(x + way, inertia_stiffness(now, formula));
  vectors[first + kResidual * nodes.count] =
      vec4f(inertia_residual(now, velocity_before[node].xyz, start_velocity, formula), 0.0);
  vectors[first + kSecond * nodes.count] = vec4f(start_velocity, 0.0);
}
