// Brings each vertex's entries into an order that hangs on nothing but the pairs' features, so that its sums are always the same, and
// tells the pairs where their entries stand. One invocation per vertex. Short lists by insertion, long ones by a heap.
#include "shared/index.wgsl"
#include "shared/contact.wgsl"
#include "shared/statistics.wgsl"
//                                                                                    elements
@group(0) @binding(0) var<storage, read>       statistics      : array<u32>;
@group(0) @binding(1) var<storage, read_write> contacts        : array<Contact>;
@group(0) @binding(2) var<storage, read_write> vertex_contacts : array<u32>;
@group(0) @binding(3) var<storage, read_write> entries         : array<vec2u>;
const kShort = 24u;

// By key; where two pairs have the same key, which is rare, by their ids.
fn comes_before(a : vec2u, b : vec2u) -> bool {
  if (a.x != b.x) { return a.x < b.x; }
  let p = contacts[a.y / 16u].ids;
  let q = contacts[b.y / 16u].ids;
  if (p.x != q.x) { return p.x < q.x; }
  if (p.y != q.y) { return p.y < q.y; }
  if (p.z != q.z) { return p.z < q.z; }
  return p.w < q.w;
}

fn insert_all(begin : u32, end : u32) {
  for (var i = begin + 1u; i < end; i++) {
    let entry = entries[i];
    var k = i;
    while (k > begin && comes_before(entry, entries[k - 1u])) {
      entries[k] = entries[k - 1u];
      k--;
    }
    entries[k] = entry;
  }
}

fn sink(begin : u32, root : u32, count : u32) {
  let entry = entries[begin + root];
  var hole = root;
  while (2u * hole + 1u < count) {
    var child = 2u * hole + 1u;
    if (child + 1u < count && comes_before(entries[begin + child], entries[begin + child + 1u])) { child++; }
    if (!comes_before(entry, entries[begin + child])) { break; }
    entries[begin + hole] = entries[begin + child];
    hole = child;
  }
  entries[begin + hole] = entry;
}

fn heap_sort(begin : u32, count : u32) {
  for (var root = count / 2u; root > 0u; root--) { sink(begin, root - 1u, count); }
  for (var last = count - 1u; last > 0u; last--) {
    let entry = entries[begin];
    entries[begin] = entries[begin + last];
    entries[begin + last] = entry;
    sink(begin, 0u, last);
  }
}

@compute @workgroup_size(kWorkgroupSize)
fn sort_entries(@builtin(global_invocation_id) id : vec3u) {
  let word = kVertexWords * flat_index(id);
  if (word >= arrayLength(&vertex_contacts) || statistics[kStatDue] == 0u) { return; }
  vertex_contacts[word + kCursorWord] = 0u;
  let count = vertex_contacts[word + 1u];
  if (count == 0u) { return; }
  let begin = vertex_contacts[word];
  if (count <= kShort) { insert_all(begin, begin + count); } else { heap_sort(begin, count); }
  for (var slot = begin; slot < begin + count; slot++) {
    let entry = entries[slot].y;
    contacts[entry / 16u].slots[entry & 3u] = slot;
  }
}
