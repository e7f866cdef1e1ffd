// Brings each vertex's entries into the order of their pairs, so that its sums have one order, and tells the pairs where
// they stand. One invocation per vertex. Short lists by insertion, long ones by a heap.
#include "shared/index.wgsl"
#include "shared/contact.wgsl"
#include "shared/statistics.wgsl"
struct EntryParams {  // mirror: src/collision/contact_lists.hpp
  vertex_count : u32,
}
//                                                                                    elements
@group(0) @binding(0) var<uniform>             params          : EntryParams;
@group(0) @binding(1) var<storage, read>       statistics      : array<u32>;
@group(0) @binding(2) var<storage, read_write> contacts        : array<Contact>;
@group(0) @binding(3) var<storage, read_write> vertex_contacts : array<u32>;
@group(0) @binding(4) var<storage, read_write> entries         : array<u32>;
const kShort = 24u;

fn entries_begin(vertex : u32) -> u32 {
  let blocks = kVertexWords * params.vertex_count;
  if (vertex == params.vertex_count) { return vertex_contacts[blocks + (vertex + kScanBlock - 1u) / kScanBlock]; }
  return vertex_contacts[kVertexWords * vertex] + vertex_contacts[blocks + vertex / kScanBlock];
}

fn insert_all(begin : u32, end : u32) {
  for (var i = begin + 1u; i < end; i++) {
    let entry = entries[i];
    var k = i;
    while (k > begin && entries[k - 1u] > entry) {
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
    if (child + 1u < count && entries[begin + child + 1u] > entries[begin + child]) { child++; }
    if (entries[begin + child] <= entry) { break; }
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
  let vertex = flat_index(id);
  if (vertex >= params.vertex_count || statistics[kStatDue] == 0u) { return; }
  if (statistics[kStatPairs] == 0u) {  // nothing was listed, be it that the list was too short
    vertex_contacts[kVertexWords * vertex + 1u] = 0u;
    return;
  }
  let begin = entries_begin(vertex);
  let end = entries_begin(vertex + 1u);
  vertex_contacts[kVertexWords * vertex + 1u] = end - begin;
  if (end - begin <= kShort) { insert_all(begin, end); } else { heap_sort(begin, end - begin); }
  for (var slot = begin; slot < end; slot++) { contacts[entries[slot] / 16u].slots[entries[slot] & 3u] = slot; }
}
