// Where the ways of a listed pair of cloth end along the direction between its sides: they cannot meet if that
// direction still separates them there. The including kernel binds `previous`, `position`, `points` and `contacts`.
// Source: docs/contact.md, equation (6).
#include "state/contact.wgsl"
#include "contact/proximity/measure.wgsl"
#include "contact/proximity/planes.wgsl"
const kShortWay = 0.499;  // of the gap: less than half, by more than the rounding of either side's place

struct Ends {
  may_meet : bool,  // the sides keep a distance, and a way is as long as to the plane between them
  normal : vec3f,   // from B to A
  middle : f32,     // half way between the closest points at the start
  gap : f32,        // m
  thickness : f32,  // that the pair keeps, m
  along : vec4f,    // of each vertex on the normal, where its way ends. This and `middle` are seen from ids.x, m
  apart : f32,      // of the sides on the normal, there, m
}

// What is between the two sides at the start of the substep, m: the gap, and the distance that they keep. 0: nothing
// that must stay.
fn gap_of(words : vec4u) -> vec2f {
  if ((words.x & kHasRecord) == 0u) { return bitcast<vec2f>(words.zx) * select(1.0, 0.0, words.x == 0u); }
  let number = words.x & ~kHasRecord;
  return vec2f(select(contacts[number].normal.w, 0.0, contacts[number].solid != 0u), contacts[number].thickness);
}
// The direction from B to A, and where on edge A the closest point is.
fn line_of(ids : vec4u, words : vec4u) -> vec4f {
  if ((words.x & kHasRecord) == 0u) {
    let measured = measure(ids, words.w);
    return vec4f(measured.normal, measured.s);
  }
  let number = words.x & ~kHasRecord;
  return vec4f(contacts[number].normal.xyz, contacts[number].place.x);
}

fn place_of(vertex : u32) -> vec3f { return position[vertex & kIdBits].xyz; }
fn before_of(vertex : u32) -> vec3f { return previous[vertex & kIdBits].xyz; }

fn longest_way(ids : vec4u) -> f32 {
  var longest = 0.0;
  for (var role = 0u; role < 4u; role++) {
    longest = max(longest, distance(before_of(ids[role]), place_of(ids[role])));
  }
  return longest;
}

// Of each vertex along a direction, seen from where ids.x begins, m: where its way begins, and where it ends.
fn starts_along(ids : vec4u, n : vec3f) -> vec4f {
  let origin = before_of(ids.x);
  return vec4f(0.0, dot(n, before_of(ids.y) - origin), dot(n, before_of(ids.z) - origin),
               dot(n, before_of(ids.w) - origin));
}
fn ends_along(ids : vec4u, n : vec3f) -> vec4f {
  let origin = before_of(ids.x);
  return vec4f(dot(n, place_of(ids.x) - origin), dot(n, place_of(ids.y) - origin), dot(n, place_of(ids.z) - origin),
               dot(n, place_of(ids.w) - origin));
}

fn ends_of(ids : vec4u, words : vec4u) -> Ends {
  let between = gap_of(words);
  var ends = Ends(false, vec3f(0.0), 0.0, between.x, between.y, vec4f(0.0), 0.0);
  if (ends.gap <= 0.0 || longest_way(ids) < kShortWay * ends.gap - margin_of(ends.gap, ends.thickness)) { return ends; }
  let line = line_of(ids, words);
  let origin = before_of(ids.x);
  ends.may_meet = true;
  ends.normal = line.xyz;
  ends.middle = -0.5 * ends.gap;
  if (is_edge_pair(ids)) { ends.middle += line.w * dot(line.xyz, before_of(ids.y) - origin); }
  ends.along = ends_along(ids, line.xyz);
  ends.apart = sides_apart(ids, ends.along);
  return ends;
}

// Whether a plane between them that turns evenly keeps the sides apart: from the direction between them at the start to
// that between their closest points at the end. What is between a vertex of A and one of B along a direction that turns
// so is quadratic in time, and no less than the least of its three Bernstein coefficients: equation (6e).
fn turn_apart(ids : vec4u, ends : Ends, least : f32) -> bool {
  let origin = before_of(ids.x);
  let near = closest_of_pair(is_edge_pair(ids), place_of(ids.x) - origin, place_of(ids.y) - origin,
                             place_of(ids.z) - origin, place_of(ids.w) - origin);
  let then = near.apart / max(length(near.apart), kLeast);
  return sides_apart(ids, ends_along(ids, then)) >= least &&
         0.5 * sides_apart(ids, ends.along + starts_along(ids, then)) >= least;
}

// Whether they end nearer than they must, and may have met: not nearer than they are, and not nearer than the margins.
fn end_too_near(ids : vec4u, ends : Ends) -> bool {
  let least = least_apart(ends.gap, ends.thickness);
  if (!ends.may_meet || ends.apart >= least) { return false; }
  return !turn_apart(ids, ends, least);
}
