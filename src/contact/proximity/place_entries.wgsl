// Allocates room for each vertex's entries. One invocation per vertex. The order of the rooms depends on scheduling; no
// result depends on it.
#include "gpu/index.wgsl"
#include "state/contact.wgsl"
#include "state/statistics.wgsl"
#include "contact/proximity/allocate.wgsl"
//                                                                                    elements
@group(0) @binding(0) var<storage, read_write> vertex_contacts : array<u32>;
@group(0) @binding(1) var<storage, read_write> statistics      : array<atomic<u32>>;
var<workgroup> due : u32;

@compute @workgroup_size(kWorkgroupSize)
fn place_entries(@builtin(global_invocation_id) id : vec3u, @builtin(local_invocation_index) thread : u32) {
  if (thread == 0u) { due = atomicLoad(&statistics[kStatDue]); }
  if (workgroupUniformLoad(&due) == 0u) { return; }
  let word = kVertexWords * flat_index(id);
  var own = 0u;
  if (word < arrayLength(&vertex_contacts)) {
    if (atomicLoad(&statistics[kStatRolledBack]) == 0u) {
      own = vertex_contacts[word + 1u];
    } else {
      vertex_contacts[word + 1u] = 0u;
    }
  }
  let first = allocate(thread, own, kStatEntries);
  if (own > 0u) { vertex_contacts[word] = first; }
}
