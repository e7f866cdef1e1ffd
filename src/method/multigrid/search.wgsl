// The direction p of an iteration and A p, for one node. The including kernel binds `vectors`, `partials`, `place`,
// `nodes` and `pair_sums`, and has the Level and its product(level, x, node). Source: docs/solvers/multigrid.md,
// equation 14.
#include "method/multigrid/partial_sums.wgsl"
#include "method/multigrid/solve.wgsl"
#include "state/pair_sums.wgsl"
override kPairs : bool = false;  // true: pairs may be held apart, and A has their part
var<private> state : Solve;

// p = z + keep times the last p; the guess is the last p itself.
fn operand(level : Level, x : u32, node : u32) -> vec3f {
  let z = vectors[vector_at(level, kFirst, node)].xyz;
  return select(1.0, 0.0, state.turn == 0u) * z + state.keep * vectors[vector_at(level, x, node)].xyz;
}

fn search_from(level : Level, local : u32, node : u32, has_unknown : bool) {
  state = solve_state();
  let x = last_search(state);
  let is_idle = node >= node_count(level) || state.done;
  share_product(level, x, node, local, is_idle);
  var part = 0.0;
  if (!is_idle && local % kLanes == 0u) {
    let p = operand(level, x, node);
    var q = vec3f(0.0);
    if (has_unknown) { q = product(level, x, node); }
    let all = cloth * nodes.count + node;
    if (kPairs && is_held_by_pairs(nodes.first_vertex + all)) {
      q += place[all].w * take_pair_sum(nodes.first_vertex + all);
    }
    vectors[vector_at(level, this_search(state), node)] = vec4f(p, 0.0);
    vectors[vector_at(level, kProduct, node)] = vec4f(q, 0.0);
    part = dot(p, q);
  }
  store_partial(local, kLanes, node, node_count(level), vec2f(part, 0.0));
}
