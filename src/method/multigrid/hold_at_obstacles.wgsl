// The effect of obstacles on a node: equation 11 of docs/solvers/multigrid.md. The including kernel binds `step`,
// `holds` and `presses`.
#include "contact/proximity/press_sums.wgsl"
#include "method/multigrid/hold.wgsl"
#include "state/step.wgsl"
const kHoldStiffness = 10.0;  // of the trace of the diagonal
const kAgree = 0.3;           // of the normals: with less there is no one direction to hold it along

fn let_go(node : u32) {
  holds[node] = vec4f(0.0);
  holds[restored_at(node)] = vec4f(0.0);
}

// Clears the sums of `press` for the node, and its hold.
fn free_of_obstacles(node : u32, first_vertex : u32) {
  for (var word = 0u; word < kPressWords; word++) { presses[kPressWords * (first_vertex + node) + word] = 0; }
  let_go(node);
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

// Where the node would come nearer to obstacles than the thickness, or is there and pressed on: what holds it, also in
// `holds`. `inertia` is what that resists with, N/m; `residual` and `diagonal` are the node's without it; `start` is
// where its unknown starts, m.
fn hold_at_obstacles(node : u32, first_vertex : u32, inertia : f32, residual : vec3f, start : vec3f,
                     diagonal : Symmetric) -> Hold {
  let none = Hold(vec3f(0.0), zero_matrix());
  let word = kPressWords * (first_vertex + node);
  let weight = press_sum(word + kPressWeight) / kPressUnits;
  if (weight == 0.0) {
    let_go(node);
    return none;
  }
  let sum = press_vector(word + kPressNormal);
  let lack = press_sum(word + kPressLack) / (kLackUnits * weight) * step.contact.thickness;
  let surface = press_vector(word + kPressSurface) / weight;
  let friction = press_sum(word + kPressFriction) / (kPressUnits * weight);
  let restored = press_sum(word + kPressRestored) / (kLackUnits * weight) * step.contact.thickness;
  free_of_obstacles(node, first_vertex);
  let size = length(sum);
  if (size < kAgree * weight) { return none; }
  let n = sum / size;
  let pressed = inertia * lack - dot(residual, n);  // force that holds it there
  if (pressed <= 0.0) { return none; }
  let stiffness = kHoldStiffness * min(weight, 1.0) * (diagonal.diagonal.x + diagonal.diagonal.y + diagonal.diagonal.z);
  holds[restored_at(node)] = vec4f(restored / step.time.dt * n, 0.0);
  let borne = max(0.0, pressed - inertia * restored);
  let most = friction * borne * stiffness / (stiffness + inertia);  // compliance of the hold
  let slip = start - step.time.dt * surface;
  let along = slip - dot(slip, n) * n;
  let needed = -inertia * along - (residual - dot(residual, n) * n);
  let grip = length(needed);
  if (grip <= most) {
    holds[node] = vec4f(vec3f(0.0), stiffness);
    return Hold(stiffness * (lack * n - along), identity(stiffness));
  }
  holds[node] = vec4f(sqrt(stiffness) * n, 0.0);
  return Hold(stiffness * lack * n + (most / grip) * needed, outer(n, stiffness));
}
