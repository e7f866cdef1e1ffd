// Allocates room in a list for the invocations of a workgroup. The place depends on the order of workgroups.
// All invocations of the workgroup call it, and no other part of it writes to these.
var<workgroup> sums : array<u32, kWorkgroupSize>;
var<workgroup> base : u32;

// The first of `own` places for this invocation; `statistic` counts all requests. The includer declares `statistics`.
fn allocate(thread : u32, own : u32, statistic : u32) -> u32 {
  sums[thread] = own;
  workgroupBarrier();
  for (var distance = 1u; distance < kWorkgroupSize; distance *= 2u) {
    var other = 0u;
    if (thread >= distance) { other = sums[thread - distance]; }
    workgroupBarrier();
    sums[thread] += other;
    workgroupBarrier();
  }
  if (thread == kWorkgroupSize - 1u && sums[thread] > 0u) { base = atomicAdd(&statistics[statistic], sums[thread]); }
  workgroupBarrier();
  let first = base + sums[thread] - own;
  workgroupBarrier();
  return first;
}
