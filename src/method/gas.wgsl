// The gas in closed cloths. Source: docs/pressure.md, equations 1 and 2.
struct Gas {  // mirror: src/method/enclosed_gas.hpp
  first_vertex : u32,   // of its cloth
  first_chunk : u32,    // of its cloth's nodes
  chunk_count : u32,
  rest_volume : f32,    // m³
  rest_pressure : f32,  // Pa, absolute, at that volume; 0: the gauge pressure never changes
  rest_gauge : f32,     // Pa, above that outside
  volume : f32,         // m³: in this substep
  gauge : f32,          // Pa: in this substep
}
// So many nodes of one cloth, whose sum gas_volumes takes.
struct GasChunk {  // mirror: src/method/enclosed_gas.hpp
  gas : u32,
  first : u32,  // node
  count : u32,  // at most kGasChunk
}
const kGasChunk = 64u;       // mirror: src/method/enclosed_gas.hpp
const kLeastVolume = 0.01;   // mirror: src/element/gas/law.hpp; of that at rest, which any smaller volume counts as

// Of the change of volume: the difference of two pressures of some 100,000 Pa would have no digits left.
fn gauge_of(gas : Gas, volume : f32) -> f32 {
  let counts = max(volume, kLeastVolume * gas.rest_volume);
  if (gas.rest_pressure == 0.0) { return gas.rest_gauge; }
  return gas.rest_gauge + gas.rest_pressure * ((gas.rest_volume - counts) / counts);
}
