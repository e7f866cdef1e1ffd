// Enters every pair in the list of each of its cloth vertices, and gives it the force that it had before the search.
// Grid-stride loop over the pairs. The order depends on scheduling; no result depends on it, since sums over a list are
// of integers.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "state/contact.wgsl"
#include "state/statistics.wgsl"
#include "contact/proximity/kept_forces.wgsl"
//                                                                                    elements
@group(0) @binding(0) var<uniform>             step            : StepBlock;
@group(0) @binding(1) var<storage, read>       statistics      : array<u32>;
@group(0) @binding(2) var<storage, read_write> contacts        : array<Contact>;
@group(0) @binding(3) var<storage, read_write> vertex_contacts : array<atomic<u32>>;
@group(0) @binding(4) var<storage, read_write> entries         : array<u32>;  // see state/contact.wgsl
@group(0) @binding(5) var<storage, read>       kept            : array<u32>;  // kept_forces.wgsl
@group(0) @binding(6) var<storage, read>       kept_places     : array<u32>;

// Of the pair in the substep before the search, N; 0 if it did not act.
fn kept_force(ids : vec4u, list : u32) -> vec3f {
  let last = arrayLength(&kept_places) - 1u;
  var place = hash_of(ids) & last;
  loop {
    let number = kept_places[place];
    if (number == 0u) { break; }
    let word = kept_word(list, number - 1u);
    if (all(ids == vec4u(kept[word], kept[word + 1u], kept[word + 2u], kept[word + 3u]))) {
      return bitcast<vec3f>(vec3u(kept[word + 4u], kept[word + 5u], kept[word + 6u]));
    }
    place = (place + 1u) & last;
  }
  return vec3f(0.0);
}

@compute @workgroup_size(kWorkgroupSize)
fn list_entries(@builtin(global_invocation_id) id : vec3u, @builtin(num_workgroups) groups : vec3u) {
  if (statistics[kStatDue] == 0u || statistics[kStatRolledBack] != 0u) { return; }
  let count = statistics[kStatPairs];
  let list = select(1u, 0u, step.contact.detect == kDetectAlways);
  for (var pair = id.x; pair < count; pair += groups.x * kWorkgroupSize) {
    let ids = contacts[pair].ids;
    contacts[pair].force = vec4f(kept_force(ids, list), 0.0);
    for (var role = 0u; role < role_count(ids); role++) {
      if (is_collider(ids[role])) { continue; }
      let word = kVertexWords * (ids[role] & kIdBits);
      let cursor = atomicAdd(&vertex_contacts[word + kCursorWord], 1u) & kCursorBits;
      let slot = atomicLoad(&vertex_contacts[word]) + cursor;
      entries[slot] = kEntryPair * pair + role;
      contacts[pair].slots[role] = slot;
    }
  }
}
