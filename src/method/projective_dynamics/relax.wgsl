// A further iteration of a cycle for a node. The including kernel binds `iteration`, `change_next`, `left`, `way`, and
// `aim` to read and write. Source: docs/solvers/projective_dynamics.md, equation 4.
#include "method/projective_dynamics/allowed_change.wgsl"

struct Iteration {  // mirror: src/method/projective_dynamics/relaxed_cloth.hpp
  weight : f32,
}

// `own` is its last change, and `rest` what that has left, m.
fn relax(node : u32, own : vec3f, rest : vec3f, inverse_mass : f32) {
  let before = way[node].xyz;
  let free = iteration.weight * gain() * rest + (iteration.weight - 1.0) * own;
  let next = allowed_change(node, before, free, inverse_mass);
  left[node] = vec4f(rest, inverse_mass);
  change_next[node] = vec4f(next, 0.0);
  way[node] = vec4f(before + next, inverse_mass);
}
