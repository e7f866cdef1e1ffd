// The nodes of one colour, and their elements, in `lists`: nodes by colours, then rows of nodes and their entries. How
// a node of it descends: the including kernel binds color, lists, aim and way, includes step.wgsl, and has
// pull_of(entry). Source: docs/solvers/vbd.md, equations 3 and 4.
#include "method/vbd/descended.wgsl"

struct GatheredColor {  // mirror: src/method/vbd/gathered_color.hpp
  first : u32,       // in `lists`
  count : u32,
  first_node : u32,  // of the body
  rows : u32,        // where in `lists` its nodes' rows begin, and with that their entries
}

// The pull of an element at one of its nodes, and how fast it grows against the node's way.
struct Pull {
  force : vec3f,        // N
  hessian : Symmetric,  // N/m
}

fn descend(index : u32) {
  if (index >= color.count) { return; }
  let node = lists[color.first + index];
  let own = way[node];
  if (own.w == 0.0) { return; }
  let mobility = step.time.dt * step.time.dt * own.w;  // m/N
  var slope = aim[node].xyz - own.xyz;
  var hessian = identity(1.0);
  let row = color.rows + node - color.first_node;
  for (var at = lists[row]; at < lists[row + 1u]; at++) {
    let pull = pull_of(lists[color.rows + at]);
    slope += mobility * pull.force;
    hessian = sum_of(hessian, scaled(mobility, pull.hessian));
  }
  way[node] = vec4f(descended(node, own.xyz, hessian, slope), own.w);
}
