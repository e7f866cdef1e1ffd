// The relative velocity of the two features of a listed pair. The including kernel has the velocities of cloth,
// velocity_of(vertex), and binds as measure.wgsl asks. Source: docs/contact.md.
#include "contact/proximity/measure.wgsl"

struct Relative {
  velocity : vec3f,  // the cloth's part of u, m/s
  surface : vec3f,   // the collider's part, m/s
}

fn relative_velocity(ids : vec4u, w : vec4f, measured : Measured) -> Relative {
  var r = Relative(vec3f(0.0), vec3f(0.0));
  for (var role = 0u; role < role_count(ids); role++) {
    let id = ids[role];
    if (is_collider(id)) {
      r.surface += w[role] * ((end_in_pair(ids, id) - start_of(id).xyz) / step.time.dt);
    } else {
      r.velocity += w[role] * velocity_of(id & kIdBits);
    }
  }
  if (measured.radius > 0.0) {  // the surface of a ball that turns: its spin is the point after its centre
    let on_a = is_collider(ids.x);
    let id = collider_of(ids) & kIdBits;
    let arm = select(measured.radius, -measured.radius, on_a) * measured.normal;
    r.surface += select(-1.0, 1.0, on_a) * cross(points[id + 1u].xyz, arm);
  }
  return r;
}
