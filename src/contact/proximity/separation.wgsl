// How the sides of a pair of cloth are separated: as by an inelastic blow along the direction between them, which adds
// no momentum. The including kernel binds `previous`. Source: docs/contact.md, equation (6d).
#include "state/contact.wgsl"
const kNowhere = 1e30;  // m

// Of a pair's vertices: 0 kg is not moved; and of these, what stays, so that the other side gives way.
struct Movers { mass : vec4f, stays : vec4<bool> }

// Equation (6d). `bends`: where a plane between the sides begins to move a vertex.
fn moved_by(plane : f32, bends : vec4f, on_a : vec4<bool>) -> vec4f {
  let beyond = vec4f(plane) - bends;
  return select(min(beyond, vec4f(0.0)), max(beyond, vec4f(0.0)), on_a);
}
fn shifts_of(ids : vec4u, along : vec4f, apart : f32, who : Movers) -> vec4f {
  let on_a = vec4<bool>(true, is_edge_pair(ids), false, false);
  let bends = along + select(vec4f(0.5 * apart), vec4f(-0.5 * apart), on_a);
  let moves = who.mass > vec4f(0.0);
  var below = -kNowhere;  // the bends about the plane that adds no momentum
  var above = kNowhere;
  var least = -kNowhere;  // before what stays
  var most = kNowhere;
  for (var role = 0u; role < 4u; role++) {
    let bend = bends[role];
    if (!moves[role]) {
      if (!who.stays[role]) { continue; }
      if (on_a[role]) { most = min(most, bend); } else { least = max(least, bend); }
      continue;
    }
    let added = dot(who.mass, moved_by(bend, bends, on_a));
    if (added <= 0.0) { below = max(below, bend); } else { above = min(above, bend); }
  }
  var plane = select(below, above, below == -kNowhere);
  if (below > -kNowhere && above < kNowhere) {
    let lack = -dot(who.mass, moved_by(below, bends, on_a));
    let surplus = dot(who.mass, moved_by(above, bends, on_a));
    plane = below + (above - below) * (lack / (lack + surplus));
  }
  return select(vec4f(0.0), moved_by(clamp(plane, least, max(least, most)), bends, on_a), moves);
}

fn movers_by_whole_mass(ids : vec4u) -> Movers {
  let at = ids & vec4u(kIdBits);
  let inverse_mass = vec4f(previous[at.x].w, previous[at.y].w, previous[at.z].w, previous[at.w].w);
  let stays = inverse_mass <= vec4f(0.0);
  return Movers(select(1.0 / inverse_mass, vec4f(0.0), stays), stays);
}
