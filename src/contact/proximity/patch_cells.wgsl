// Which triangles lie in one open patch of the cloth: pairs of these are not searched. Triangles and boxes of the
// cloths' tree know the cells that they cover in the table (patches.wgsl): the first column and row, the last ones. The
// including kernel binds `params`, `trees` and `patches`.
#include "contact/proximity/patches.wgsl"
#include "contact/proximity/tree.wgsl"
#include "contact/proximity/triangles.wgsl"
const kNoPatch = vec4u(0u, 0u, 0xffffu, 0xffffu);  // cells that no patch has all of

fn cells_of_box(word : u32) -> vec4u {
  let columns = trees[word].w;
  let rows = trees[word + 1u].w;
  return vec4u(columns & 0xffffu, rows & 0xffffu, columns >> 16u, rows >> 16u);
}
// Of a cloth triangle, by its place in the order of their tree.
fn cells_of_triangle(place : u32) -> vec4u {
  let cell = trees[params.first_opposite + place].w;
  if (cell == kNoCell) { return kNoPatch; }
  return vec4u(cell & 0xffffu, cell >> 16u, cell & 0xffffu, cell >> 16u);
}
// Of a leaf of the cloths' tree, which is the first one.
fn cells_of_leaf(leaf : u32) -> vec4u {
  if (leaf >= trees[1].y) { return kNoPatch; }
  return cells_of_box(trees[1].x + 2u * leaf);
}
fn united_cells(a : vec4u, b : vec4u) -> vec4u { return vec4u(min(a.xy, b.xy), max(a.zw, b.zw)); }

// The open patches that have all these cells, as bits: a patch ends at the first column or at the next one, and so with
// rows.
fn open_patches(cells : vec4u) -> u32 {
  var found = 0u;
  for (var k = 0u; k < kPatchesAround * kPatchesAround; k++) {
    let last = cells.xy + vec2u(k % kPatchesAround, k / kPatchesAround);
    if (any(cells.zw > last)) { continue; }
    let number = last.x + params.patch_columns * last.y;
    if (patches[2u * number].w >= kOpen) { found |= 1u << k; }
  }
  return found;
}
// Whether one of the patches found has these cells, too.
fn in_patch(found : u32, cells : vec4u, others : vec4u) -> bool {
  let before = (others.xy + 1u >= cells.xy) & (others.zw <= cells.xy);  // by columns and rows, if it ends at the first
  let behind = (others.xy >= cells.xy) & (others.zw <= cells.xy + 1u);  // or at the next one
  let has = select(0u, 1u, before.x && before.y) | select(0u, 2u, behind.x && before.y) |
            select(0u, 4u, before.x && behind.y) | select(0u, 8u, behind.x && behind.y);
  return (has & found) != 0u;
}
