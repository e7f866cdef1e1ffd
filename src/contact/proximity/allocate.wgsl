// Allocates room in a list for the invocations of a workgroup. The place depends on the order of invocations.
// All invocations of the workgroup call it, and no other part of it writes to these.
var<workgroup> asked : atomic<u32>;
var<workgroup> base : u32;

// The first of `own` places for this invocation; `statistic` counts all requests. The includer declares `statistics`.
fn allocate(thread : u32, own : u32, statistic : u32) -> u32 {
  if (thread == 0u) { atomicStore(&asked, 0u); }
  workgroupBarrier();
  var place = 0u;
  if (own > 0u) { place = atomicAdd(&asked, own); }
  workgroupBarrier();
  if (thread == 0u && atomicLoad(&asked) > 0u) { base = atomicAdd(&statistics[statistic], atomicLoad(&asked)); }
  workgroupBarrier();
  return base + place;
}
