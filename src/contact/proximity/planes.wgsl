// The plane between the two sides of a listed pair, which neither may pass in a substep: docs/contact.md, equation (6).
// The including kernel binds step.
#include "state/contact.wgsl"
const kContactMargin = 0.05;   // of the distance: how near to the plane between two features a vertex may come
const kContactFloor = 0.1;     // of the thickness, the same; nearer, f32 loses the plane along a whole edge

// How near either side of cloth may come to the plane half way between them, m.
fn margin_of(gap : f32, thickness : f32) -> f32 {
  return max(kContactMargin * gap, 0.5 * kContactFloor * thickness);
}
// How far apart along the normal they have to end, m: where they are nearer already, no nearer.
fn least_apart(gap : f32, thickness : f32) -> f32 { return min(2.0 * margin_of(gap, thickness), gap); }

// How far beyond the plane that it must stay behind a place lies, m; negative: it is on its own side.
fn beyond(contact : Contact, role : u32, place : vec3f) -> f32 {
  let on_a = role < roles_of_a(contact.ids);
  let side = select(-1.0, 1.0, on_a);
  let gap = contact.normal.w;
  var plane = contact.place.z - 0.5 * gap + side * margin_of(gap, contact.thickness);
  if (contact.solid != 0u) {
    let thickness = contact.thickness;
    plane = contact.place.w + side * max(kContactMargin * min(gap, thickness), kContactFloor * thickness);
  }
  return side * (plane - dot(contact.normal.xyz, place));
}

// A vertex that moves no further than this in a substep passes no obstacle that is not near.
fn free_way() -> f32 { return 0.45 * step.contact.thickness; }
