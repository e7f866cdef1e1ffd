// How many pairs act on each vertex in the last substep, for a picture. One invocation per vertex.
#include "gpu/index.wgsl"
#include "state/contact.wgsl"
#include "contact/proximity/links.wgsl"
//                                                                               elements
@group(0) @binding(0) var<storage, read>       contacts        : array<Contact>;
@group(0) @binding(1) var<storage, read>       vertex_contacts : array<u32>;    // kVertexWords * vertex_count
@group(0) @binding(2) var<storage, read_write> counts          : array<f32>;    // vertex_count

@compute @workgroup_size(kWorkgroupSize)
fn count_contacts(@builtin(global_invocation_id) id : vec3u) {
  let vertex = flat_index(id);
  if (vertex >= arrayLength(&counts)) { return; }
  var count = 0.0;
  for (var link = vertex_contacts[kVertexWords * vertex + kLinkWord]; link != 0u; link = next_of(link)) {
    let contact = contacts[record_of(link)];
    let weight = weights_of(contact.ids, contact.place.x, contact.place.y)[role_of(link)];
    if (contact.urgency != 0.0 && weight != 0.0) { count += 1.0; }
  }
  counts[vertex] = count;
}
