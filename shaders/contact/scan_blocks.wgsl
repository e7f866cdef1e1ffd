// Within each block of kScanBlock numbers: how much comes before each number. One workgroup a block.
#include "contact/scan_params.wgsl"
#include "shared/contact.wgsl"
#include "shared/statistics.wgsl"
//                                                                             elements
@group(0) @binding(0) var<uniform>             params     : ScanParams;
@group(0) @binding(1) var<storage, read>       statistics : array<u32>;
@group(0) @binding(2) var<storage, read_write> words      : array<u32>;
const kThreads = 256u;
const kEach = 4u;  // kScanBlock / kThreads
var<workgroup> sums : array<u32, kThreads>;

@compute @workgroup_size(kThreads)
fn scan_blocks(@builtin(workgroup_id) group : vec3u, @builtin(local_invocation_index) local : u32) {
  let due = statistics[kStatDue] != 0u;
  let first = group.x * kScanBlock + kEach * local;
  var own : array<u32, kEach>;
  var sum = 0u;
  for (var k = 0u; k < kEach; k++) {
    own[k] = 0u;
    if (due && first + k < params.count) { own[k] = words[params.source + params.stride * (first + k)]; }
    sum += own[k];
  }
  sums[local] = sum;
  workgroupBarrier();
  for (var reach = 1u; reach < kThreads; reach *= 2u) {
    var other = 0u;
    if (local >= reach) { other = sums[local - reach]; }
    workgroupBarrier();
    sums[local] += other;
    workgroupBarrier();
  }
  if (!due) { return; }
  var before = sums[local] - sum;
  for (var k = 0u; k < kEach; k++) {
    if (first + k < params.count) { words[params.sums + params.stride * (first + k)] = before; }
    before += own[k];
  }
  if (local == kThreads - 1u) { words[params.first_block + group.x] = sums[local]; }
}
