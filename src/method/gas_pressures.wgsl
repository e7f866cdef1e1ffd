// The volume and the pressure of each gas. One workgroup a gas; sums run in an order that no workgroup size changes.
// Source: docs/pressure.md, equations 1 and 2.
#include "gpu/index.wgsl"
#include "method/gas.wgsl"
//                                                                            elements        unit
@group(0) @binding(0) var<storage, read>       volumes : array<f32>;       // of each chunk   m³
@group(0) @binding(1) var<storage, read_write> gases   : array<Gas>;
const kLanes = 256u;
var<workgroup> lanes : array<f32, kLanes>;

@compute @workgroup_size(kWorkgroupSize)
fn gas_pressures(@builtin(workgroup_id) group : vec3u, @builtin(local_invocation_index) local : u32) {
  let number = flat_group(group);
  if (number >= arrayLength(&gases)) { return; }
  let gas = gases[number];
  for (var lane = local; lane < kLanes; lane += kWorkgroupSize) {
    var sum = 0.0;
    for (var k = lane; k < gas.chunk_count; k += kLanes) { sum += volumes[gas.first_chunk + k]; }
    lanes[lane] = sum;
  }
  workgroupBarrier();
  for (var half = kLanes / 2u; half > 0u; half /= 2u) {
    for (var lane = local; lane < half; lane += kWorkgroupSize) { lanes[lane] += lanes[lane + half]; }
    workgroupBarrier();
  }
  if (local != 0u) { return; }
  gases[number].volume = lanes[0];
  gases[number].gauge = gauge_of(gas, lanes[0]);
}
