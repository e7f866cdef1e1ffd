// Keeps triangles of open patches from folding, in the rounds that separate pairs of cloth, as a blow that gives no
// energy and adds no momentum: what would end with too small a λ, and a smaller one than it begins with, ends with no
// less. λ is linear in the places along the direction in which it is the least. A triangle shares the masses of its
// corners with what else moves them in this round: at first it counts, as kGives it adds what it moves them by, and
// their velocities likewise. Grid-stride loop over the quads of cells. Source: docs/contact.md, equation (6g).
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "state/contact.wgsl"
#include "state/statistics.wgsl"
#include "contact/proximity/cell_quads.wgsl"
#include "contact/proximity/sums.wgsl"
//                                                                                elements          unit
@group(0) @binding(0) var<uniform>             this_round      : Round;
@group(0) @binding(1) var<uniform>             step            : StepBlock;
@group(0) @binding(2) var<storage, read>       previous        : array<vec4f>;      // vertex_count  m; w: 1/kg
@group(0) @binding(3) var<storage, read>       position        : array<vec4f>;      // vertex_count  m, where ways end
@group(0) @binding(4) var<storage, read>       velocity        : array<vec4f>;      // vertex_count  m/s
@group(0) @binding(5) var<storage, read>       places          : array<PatchPlace>; // patch_count
@group(0) @binding(6) var<storage, read>       patches         : array<vec4f>;      // 2 * patch_count: find_open.wgsl
@group(0) @binding(7) var<storage, read_write> vertex_contacts : array<atomic<u32>>;
@group(0) @binding(8) var<storage, read_write> statistics      : array<atomic<u32>>;
override kGives : bool = false;
const kKeptOpen = 0.2;  // λ; above kFolded, at which triangles are held back

fn places_along(at : Quad, n : vec3f) -> vec4f { return vec4f(dot(n, at.a), dot(n, at.b), dot(n, at.c), dot(n, at.d)); }
fn ways_by_speed(corners : vec4u) -> Quad {
  let dt = step.time.dt;
  return Quad(dt * velocity[corners.x].xyz, dt * velocity[corners.y].xyz, dt * velocity[corners.z].xyz,
              dt * velocity[corners.w].xyz);
}

// Beside crossings, which are driven apart, triangles are held back: separate_pairs.wgsl.
fn is_tangled(corners : vec4u) -> bool {
  var marks = 0u;
  for (var k = 0u; k < 4u; k++) { marks |= atomicLoad(&vertex_contacts[kVertexWords * corners[k] + kTangledWord]); }
  return marks != 0u;
}

fn unfold_triangle(quad : CellQuad, second : bool, place : PatchPlace, axes : Axes) {
  let corners = quad.corners;
  let mobility = vec4f(previous[corners.x].w, previous[corners.y].w, previous[corners.z].w, previous[corners.w].w);
  let squeezed = least_direction(ends_of(corners), quad.down, second, place, axes.first, axes.second);
  let weights = squeezed.weights;
  let moves = (weights != vec4f(0.0)) & (mobility > vec4f(0.0));
  let start = dot(weights, places_along(starts_of(corners), squeezed.direction));
  let kept = min(kKeptOpen, start);
  let lack = kept - dot(weights, places_along(ends_of(corners), squeezed.direction));
  if (lack <= 0.0 || !any(moves) || is_tangled(corners)) { return; }
  if (!kGives) {
    for (var k = 0u; k < 4u; k++) {
      if (moves[k]) { share_mass(corners[k]); }
    }
    atomicMax(&statistics[kStatMeeting], this_round.number);
    return;
  }
  let shares = vec4f(share_count(corners.x), share_count(corners.y), share_count(corners.z), share_count(corners.w));
  let parts = weights * mobility / dot(weights * weights * mobility, shares);
  let by_speed = start + dot(weights, places_along(ways_by_speed(corners), squeezed.direction));
  let lack_of_speed = max(0.0, kept - by_speed) / step.time.dt;
  for (var k = 0u; k < 4u; k++) {
    move_by(corners[k], parts[k] * lack, parts[k] * lack_of_speed, squeezed.direction);
  }
}

@compute @workgroup_size(kWorkgroupSize)
fn unfold(@builtin(global_invocation_id) id : vec3u, @builtin(num_workgroups) groups : vec3u,
          @builtin(local_invocation_index) thread : u32) {
  let count = quads_of_round(thread, kGives);
  for (var k = id.x; k < count; k += groups.x * kWorkgroupSize) {
    let cell = k / kCellQuads;
    let place = places[cell];
    let quad = quad_of_cell(place, k % kCellQuads);
    if (!quad.exists) { continue; }
    let found = openness_of_ends(cell, place, quad);
    for (var t = 0u; t < 2u; t++) {
      if (found.least[t] >= kKeptOpen) { continue; }
      unfold_triangle(quad, t == 1u, place, axes_around(cell, place, found.around[t]));
    }
  }
}
