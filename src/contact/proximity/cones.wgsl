// Whether the direction of a pair lies in the Voronoi cones of its features: else a neighbour of one of them is nearer,
// and has its own pair. The including kernel binds `rings` and includes measure.wgsl. Source: docs/contact.md.
#include "contact/proximity/measure.wgsl"

const kConeSlack = 1e-3;   // a cosine: the rounding of a direction, so that an edge of a flat floor has its normal
const kOnBorder = 1e-6;    // a weight this small is none: s + t of an edge's point is 1 but for rounding

// In `rings`, where the words of a vertex's ring begin; those of the next vertex follow.
fn ring_of(id : u32) -> u32 {
  return select(id, step.nodes.count + (id & kIdBits), is_collider(id));
}

// Whether a way of length 1 does not lead on along `inward`.
fn leads_off(way : vec3f, inward : vec3f) -> bool {
  return dot(way, inward) <= kConeSlack * length(inward);
}

// Whether a vertex is one of those of the other side, or beside one. Folded cloth is nearest to itself in its fold: on
// the way there from its sides, no place would have a pair.
const kNoneMet = vec3u(0xffffffffu);
fn is_beside(id : u32, met : vec3u) -> bool {
  if (all(met == kNoneMet)) { return false; }
  var found = any(met == vec3u(id));
  let end = rings[ring_of(id) + 1u];
  for (var at = rings[ring_of(id)]; !found && at < end; at++) { found = any(met == vec3u(rings[at])); }
  return found;
}

// Of a vertex: no edge at it is nearer elsewhere, but those to what is beside the other side, `met`. One without
// triangles has all directions.
fn in_cone_of_vertex(id : u32, way : vec3f, met : vec3u) -> bool {
  let place = start_of(id).xyz;
  let end = rings[ring_of(id) + 1u];
  var inside = true;
  for (var at = rings[ring_of(id)]; inside && at < end; at++) {
    inside = leads_off(way, start_of(rings[at]).xyz - place) || is_beside(rings[at], met);
  }
  return inside;
}

// Of an edge: no triangle at it is nearer elsewhere, of however many there are, but those to what is beside the other
// side.
fn in_cone_of_edge(a : u32, b : u32, way : vec3f, met : vec3u) -> bool {
  let place = start_of(a).xyz;
  let along = start_of(b).xyz - place;
  let size = dot(along, along);
  let end = rings[ring_of(a) + 1u];
  var inside = true;
  for (var at = rings[ring_of(a)]; inside && at < end; at += 2u) {
    let next = rings[at];
    let last = rings[at + 1u];
    if (next != b && last != b) { continue; }
    let corner = select(next, last, next == b);
    let opposite = start_of(corner).xyz - place;
    let part = select(0.0, dot(opposite, along) / size, size > 0.0);
    inside = leads_off(way, opposite - part * along) || is_beside(corner, met);
  }
  return inside;
}

// Of a triangle where the closest point has the weights s and t: its inside has only its normal.
fn in_cone_of_triangle(ids : vec4u, s : f32, t : f32, way : vec3f, met : vec3u) -> bool {
  let r = 1.0 - s - t;
  if (min(min(s, t), r) > kOnBorder) { return true; }
  if (max(max(s, t), r) >= 1.0 - kOnBorder) {
    return in_cone_of_vertex(select(select(ids.y, ids.w, t > 0.5), ids.z, s > 0.5), way, met);
  }
  return in_cone_of_edge(select(ids.y, ids.z, r <= kOnBorder), select(ids.w, ids.z, t <= kOnBorder), way, met);
}

// A vertex of cloth has no cone before an obstacle and before the inside of a triangle: it keeps the distance that it
// has. What has a radius has none.
fn lies_in_cones(ids : vec4u, measured : Measured) -> bool {
  if (is_shape_pair(ids) || measured.radius > 0.0 || measured.gap <= 0.0) { return true; }
  let n = measured.normal;
  let is_self = is_self_pair(ids);
  if (is_edge_pair(ids)) {
    let a = ids.x & ~kPairFlag;
    return in_cone_of_edge(a, ids.y, -n, select(kNoneMet, ids.zww, is_self)) &&
           in_cone_of_edge(ids.z, ids.w, n, select(kNoneMet, vec3u(a, ids.yy), is_self));
  }
  let inside = min(min(measured.s, measured.t), 1.0 - measured.s - measured.t) > kOnBorder;
  let has_cone = is_collider(ids.x) || (!inside && !is_collider(ids.y));
  if (has_cone && !in_cone_of_vertex(ids.x, -n, select(kNoneMet, ids.yzw, is_self))) { return false; }
  return in_cone_of_triangle(ids, measured.s, measured.t, n, select(kNoneMet, ids.xxx, is_self));
}
