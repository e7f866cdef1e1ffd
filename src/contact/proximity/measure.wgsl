// The relative position of the two features of a listed pair at the start of a substep, and a collider's friction. The
// including kernel binds `step`, `previous` and `points`. Source: docs/contact.md.
#include "state/step.wgsl"
#include "state/contact.wgsl"
#include "contact/proximity/closest.wgsl"

struct Measured {
  s : f32,          // where on the features: weights_of
  t : f32,
  counts : bool,    // both places are inside: an end of an edge is a vertex, which has its own pairs
  normal : vec3f,   // from B to A
  gap : f32,        // m
  radius : f32,     // m: of a sphere or capsule
  place_a : f32,    // n·p_A, m
}

fn start_of(id : u32) -> vec4f {
  if (is_collider(id)) { return points[id & kIdBits]; }
  return previous[id & kIdBits];
}
fn end_of(id : u32) -> vec4f { return points[step.contact.point_count + (id & kIdBits)]; }

// Whether the shape of a vertex's pair is a plane.
fn is_plane_pair(ids : vec4u) -> bool { return is_shape_pair(ids) && start_of(ids.y).w <= 0.0; }

// How a plane that turns moves below the vertex of a pair, beside what its point does, m/s. Its spin is the point after
// its normal.
fn turn_of_plane(ids : vec4u) -> vec3f {
  let plane = ids.y & kIdBits;
  let n = points[plane + 1u].xyz;
  let arm = start_of(ids.x).xyz - points[plane].xyz;
  return cross(points[plane + 2u].xyz, arm - dot(n, arm) * n);
}

// Where a collider's point of a pair comes; of a plane, with what lies below the vertex.
fn end_in_pair(ids : vec4u, id : u32) -> vec3f {
  let end = end_of(id).xyz;
  if (!is_plane_pair(ids)) { return end; }
  return end + step.time.dt * turn_of_plane(ids);
}

// Features that are in each other, but for rounding, have no direction apart that means anything.
const kNoDistance = 4.76837158203125e-7;  // 2^-21 of the farthest coordinate

// Equation (1b) of docs/contact.md, of a vertex in a triangle with this normal; `sides`: as of measure. Edges wait for
// that.
fn without_direction(ids : vec4u, sides : u32, near : Closest, across : vec3f, place : vec3f) -> Measured {
  if (is_edge_pair(ids)) { return Measured(near.s, near.t, false, vec3f(0.0, 1.0, 0.0), 0.0, 0.0, place.y); }
  let size = length(across);
  let n = select(vec3f(0.0, 1.0, 0.0), across / size, size > 0.0) * select(-1.0, 1.0, (sides & kComesOnFront) != 0u);
  return Measured(near.s, near.t, size > 0.0, n, 0.0, 0.0, dot(n, place));
}

// Of a vertex and a ball, or a capsule.
fn measure_round(ids : vec4u, place : vec3f, first : vec4f) -> Measured {
  let axis = select(vec3f(0.0), start_of(ids.z).xyz - first.xyz, is_collider(ids.z));
  let t = place_on_segment(place, first.xyz, axis);
  let arm = place - first.xyz - t * axis;
  let distance = length(arm);
  let n = select(vec3f(0.0, 1.0, 0.0), arm / distance, distance > 0.0);
  return Measured(0.0, t, true, n, distance - first.w, first.w, dot(n, place));
}

fn distance_to_segment(p : vec3f, a : vec3f, b : vec3f) -> f32 {
  return length(p - a - place_on_segment(p, a, b - a) * (b - a));
}

// By how much a round obstacle may come nearer to the inside of a triangle or an edge of cloth than to its ends, `more`
// farther from it. Ends that lie on it have pairs of their own, which bear; where it is small beside cloth, the inside
// bears.
const kMostSpare = 0.5;  // of the thickness: where the ends are farther by more, less, and by twice that nothing
fn spare_of(more : f32) -> f32 {
  return min(more, max(0.0, 2.0 * kMostSpare * step.contact.thickness - more));
}

// Of a pair that is no crossing. `sides`: kOfOneSystem, kComesOnFront.
fn measure(ids : vec4u, sides : u32) -> Measured {
  let p0 = start_of(ids.x);
  let p1 = start_of(ids.y);
  if (is_shape_pair(ids)) {
    if (p1.w > 0.0) { return measure_round(ids, p0.xyz, p1); }
    let n = points[(ids.y & kIdBits) + 1u].xyz;
    return Measured(0.0, 0.0, true, n, dot(n, p0.xyz - p1.xyz), 0.0, dot(n, p0.xyz));
  }
  let p2 = start_of(ids.z);
  let p3 = start_of(ids.w).xyz;
  let edges = is_edge_pair(ids);
  let near = closest_of_pair(edges, p0.xyz, p1.xyz, p2.xyz, p3);
  let radius = select(0.0, max(select(p0.w, p2.w, edges), 0.0), is_collider(select(ids.x, ids.z, edges)));
  let apart = length(near.apart);
  let most = max(max(abs(p0.xyz), abs(p1.xyz)), max(abs(p2.xyz), abs(p3)));
  let farthest = max(most.x, max(most.y, most.z));
  if (radius == 0.0 && apart <= kNoDistance * farthest) {
    return without_direction(ids, sides, near, cross(p2.xyz - p1.xyz, p3 - p1.xyz), p0.xyz);
  }
  let n = select(vec3f(0.0, 1.0, 0.0), near.apart / apart, apart > 0.0);
  var place_a = dot(n, p0.xyz);
  if (edges) { place_a = dot(n, p0.xyz + near.s * (p1.xyz - p0.xyz)); }
  if (radius == 0.0) { return Measured(near.s, near.t, near.inside, n, apart, radius, place_a); }
  var largest = 0.0;  // of the weights of cloth: 1 at an end
  var ends = 0.0;     // from the axis to the nearest of them, m
  if (edges) {
    largest = max(near.s, 1.0 - near.s);
    ends = min(distance_to_segment(p0.xyz, p2.xyz, p3), distance_to_segment(p1.xyz, p2.xyz, p3));
  } else {
    largest = max(max(near.s, near.t), 1.0 - near.s - near.t);
    ends = min(min(distance(p1.xyz, p0.xyz), distance(p2.xyz, p0.xyz)), distance(p3, p0.xyz));
  }
  let spare = spare_of(max(0.0, ends - apart));
  return Measured(near.s, near.t, largest < 1.0, n, apart - radius + spare, radius, place_a);
}

// A collider's friction is stored with its points at the end of the substep; negative: it has none of its own.
fn own_friction(id : u32) -> f32 {
  if (!is_collider(id)) { return -1.0; }
  return end_of(id).w;
}
// Of a pair with a collider: the collider's friction, or the cloth's if it has none.
fn friction_of(ids : vec4u, of_cloth : f32) -> f32 {
  let own = max(max(own_friction(ids.x), own_friction(ids.z)), own_friction(ids.y));
  return select(of_cloth, own, own >= 0.0);
}
