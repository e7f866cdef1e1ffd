// The moment at a hinge. The including kernel binds `couplings`, rows of hinges and their entries, and `bends`.
// Source: docs/elements.md, Bending.
fn moment_of(hinge : u32) -> f32 {
  let row = couplings[hinge];  // the first entry, and the one behind the last
  var moment = 0.0;
  for (var entry = row.x; entry < row.y; entry++) {
    let coupling = couplings[entry];  // a bend, and N·m as the bits of f32
    moment += bitcast<f32>(coupling.y) * bends[coupling.x];
  }
  return moment;
}
