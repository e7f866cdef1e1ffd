// What the tetrahedra of a body pull a node by. The including kernel binds `gathers` and `pulls`.
fn pull_at(row : u32) -> vec3f {  // N
  var sum = vec3f(0.0);
  for (var at = gathers[row]; at < gathers[row + 1u]; at++) { sum += pulls[gathers[at]].xyz; }
  return sum;
}
