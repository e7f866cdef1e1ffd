// The end of a substep: each node's new position and velocity, and the force that holds it at obstacles. One invocation
// per node. A velocity's w is 1 where the next substep may read this one, -2 where an obstacle holds the node, and -1
// where it does by all that presses the node (contact/proximity/evaluate.wgsl).
// Source: docs/solvers/multigrid.md, equations 9 and 11.
#include "gpu/index.wgsl"
#include "method/multigrid/cloth.wgsl"
#include "method/multigrid/hold_force.wgsl"
#include "method/multigrid/spring.wgsl"
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
@group(0) @binding(9) var<storage, read_write> presses      : array<i32>;     // press_sums.wgsl

fn finish_held(among_all : u32) {
  let node = nodes.first_vertex + among_all;
  let now = position_in[node];
  let held_at = place[among_all].xyz;
  position_out[node] = vec4f(held_at, now.w);
  velocity_out[node] = vec4f((held_at - now.xyz) / step.time.dt, 1.0);
}

fn way_at(among_all : u32) -> u32 {
  return cloth * nodes.vectors + kWay * nodes.count + (among_all - cloth * nodes.count);
}

fn finish_free(among_all : u32, solution : vec3f) {
  let node = nodes.first_vertex + among_all;
  let now = position_in[node];
  let velocity = velocity_in[node];
  let formula = formula_of(step.time.step_ratio * max(velocity.w, 0.0));
  let way = vectors[way_at(among_all)].xyz + solution;
  let before = position_out[node].xyz;
  position_out[node] = vec4f(now.xyz + way, now.w);
  velocity_out[node] = vec4f((way - formula.c * (now.xyz - before)) / formula.he, 1.0);
}

fn finish_pressed(among_all : u32, solution : vec3f) {
  let node = nodes.first_vertex + among_all;
  let now = position_in[node];
  let start = vectors[way_at(among_all)].xyz;
  let way = start + solution;
  let hold = holds[among_all];
  let surface = holds[hold_way_at(among_all)];
  let force = holds[hold_force_at(among_all)];
  let kept = hold_force(node);
  let inertia = place[among_all].w;
  let stiffness = dot(hold.xyz, hold.xyz) + hold.w;
  let n = hold.xyz / length(hold.xyz);
  let grip = Grip(n, turned(kept.along, n), force.w, surface.xyz, force.y);
  let pressed = force.x - stiffness * dot(n, solution);
  let reached = reach_of(grip, way);
  let borne = max(0.0, pressed - inertia * surface.w);
  let along = no_longer(reached, grip.friction * borne);
  let had = select(no_longer(reach_of(grip, start), grip.friction * kept.normal), reached, hold.w > 0.0);
  // What acted beyond what counts is taken out of the velocity, and so is the speed at which a gap is restored.
  let more = along - had + max(0.0, -pressed) * n;
  let lack = (force.x - kept.normal) / stiffness;
  let closes = max(0.0, lack + dot(n, start - step.time.dt * velocity_in[node].xyz));
  let blow = stiffness * inertia / (stiffness + inertia) * closes;
  let stays = max(kLanded * borne, borne - max(0.0, blow - kept.normal));
  keep_hold_force(node, HoldForce(no_longer(along, grip.friction * stays), stays, false));
  let moved = way - surface.xyz - surface.w * n;  // over the surface, m
  let freed = no_longer(step.time.dt * now.w * more, kMostFreed / step.time.dt * length(moved));
  // Under cloth no force was kept: friction has not acted yet, and stops the way as well.
  let stopped = select(vec3f(0.0), step.time.dt * part_across(freed, n), kept.under_cloth);
  position_out[node] = vec4f(now.xyz + way + stopped, now.w);
  velocity_out[node] = vec4f((way - surface.w * n) / step.time.dt + freed, select(-2.0, -1.0, force.z > 0.0));
}

@compute @workgroup_size(kWorkgroupSize)
fn finish(@builtin(global_invocation_id) id : vec3u) {
  cloth = id.z;
  let index = flat_index(id);
  if (index >= nodes.count) { return; }
  let among_all = cloth * nodes.count + index;
  if (place[among_all].w == 0.0) {
    finish_held(among_all);
    return;
  }
  let solution = vectors[cloth * nodes.vectors + kSolution * nodes.count + index].xyz;
  if (is_pressed(among_all)) {
    finish_pressed(among_all, solution);
  } else {
    finish_free(among_all, solution);
  }
}
