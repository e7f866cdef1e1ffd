// How far the side of a pair comes that contact cannot move. The including kernel has the places where vertices of
// cloth end, end_of_way(vertex), and binds as measure.wgsl asks. Source: docs/contact.md, equation (6).
#include "contact/proximity/measure.wgsl"

// How far along n a solid side will be at the end of the substep, in the direction of the other.
fn reach_of(ids : vec4u, first : u32, end : u32, sign : f32, n : vec3f, radius : f32) -> f32 {
  var reach = -3e38;
  for (var role = first; role < end; role++) {
    let id = ids[role];
    var place : vec3f;
    if (is_collider(id)) {
      place = end_in_pair(ids, id);
    } else {
      place = end_of_way(id & kIdBits);
    }
    reach = max(reach, sign * dot(n, place));
  }
  return sign * (reach + radius);
}
