// What obstacles ask of a node as constraints without compliance, projected like those of elements: how far they have
// moved it in the substep is kept in `aim`, so that a later projection can take back what an earlier one gave too much.
// The including kernel binds `step`, and `aim` and `way` to read and write. Source: docs/solvers/xpbd.md, equations 19
// and 20.
#include "contact/proximity/friction.wgsl"
#include "method/holds/node_holds.wgsl"

fn project_hold(node : u32) {
  let at = hold_at(node);
  let own = way[node];
  if (aim[at + 2u].y == kFree || own.w == 0.0) { return; }
  let n = aim[at].xyz;
  let surface = aim[at + 1u];
  let before = aim[node].xyz;
  let normal = max(0.0, dot(n, before) + (aim[at].w - dot(n, own.xyz)));
  let tried = part_across(before - (own.xyz - surface.xyz), n);
  let held = normal * n + no_longer(tried, surface.w * normal);
  aim[node] = vec4f(held, 0.0);
  aim[at + 2u].y = select(kPressed, kBears, normal > 0.0);
  way[node] = vec4f(own.xyz + (held - before), own.w);
}
