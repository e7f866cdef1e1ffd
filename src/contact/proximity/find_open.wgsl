// Finds which patches of the cloth are open, at the start of the substep and where its motion leads, and their axes:
// those of the patch's corners, turned so that both lean as much as the other. One workgroup a patch. Only where a
// search is due. Source: docs/contact.md, Patches.
#include "gpu/index.wgsl"
#include "contact/geometry.wgsl"
#include "state/step.wgsl"
#include "state/statistics.wgsl"
#include "contact/proximity/patches.wgsl"
//                                                                        elements
@group(0) @binding(0) var<uniform>             step       : StepBlock;
@group(0) @binding(1) var<storage, read>       position   : array<vec4f>;      // vertex_count  m; w: 1/kg
@group(0) @binding(2) var<storage, read>       motion     : array<vec4f>;      // vertex_count  see kPredicted
@group(0) @binding(3) var<storage, read>       places     : array<PatchPlace>; // patch_count
@group(0) @binding(4) var<storage, read>       statistics : array<u32>;
@group(0) @binding(5) var<storage, read_write> patches    : array<vec4f>;      // 2 * patch_count  the axes; w: λ
override kPredicted : bool = true;  // `motion` has where vertices come in this substep, m; false: velocities, m/s
const kQuads = 64u;  // of a patch, tested at once; mirror: src/contact/proximity/cloth_patches.cpp
var<workgroup> least : array<f32, kQuads>;

fn place_at(vertex : u32) -> vec3f { return position[vertex].xyz; }
fn end_at(vertex : u32) -> vec3f {
  if (kPredicted) { return motion[vertex].xyz; }
  return position[vertex].xyz + step.time.dt * motion[vertex].xyz;
}
// Contact cannot hold back what the scene moves.
fn is_driven(vertex : u32) -> bool { return position[vertex].w == 0.0 && step.contact.collider_travel > 0.0; }

struct Axes { first : vec3f, second : vec3f }
fn axes_of(place : PatchPlace) -> Axes {
  let width = columns_of(place.patch_size);
  let below = place.patch_vertex + rows_of(place.patch_size) * place.stride;
  let across = place_at(below + width) - place_at(place.patch_vertex);
  let aside = place_at(place.patch_vertex + width) - place_at(below);
  let row = unit(across + aside);
  let column = unit(across - aside);
  let sum = unit(row + column);
  let difference = unit(row - column);
  return Axes(sqrt(0.5) * (sum + difference), sqrt(0.5) * (sum - difference));
}

fn openness_of_quad(place : PatchPlace, axes : Axes, i : u32, j : u32) -> f32 {
  let quad = quad_of(place.patch_vertex, place.stride, i, j);
  if (is_driven(quad.x) || is_driven(quad.y) || is_driven(quad.z) || is_driven(quad.w)) { return 0.0; }
  let down = leads_down(i, j);
  let start = Quad(place_at(quad.x), place_at(quad.y), place_at(quad.z), place_at(quad.w));
  let end = Quad(end_at(quad.x), end_at(quad.y), end_at(quad.z), end_at(quad.w));
  return min(least_openness(start, down, place, axes), least_openness(end, down, place, axes));
}
fn least_openness(at : Quad, down : bool, place : PatchPlace, axes : Axes) -> f32 {
  if (!(is_finite(at.a) && is_finite(at.b) && is_finite(at.c) && is_finite(at.d))) { return 0.0; }
  return min(openness(at, down, false, place, axes.first, axes.second),
             openness(at, down, true, place, axes.first, axes.second));
}

@compute @workgroup_size(kQuads)
fn find_open(@builtin(workgroup_id) group : vec3u, @builtin(local_invocation_index) thread : u32) {
  let patch_number = flat_group(group);
  let works = statistics[kStatDue] != 0u && patch_number < arrayLength(&places);
  var found = 1.0;
  var axes = Axes(vec3f(0.0), vec3f(0.0));
  if (works) {
    let place = places[patch_number];
    let width = columns_of(place.patch_size);
    if (place.patch_size != 0u) { axes = axes_of(place); }
    for (var quad = thread; quad < width * rows_of(place.patch_size); quad += kQuads) {
      found = min(found, openness_of_quad(place, axes, quad % width, quad / width));
    }
    if (place.patch_size == 0u) { found = 0.0; }
  }
  least[thread] = found;
  workgroupBarrier();
  if (thread != 0u || !works) { return; }
  for (var k = 0u; k < kQuads; k++) { found = min(found, least[k]); }
  patches[2u * patch_number] = vec4f(axes.first, found);
  patches[2u * patch_number + 1u] = vec4f(axes.second, 0.0);
}
