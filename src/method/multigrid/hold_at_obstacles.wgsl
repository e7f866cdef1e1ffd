// The effect of obstacles on a node: equation 11 of docs/solvers/multigrid.md. The including kernel binds `step`,
// `holds` and `presses`.
#include "contact/proximity/pressed_vertex.wgsl"
#include "method/multigrid/hold_force.wgsl"
#include "state/step.wgsl"

override kBody : bool = false;  // it has a volume: what it weighs behind a node is held by that node

fn let_go(node : u32, vertex : u32) {
  holds[node] = vec4f(0.0);
  keep_hold_force(vertex, HoldForce(vec3f(0.0), 0.0, false));
}

// Clears the sums of `press` for the node, and its hold.
fn free_of_obstacles(node : u32, first_vertex : u32) {
  clear_presses(first_vertex + node);
  let_go(node, first_vertex + node);
}

struct Hold {
  force : vec3f,      // N: to where the node belongs
  block : Symmetric,  // N/m: its part of the matrix
}

// Where obstacles press the node: what holds it, also in `holds`. `inertia` is what that resists with, N/m; `diagonal`
// and `residual` are the node's without it; `start` is its kWay. In a second system the residual is what stiff springs
// have left, and no load that would lift the node off.
fn hold_at_obstacles(node : u32, first_vertex : u32, inertia : f32, diagonal : Symmetric, residual : vec3f,
                     start : vec4f) -> Hold {
  let none = Hold(vec3f(0.0), zero_matrix());
  let vertex = first_vertex + node;
  let pressed = pressed_vertex(vertex);
  let weight = pressed.weight;
  if (weight == 0.0) {
    let_go(node, vertex);
    return none;
  }
  let kept = hold_force(vertex);
  free_of_obstacles(node, first_vertex);
  let size = length(pressed.normal);
  if (size < kAgree * weight) { return none; }
  let n = pressed.normal / size;
  let bears = kept.normal > 0.0;
  let part = select(1.0, min(1.0, kHoldRate * step.time.dt / kHoldPart), bears);
  let restored = min(part * pressed.gap, kHoldSpeed * step.time.dt);
  let lack = pressed.lack - (pressed.gap - restored);
  // What bears has its load in the force that it bore: its residual reads its neighbours' speeds.
  let pull = select(dot(residual, n), 0.0, start.w == 1.0);
  if (inertia * lack + select(-pull, kept.normal, bears) <= 0.0) { return none; }
  keep_hold_force(vertex, kept);
  let soft = min(weight, 1.0) * inertia;
  var stiffness = kHoldStiffness * soft;
  if (kBody) { stiffness *= sqrt(dot(n, times(diagonal, n)) / inertia); }
  let grip = Grip(n, turned(kept.along, n), soft, step.time.dt * pressed.surface, pressed.friction);
  let normal = kept.normal + stiffness * lack;
  holds[hold_way_at(node)] = vec4f(grip.surface_way, restored);
  let alike = size >= kAlike * weight && bears;
  holds[hold_force_at(node)] = vec4f(normal, pressed.friction, select(0.0, 1.0, alike), soft);
  let tried = reach_of(grip, start.xyz);
  let most = pressed.friction * kept.normal;
  if (length(tried) <= most) {
    holds[node] = vec4f(sqrt(stiffness - soft) * n, soft);
    return Hold(normal * n + tried, sum_of(outer(n, stiffness - soft), identity(soft)));
  }
  holds[node] = vec4f(sqrt(stiffness) * n, 0.0);
  return Hold(normal * n + no_longer(tried, most), outer(n, stiffness));
}
