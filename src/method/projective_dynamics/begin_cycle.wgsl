// The end of a cycle's first dispatch for a node. The including kernel binds `way_next`, `left`, `change`, and
// `aim` to read and write. Source: docs/solvers/projective_dynamics.md, equations 3 and 4.
#include "method/projective_dynamics/allowed_change.wgsl"

// What the node's global system has left where its way, of w 1/kg, is `own`, and the first Jacobi step.
fn begin_cycle(node : u32, own : vec4f, rest : vec3f) {
  let kept = select(rest, vec3f(0.0), own.w == 0.0);  // it goes where it is led
  let first = allowed_change(node, own.xyz, gain() * kept, own.w);
  left[node] = vec4f(kept, own.w);
  change[node] = vec4f(first, 0.0);
  way_next[node] = vec4f(own.xyz + first, own.w);
}
