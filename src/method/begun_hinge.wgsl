// The moment at a hinge as a sweep began, by all bends that have a part in it, and what it resists further bending with
// by itself, without what creases take off. The including kernel binds `fabric`, `couplings`, rows of hinges and their
// entries, and `bends` (bend_hinges.wgsl, yield_creases.wgsl).
// Source: docs/solvers/xpbd.md, equations 10 and 11.
struct BegunHinge {
  moment : f32,      // N·m
  resistance : f32,  // N·m
}
fn begun_hinge(hinge : u32) -> BegunHinge {
  let row = couplings[hinge];  // the first entry, and the one behind the last
  var begun = BegunHinge(0.0, 0.0);
  for (var entry = row.x; entry < row.y; entry++) {
    let coupling = couplings[entry];  // a bend, and N·m as the bits of f32
    let other = bends[coupling.x];
    begun.moment += bitcast<f32>(coupling.y) * (other.x + other.y);
    begun.resistance += select(0.0, abs(bitcast<f32>(coupling.y)), coupling.x < fabric.hinges);
  }
  return begun;
}
