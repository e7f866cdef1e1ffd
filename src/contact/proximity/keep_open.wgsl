// Keeps open patches from folding, whose own pairs no search lists. In each round it marks the corners of triangles
// that would fold on their ways, in further ones only where a corner was not held back; in the first one it asks for a
// search where features may come near. As kEndWays it says, if anything is marked in the round, how far each vertex may
// go along the patch. Grid-stride loop over the quads of cells. Source: docs/contact.md, Patches.
#include "gpu/index.wgsl"
#include "state/contact.wgsl"
#include "state/statistics.wgsl"
#include "contact/proximity/cell_quads.wgsl"
#include "contact/proximity/slow.wgsl"
//                                                                             elements
@group(0) @binding(0) var<uniform>             this_round      : Round;
@group(0) @binding(1) var<storage, read>       previous        : array<vec4f>;      // vertex_count  m; w: 1/kg
@group(0) @binding(2) var<storage, read>       position        : array<vec4f>;      // vertex_count  m, where ways end
@group(0) @binding(3) var<storage, read>       places          : array<PatchPlace>; // patch_count
@group(0) @binding(4) var<storage, read>       patches         : array<vec4f>;      // 2 * patch_count: find_open.wgsl
@group(0) @binding(5) var<storage, read_write> vertex_contacts : array<atomic<u32>>;
@group(0) @binding(6) var<storage, read_write> statistics      : array<atomic<u32>>;
override kEndWays : bool = false;

fn is_held(vertex : u32) -> bool {
  let held = atomicLoad(&vertex_contacts[kVertexWords * vertex + kHeldWord]);
  return previous[vertex].w == 0.0 || (held & kHeld) != 0u;
}

fn mark_folded(corners : vec3u, least : f32, start : f32) {
  if (this_round.is_first != 0u && least < kFolding) { atomicStore(&statistics[kStatDetect], 1u); }
  if (least >= kFolded) { return; }
  if (this_round.is_first == 0u && is_held(corners.x) && is_held(corners.y) && is_held(corners.z)) { return; }
  for (var k = 0u; k < 3u; k++) { atomicOr(&vertex_contacts[kVertexWords * corners[k] + kHeldWord], kMarked); }
  if (this_round.is_last != 0u) { slow_all(part_until(start, least, kFolded)); }
  atomicMax(&statistics[kStatMeeting], this_round.number);
}

// Equation (6c). If no corner of a triangle goes farther along the patch than the room, its sides change by no more
// than twice that, and λ by no more than twice that by its shortest altitude: it stays above kFolded.
fn end_before_fold(vertex : u32, room : f32, axes : Axes) {
  let way = position[vertex].xyz - previous[vertex].xyz;
  let along = length(vec2f(dot(axes.first, way), dot(axes.second, way)));
  if (along > room) {
    atomicMax(&vertex_contacts[kVertexWords * vertex + kPartWord], ~bitcast<u32>(room / along));
  }
}

fn keep_quad(cell : u32, k : u32) {
  let place = places[cell];
  let quad = quad_of_cell(place, k);
  if (!quad.exists) { return; }
  if (!kEndWays) {
    let found = openness_of_ends(cell, place, quad);
    for (var t = 0u; t < 2u; t++) {
      if (found.least[t] >= kFolding) { continue; }
      let axes = axes_around(cell, place, found.around[t]);
      let now = openness(starts_of(quad.corners), quad.down, t == 1u, place, axes.first, axes.second);
      mark_folded(triangle_of(quad.corners, quad.down, t == 1u), found.least[t], now);
    }
    return;
  }
  let start = starts_of(quad.corners);
  for (var around = 0u; around < kPatchesAround * kPatchesAround; around++) {
    let axes = axes_around(cell, place, around);
    if (!axes.open) { continue; }
    for (var t = 0u; t < 2u; t++) {
      let corners = triangle_of(quad.corners, quad.down, t == 1u);
      let now = openness(start, quad.down, t == 1u, place, axes.first, axes.second);
      let room = 0.5 * max(0.0, now - kFolded) * altitude_of(place);
      for (var corner = 0u; corner < 3u; corner++) { end_before_fold(corners[corner], room, axes); }
    }
  }
}

@compute @workgroup_size(kWorkgroupSize)
fn keep_open(@builtin(global_invocation_id) id : vec3u, @builtin(num_workgroups) groups : vec3u,
             @builtin(local_invocation_index) thread : u32) {
  let count = quads_of_round(thread, kEndWays);
  for (var k = id.x; k < count; k += groups.x * kWorkgroupSize) { keep_quad(k / kCellQuads, k % kCellQuads); }
}
