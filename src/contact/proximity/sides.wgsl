// What the sides of a listed pair are. The including kernel binds `previous`, and `vertex_contacts` as atomics.
#include "state/contact.wgsl"

// The side that contact cannot move: 1 A, 2 B, 0 neither.
fn solid_side(ids : vec4u) -> u32 {
  if (is_solid(ids, roles_of_a(ids), role_count(ids))) { return 2u; }
  return select(0u, 1u, is_solid(ids, 0u, roles_of_a(ids)));
}
// Whether roles from `first` to before `end` are a collider's or kinematic.
fn is_solid(ids : vec4u, first : u32, end : u32) -> bool {
  var solid = true;
  for (var role = first; role < end; role++) {
    solid = solid && (is_collider(ids[role]) || previous[ids[role] & kIdBits].w == 0.0);
  }
  return solid;
}

// Marks of the last search at the cloth vertices from role `first` to before `end`: kTangledCloth, kTangledMesh.
fn tangles_of(ids : vec4u, first : u32, end : u32) -> u32 {
  var marks = 0u;
  for (var role = first; role < end; role++) {
    if (!is_collider(ids[role])) {
      marks |= atomicLoad(&vertex_contacts[kVertexWords * (ids[role] & kIdBits) + kTangledWord]);
    }
  }
  return marks;
}

// Whether both features belong to a crossing, so that either may be on its wrong side.
fn is_tangled(ids : vec4u, is_self : bool) -> bool {
  if (is_shape_pair(ids)) { return false; }
  let of_a = tangles_of(ids, 0u, roles_of_a(ids));
  let of_b = tangles_of(ids, roles_of_a(ids), 4u);
  if (is_self) { return (of_a & of_b & kTangledCloth) != 0u; }
  return ((of_a | of_b) & kTangledMesh) != 0u;
}
