// A membrane where the ways so far have taken its corners. The including kernel binds `corners`, `slopes`,
// `position_in` and `way`, and includes the membranes' law.

struct MovedMembrane {
  slopes : vec4f,  // 1/m
  start : Axes,    // F as the substep begins
  f : Axes,
}

// Ways are short: their differences keep digits that those of places have lost.
fn moved_membrane(triangle : u32) -> MovedMembrane {
  let a = corners[3u * triangle];
  let b = corners[3u * triangle + 1u];
  let c = corners[3u * triangle + 2u];
  let origin = position_in[a].xyz;
  let slope = slopes[triangle];
  let start = deformation(slope, position_in[b].xyz - origin, position_in[c].xyz - origin);
  let change = deformation(slope, way[b].xyz - way[a].xyz, way[c].xyz - way[a].xyz);
  return MovedMembrane(slope, start, Axes(start.warp + change.warp, start.weft + change.weft));
}
