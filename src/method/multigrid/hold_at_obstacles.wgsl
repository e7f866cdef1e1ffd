// The effect of obstacles on a node: equation 11 of docs/solvers/multigrid.md. The including kernel binds `step`,
// `holds` and `presses`.
#include "method/multigrid/hold_force.wgsl"
#include "state/step.wgsl"
const kAgree = 0.3;  // of the normals: with less there is no one direction to hold it along
const kAlike = 0.9;  // with no less its pairs are the hold's: src/contact/proximity/evaluate.wgsl

fn let_go(node : u32, vertex : u32) {
  holds[node] = vec4f(0.0);
  keep_hold_force(vertex, HoldForce(vec3f(0.0), 0.0, false));
}

fn clear_presses(vertex : u32) {
  for (var word = 0u; word < kPressWords; word++) { presses[press_words(vertex) + word] = 0; }
}

// Clears the sums of `press` for the node, and its hold.
fn free_of_obstacles(node : u32, first_vertex : u32) {
  clear_presses(first_vertex + node);
  let_go(node, first_vertex + node);
}

fn press_sum(word : u32) -> f32 {
  return f32(presses[word + kPressWraps]) * 0x1p32 + f32(presses[word]);
}
fn press_vector(word : u32) -> vec3f {
  return vec3f(press_sum(word), press_sum(word + 1u), press_sum(word + 2u)) / kPressUnits;
}

struct Hold {
  force : vec3f,      // N: to where the node belongs
  block : Symmetric,  // N/m: its part of the matrix
}

// Where obstacles press the node: what holds it, also in `holds`. `inertia` is what that resists with, N/m; `residual`
// is the node's without it; `start` is its kWay. In a second system the residual is what stiff springs have left, and
// no load that would lift the node off.
fn hold_at_obstacles(node : u32, first_vertex : u32, inertia : f32, residual : vec3f, start : vec4f) -> Hold {
  let none = Hold(vec3f(0.0), zero_matrix());
  let vertex = first_vertex + node;
  let word = press_words(vertex);
  let weight = press_sum(word + kPressWeight) / kPressUnits;
  if (weight == 0.0) {
    let_go(node, vertex);
    return none;
  }
  let sum = press_vector(word + kPressNormal);
  let wanted = press_sum(word + kPressLack) / (kLackUnits * weight) * step.contact.thickness;
  let surface = press_vector(word + kPressSurface) / weight;
  let friction = press_sum(word + kPressFriction) / (kPressUnits * weight);
  let gap = press_sum(word + kPressRestored) / (kLackUnits * weight) * step.contact.thickness;
  let kept = hold_force(vertex);
  free_of_obstacles(node, first_vertex);
  let size = length(sum);
  if (size < kAgree * weight) { return none; }
  let n = sum / size;
  let bears = kept.normal > 0.0;
  let part = select(1.0, min(1.0, kHoldRate * step.time.dt / kHoldPart), bears);
  let restored = min(part * gap, kHoldSpeed * step.time.dt);
  let lack = wanted - (gap - restored);
  // What bears has its load in the force that it bore: its residual reads its neighbours' speeds.
  let pull = select(dot(residual, n), 0.0, start.w == 1.0);
  if (inertia * lack + select(-pull, kept.normal, bears) <= 0.0) { return none; }
  keep_hold_force(vertex, kept);
  let soft = min(weight, 1.0) * inertia;
  let stiffness = kHoldStiffness * soft;
  let grip = Grip(n, turned(kept.along, n), soft, step.time.dt * surface, friction);
  let normal = kept.normal + stiffness * lack;
  holds[hold_way_at(node)] = vec4f(grip.surface_way, restored);
  let alike = size >= kAlike * weight && bears;
  holds[hold_force_at(node)] = vec4f(normal, friction, select(0.0, 1.0, alike), 0.0);
  let tried = reach_of(grip, start.xyz);
  let most = friction * kept.normal;
  if (length(tried) <= most) {
    holds[node] = vec4f(sqrt(stiffness - soft) * n, soft);
    return Hold(normal * n + tried, sum_of(outer(n, stiffness - soft), identity(soft)));
  }
  holds[node] = vec4f(sqrt(stiffness) * n, 0.0);
  return Hold(normal * n + no_longer(tried, most), outer(n, stiffness));
}
