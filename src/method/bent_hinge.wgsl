// A hinge where the ways so far have taken its corners. The including kernel binds `position_in`.
#include "element/hinge/law.wgsl"

struct BentHinge {
  slope : HingeSlope,
  angle : f32,   // rad
  turned : f32,  // by the ways, by this slope, rad
}

// Ways are short: their differences keep digits that those of places have lost.
fn bent_hinge(nodes : vec4u, a : vec3f, b : vec3f, c : vec3f, d : vec3f) -> BentHinge {
  let x = position_in[nodes.x].xyz;
  let wing = wing_of(vec3f(0.0), (position_in[nodes.y].xyz - x) + (b - a), (position_in[nodes.z].xyz - x) + (c - a),
                     (position_in[nodes.w].xyz - x) + (d - a));
  let slope = hinge_slope(wing);
  return BentHinge(slope, hinge_angle(wing), hinge_change(slope, a, b, c, d));
}

// A difference of two angles: what is folded flat goes on beyond pi.
fn short_way(difference : f32) -> f32 {
  if (difference > 3.14159265359) { return difference - 6.28318530718; }
  if (difference < -3.14159265359) { return difference + 6.28318530718; }
  return difference;
}
