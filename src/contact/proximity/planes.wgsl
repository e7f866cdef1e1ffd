// The plane between the two sides of a listed pair, which neither may pass in a substep: docs/contact.md, equation (6).
const kContactMargin = 0.05;   // of the distance: how near to the plane between two features a vertex may come
const kContactFloor = 0.1;     // of the thickness, the same; nearer, f32 loses the plane along a whole edge

fn thickness_of(ids : vec4u) -> f32 {
  return select(step.contact.thickness, step.contact.self_thickness, is_self_pair(ids));
}

// How far beyond the plane that it must stay behind a place lies, m; negative: it is on its own side.
fn beyond(contact : Contact, role : u32, place : vec3f) -> f32 {
  let on_a = role < roles_of_a(contact.ids);
  let side = select(-1.0, 1.0, on_a);
  let gap = contact.normal.w;
  let margin = max(kContactMargin * gap, 0.5 * kContactFloor * step.contact.self_thickness);
  var plane = contact.place.z - 0.5 * gap + side * margin;
  if (contact.solid != 0u) {
    let thickness = thickness_of(contact.ids);
    plane = contact.place.w + side * max(kContactMargin * min(gap, thickness), kContactFloor * thickness);
  }
  return side * (plane - dot(contact.normal.xyz, place));
}

// A vertex that moves no further than this in a substep passes nothing that is not near.
fn free_way() -> f32 {
  let self_thickness = step.contact.self_thickness;
  return 0.45 * select(step.contact.thickness, min(step.contact.thickness, self_thickness), self_thickness > 0.0);
}
