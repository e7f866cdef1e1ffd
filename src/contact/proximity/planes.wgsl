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

// How far side A is beyond side B, by where each vertex is along a direction from B to A, m.
fn sides_apart(ids : vec4u, along : vec4f) -> f32 {
  if (is_edge_pair(ids)) { return min(along.x, along.y) - max(along.z, along.w); }
  return along.x - max(max(along.y, along.z), along.w);
}

// How far beyond the plane before a solid side, which it must stay behind, a place lies, m; negative: it is on its own
// side.
fn beyond(contact : Contact, role : u32, place : vec3f) -> f32 {
  let side = select(-1.0, 1.0, role < roles_of_a(contact.ids));
  return beyond_solid(side, dot(contact.normal.xyz, place), contact.place.w, contact.normal.w, contact.thickness);
}
// How near to a solid side cloth may come, m.
fn margin_before_solid(gap : f32, thickness : f32) -> f32 {
  return max(kContactMargin * min(gap, thickness), kContactFloor * thickness);
}
// side: of the place, 1 A, -1 B; along: of the place on the normal; reach: of the solid side at the end; m.
fn beyond_solid(side : f32, along : f32, reach : f32, gap : f32, thickness : f32) -> f32 {
  return side * (reach + side * margin_before_solid(gap, thickness) - along);
}
// The same of the plane half way between two sides of cloth. middle: where that is on the normal, m.
fn beyond_half(side : f32, along : f32, middle : f32, gap : f32, thickness : f32) -> f32 {
  return side * (middle + side * margin_of(gap, thickness) - along);
}

// How much of a way takes a vertex past no plane, by how far it is beyond it at the start and would be at the end.
fn part_before(now : f32, then : f32) -> f32 {
  if (then <= 0.0) { return 1.0; }
  if (now < 0.0) { return now / (now - then); }
  return select(1.0, 0.0, then > now);
}

// A vertex that moves no farther than this in a substep passes no obstacle that has no record: those are farther away.
const kFreeWay = 0.45;  // of the thickness
fn free_way() -> f32 { return kFreeWay * step.contact.thickness; }
