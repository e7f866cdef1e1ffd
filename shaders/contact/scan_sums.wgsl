// Where each block of a scan begins, and the total. One workgroup. Where the numbers count pairs it also decides whether the
// lists are long enough; if not, nothing is listed and the frame is held (docs/contact.md, "When a list is too short").
#include "contact/scan_params.wgsl"
#include "shared/contact.wgsl"
#include "shared/statistics.wgsl"
//                                                                             elements
@group(0) @binding(0) var<uniform>             params     : ScanParams;
@group(0) @binding(1) var<storage, read_write> statistics : array<u32>;
@group(0) @binding(2) var<storage, read_write> words      : array<u32>;
const kThreads = 256u;
var<workgroup> sums : array<u32, kThreads>;

@compute @workgroup_size(kThreads)
fn scan_sums(@builtin(local_invocation_index) local : u32) {
  let due = statistics[kStatDue] != 0u;
  let blocks = (params.count + kScanBlock - 1u) / kScanBlock;
  var total = 0u;
  for (var first = 0u; first < blocks; first += kThreads) {
    let block = first + local;
    var own = 0u;
    if (due && block < blocks) { own = words[params.first_block + block]; }
    sums[local] = own;
    workgroupBarrier();
    for (var reach = 1u; reach < kThreads; reach *= 2u) {
      var other = 0u;
      if (local >= reach) { other = sums[local - reach]; }
      workgroupBarrier();
      sums[local] += other;
      workgroupBarrier();
    }
    if (due && block < blocks) { words[params.first_block + block] = total + sums[local] - own; }
    total += sums[kThreads - 1u];
    workgroupBarrier();
  }
  if (!due || local != 0u) { return; }
  words[params.first_block + blocks] = total;
  if (params.capacity == 0u) { return; }
  statistics[kStatDetect] = 0u;
  statistics[kStatDetections] += 1u;
  statistics[kStatCrossings] = max(statistics[kStatCrossings], statistics[kStatFound]);
  if (total > params.capacity) {
    statistics[kStatContactOverflow] = max(statistics[kStatContactOverflow], total);
    statistics[kStatHeld] = 1u;
    total = 0u;
  }
  statistics[kStatPairs] = total;
}
