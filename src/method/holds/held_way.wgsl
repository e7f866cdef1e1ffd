// Where a node's own part of what the substep minimises is least, its neighbours where they are, of the ways that
// obstacles allow. The including kernel binds `step`, and `aim` to read and write.
// Source: docs/solvers/vbd.md, equation 7.
#include "contact/proximity/friction.wgsl"
#include "method/holds/node_holds.wgsl"
#include "method/symmetric.wgsl"
override kHolds : bool = false;  // obstacles are answered here: node_holds.wgsl
const kLeastCompliance = 0.25;   // along the normal, the part that friction of what slides leaves of it, at least

// `free`: where it is least of all ways. Where the matrix is a multiple of 1, both may be 1.
fn held_way(node : u32, free : vec3f, hessian : Symmetric, compliance : Symmetric) -> vec3f {
  let at = hold_at(node);
  if (aim[at + 2u].y == kFree) { return free; }
  let n = aim[at].xyz;
  let least = aim[at].w;
  let lack = least - dot(n, free);
  aim[at + 2u].y = select(kPressed, kBears, lack > 0.0);
  if (!(lack > 0.0)) { return free; }
  let surface = aim[at + 1u];
  let stuck = part_across(surface.xyz, n) + least * n;
  let needed = times(hessian, stuck - free);
  let along = part_across(needed, n);
  let size = length(along);
  if (size <= surface.w * dot(n, needed)) { return stuck; }
  let pull = n + surface.w / size * along;
  let soft = max(dot(n, times(compliance, pull)), kLeastCompliance * dot(n, times(compliance, n)));
  return free + lack / soft * times(compliance, pull);
}
