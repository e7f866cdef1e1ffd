// Where a vertex may be until the next search: within its slack of the segment from its place at the search along its
// way ahead. `predicted` holds, from vertex_count on, places, m, and slacks in w, and from 2 * vertex_count on the ways
// ahead, m. Source: docs/contact.md, Reach.
struct Reach {
  place : vec3f,
  slack : f32,
  ahead : vec3f,
}

const kWithin = 0.9999;  // of the slack: no rounding

// How far a place is from the segment, m.
fn distance_from_way(reach : Reach, x : vec3f) -> f32 {
  let away = x - reach.place;
  let square = dot(reach.ahead, reach.ahead);
  var part = 0.0;
  if (square > 0.0) { part = clamp(dot(away, reach.ahead) / square, 0.0, 1.0); }
  return length(away - part * reach.ahead);
}

// The place of the reach that is nearest to a place. Only what leads out of the reach is taken from a way, and not the
// motion that the cloth goes on with: a way that is cut short instead, as before obstacles, would stop falling cloth.
fn place_within(reach : Reach, x : vec3f) -> vec3f {
  let away = x - reach.place;
  let square = dot(reach.ahead, reach.ahead);
  var part = 0.0;
  if (square > 0.0) { part = clamp(dot(away, reach.ahead) / square, 0.0, 1.0); }
  let out = away - part * reach.ahead;
  let distance = length(out);
  if (distance <= reach.slack) { return x; }
  return reach.place + part * reach.ahead + kWithin * reach.slack / distance * out;
}
