// The plane before a solid side that a pair keeps to which slides along it. The including kernel has the places where
// vertices of cloth end, end_of_way(vertex), and binds as measure.wgsl asks. Source: docs/contact.md, equation (6j).
#include "contact/proximity/measure.wgsl"
#include "contact/proximity/planes.wgsl"
#include "contact/proximity/solid_reach.wgsl"

const kTurningWay = 0.4;  // of the gap: two sides that go less than that come to no plane between them

// The roles of a pair's solid side, its first one and what is behind its last one, and of the cloth before it.
struct SolidSide {
  first : u32,
  last : u32,
  cloth_first : u32,
  cloth_last : u32,
  toward : f32,  // the cloth along the direction from B to A: 1 or -1
}
fn solid_side_of(ids : vec4u, solid : u32) -> SolidSide {
  let middle = roles_of_a(ids);
  if (solid == 1u) { return SolidSide(0u, middle, middle, role_count(ids), -1.0); }
  return SolidSide(middle, role_count(ids), 0u, middle, 1.0);
}

// The corners of a pair at the start of the substep and at its end, seen from the first at the start, m.
struct MovingPair {
  ids : vec4u,
  start : array<vec3f, 4>,
  end : array<vec3f, 4>,
}
fn moving_pair(ids : vec4u) -> MovingPair {
  var pair = MovingPair(ids, array<vec3f, 4>(), array<vec3f, 4>());
  let origin = start_of(ids.x).xyz;
  for (var role = 0u; role < 4u; role++) {
    pair.start[role] = start_of(ids[role]).xyz - origin;
    pair.end[role] = end_in_substep(ids, ids[role]) - origin;
  }
  return pair;
}

fn apart_along(ids : vec4u, at : array<vec3f, 4>, n : vec3f) -> f32 {
  return sides_apart(ids, vec4f(dot(n, at[0]), dot(n, at[1]), dot(n, at[2]), dot(n, at[3])));
}

// A direction from B to A, and how far they are apart along it at the end, m.
struct Apart {
  normal : vec3f,
  at_end : f32,
}
// The better of one and another direction, which has to separate them at the start.
fn farther_apart(pair : MovingPair, best : Apart, direction : vec3f, least : f32) -> Apart {
  let n = direction / max(length(direction), kLeast);
  if (!(apart_along(pair.ids, pair.start, n) >= least)) { return best; }
  let at_end = apart_along(pair.ids, pair.end, n);
  if (at_end <= best.at_end) { return best; }
  return Apart(n, at_end);
}

// Equation (6j): where a way is so long that it may come to the plane along n, that direction along which the sides end
// farthest apart, of n, the normal of the features, the direction between the closest points at the end, and the one
// half way to it. Not of spheres, capsules and planes.
fn turned_normal(ids : vec4u, measured : Measured, thickness : f32) -> vec3f {
  let n = measured.normal;
  if (measured.radius > 0.0 || is_shape_pair(ids)) { return n; }
  let pair = moving_pair(ids);
  var longest = 0.0;
  for (var role = 0u; role < 4u; role++) { longest = max(longest, distance(pair.start[role], pair.end[role])); }
  if (longest < kTurningWay * measured.gap) { return n; }
  let least = margin_before_solid(measured.gap, thickness);
  let edges = is_edge_pair(ids);
  let near = closest_of_pair(edges, pair.end[0], pair.end[1], pair.end[2], pair.end[3]);
  let then = near.apart / max(length(near.apart), kLeast);
  let first = pair.start[1] - select(pair.start[2], pair.start[0], edges);
  let across = cross(first, pair.start[3] - pair.start[2]);  // of the edges, or the triangle
  var best = Apart(n, apart_along(pair.ids, pair.end, n));
  best = farther_apart(pair, best, select(-across, across, dot(across, n) > 0.0), least);
  best = farther_apart(pair, best, then, least);
  return farther_apart(pair, best, n + then, least).normal;
}
