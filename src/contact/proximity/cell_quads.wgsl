// The quads of cells of open patches, and how open their triangles are where ways end. The including kernel binds
// `previous` and `position`, where ways begin and end, `places`, `patches`, and what rounds.wgsl asks for.
// Source: docs/contact.md, Patches.
#include "contact/proximity/patches.wgsl"
#include "contact/proximity/rounds.wgsl"
var<workgroup> quads : u32;

// How many quads a kernel of a round goes through, with places for kCellQuads of each cell; 0: the round is idle. All
// invocations of a workgroup call it.
fn quads_of_round(thread : u32, acts : bool) -> u32 {
  if (thread == 0u) { quads = select(kCellQuads * arrayLength(&places), 0u, round_is_idle(acts)); }
  return workgroupUniformLoad(&quads);
}

// An open patch: its axes.
struct Axes { first : vec3f, second : vec3f, open : bool }
// One of the patches that a cell lies in.
fn axes_around(cell : u32, place : PatchPlace, around : u32) -> Axes {
  let number = cell + around % kPatchesAround + place.columns * (around / kPatchesAround);
  let first = patches[2u * number];
  return Axes(first.xyz, patches[2u * number + 1u].xyz, first.w >= kOpen);
}

// The quad with number k of a cell.
struct CellQuad { exists : bool, corners : vec4u, down : bool }
fn quad_of_cell(place : PatchPlace, k : u32) -> CellQuad {
  let width = columns_of(place.cell_size);
  let i = k % max(width, 1u);
  let j = k / max(width, 1u);
  let exists = k < width * rows_of(place.cell_size);
  return CellQuad(exists, quad_of(place.cell_vertex, place.stride, i, j), leads_down(i, j));
}

fn starts_of(corners : vec4u) -> Quad {
  return Quad(previous[corners.x].xyz, previous[corners.y].xyz, previous[corners.z].xyz, previous[corners.w].xyz);
}
fn ends_of(corners : vec4u) -> Quad {
  return Quad(position[corners.x].xyz, position[corners.y].xyz, position[corners.z].xyz, position[corners.w].xyz);
}

// The least λ of a quad's triangles in the open patches around it, and in which one; 1 where none is open.
struct Openness { least : vec2f, around : vec2u }
fn openness_of_ends(cell : u32, place : PatchPlace, quad : CellQuad) -> Openness {
  let end = ends_of(quad.corners);
  var found = Openness(vec2f(1.0), vec2u(0u));
  for (var around = 0u; around < kPatchesAround * kPatchesAround; around++) {
    let axes = axes_around(cell, place, around);
    if (!axes.open) { continue; }
    let here = vec2f(openness(end, quad.down, false, place, axes.first, axes.second),
                     openness(end, quad.down, true, place, axes.first, axes.second));
    found.around = select(found.around, vec2u(around), here < found.least);
    found.least = min(found.least, here);
  }
  return found;
}
