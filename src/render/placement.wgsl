// Where the obstacles that move are. The includer declares `placement`: for each of them the three rows of a rigid
// transform, with the translation in w, m. In w its vertices have its number.
override kMoves : u32 = 0u;  // 0: nothing of what is drawn moves, and no row is read

fn placed(position : vec4f) -> vec3f {
  if (kMoves == 0u) { return position.xyz; }
  let row = 3u * u32(position.w);
  let p = vec4f(position.xyz, 1.0);
  return vec3f(dot(placement[row], p), dot(placement[row + 1u], p), dot(placement[row + 2u], p));
}
fn turned(normal : vec3f, position : vec4f) -> vec3f {
  if (kMoves == 0u) { return normal; }
  let row = 3u * u32(position.w);
  return vec3f(dot(placement[row].xyz, normal), dot(placement[row + 1u].xyz, normal),
               dot(placement[row + 2u].xyz, normal));
}
