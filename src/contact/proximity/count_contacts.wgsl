// How many pairs act on each vertex in the last substep, for a picture. One invocation per vertex.
#include "gpu/index.wgsl"
#include "state/contact.wgsl"
//                                                                               elements
@group(0) @binding(0) var<storage, read>       contacts        : array<Contact>;
@group(0) @binding(1) var<storage, read>       entries         : array<u32>;
@group(0) @binding(2) var<storage, read>       vertex_contacts : array<u32>;    // kVertexWords * vertex_count
@group(0) @binding(3) var<storage, read_write> counts          : array<f32>;    // vertex_count

@compute @workgroup_size(kWorkgroupSize)
fn count_contacts(@builtin(global_invocation_id) id : vec3u) {
  let vertex = flat_index(id);
  if (vertex >= arrayLength(&counts)) { return; }
  let begin = vertex_contacts[kVertexWords * vertex];
  let end = begin + vertex_contacts[kVertexWords * vertex + 1u];
  var count = 0.0;
  for (var k = begin; k < end; k++) {
    if ((entries[k] & kEntryNear) == 0u) { continue; }
    let contact = contacts[entries[k] / kEntryPair];
    let weight = weights_of(contact.ids, contact.place.x, contact.place.y)[entries[k] & 3u];
    if (contact.urgency != 0.0 && weight != 0.0) { count += 1.0; }
  }
  counts[vertex] = count;
}
