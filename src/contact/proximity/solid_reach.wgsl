// How far the side of a pair comes that contact cannot move. The including kernel has the places where vertices of
// cloth end, end_of_way(vertex), and binds as measure.wgsl asks. Source: docs/contact.md, equation (6).
#include "contact/proximity/measure.wgsl"

// Where a feature's corner is at the end of the substep, m.
fn end_in_substep(ids : vec4u, id : u32) -> vec3f {
  if (is_collider(id)) { return end_in_pair(ids, id); }
  return end_of_way(id & kIdBits);
}

// How far along n a solid side will be at the end of the substep, in the direction of the other.
fn reach_of(ids : vec4u, first : u32, end : u32, sign : f32, n : vec3f, radius : f32) -> f32 {
  var reach = -3e38;
  for (var role = first; role < end; role++) {
    reach = max(reach, sign * dot(n, end_in_substep(ids, ids[role])));
  }
  return sign * (reach + radius);
}
