// Patches of cloth that is a grid: squares of two cells by two, fewer at the sheet's border, that overlap by half. A
// cell is a square of quads and lies in four patches. The table of patches has rows and columns, and in one place a
// cell and the patch whose last cell that is, the farthest from the grid's first node.
// Source: docs/contact.md, Patches.
//
// How open a patch is says λ, the least eigenvalue, over its triangles, of the symmetric part of Eᵀ F: E = (e1 e2) are
// axes of the patch, F is the derivative of places by those at rest. Any two points of it that are r apart at rest are
// at least λ r apart.
struct PatchPlace {  // mirror: src/contact/proximity/patch_table.hpp
  cell_vertex : u32,   // the first node of the cell; from it on columns by 1, rows by `stride`
  patch_vertex : u32,  // of the patch
  stride : u32,
  cell_size : u32,     // quads along a row, and in the upper half of the bits along a column; 0: no cell
  patch_size : u32,
  per_width : f32,     // 1/m: one by a quad's width at rest
  per_height : f32,
  columns : u32,       // of the table
}
const kOpen = 0.6;       // the least λ with which a search takes a patch to be open
const kFolding = 0.51;   // below this λ features of a patch may be as near as the thickness, and must be searched
const kFolded = 0.1;     // no triangle of an open patch comes below this
const kPatchesAround = 2u;  // of a cell, along either side
const kNoCell = 0xffffffffu;  // of a triangle that no patch has
const kCellQuads = 64u;    // the most of a cell; mirror: src/contact/proximity/patch_table.hpp

fn columns_of(size : u32) -> u32 { return size & 0xffffu; }
fn rows_of(size : u32) -> u32 { return size >> 16u; }

// The shortest altitude of a triangle at rest, m.
fn altitude_of(place : PatchPlace) -> f32 { return 1.0 / length(vec2f(place.per_width, place.per_height)); }

// The corners of a quad: a and b along the row, c and d below them.
fn quad_of(vertex : u32, stride : u32, i : u32, j : u32) -> vec4u {
  let a = vertex + j * stride + i;
  return vec4u(a, a + 1u, a + stride, a + stride + 1u);
}
// Whether the quad's diagonal leads from a to d: mesh::grid_triangles. Cells and patches begin at even nodes.
fn leads_down(i : u32, j : u32) -> bool { return (i + j) % 2u == 0u; }
// The two triangles of a quad, by its corners: the first has the side from a to c.
fn triangle_of(quad : vec4u, down : bool, second : bool) -> vec3u {
  if (down) { return select(quad.xzw, quad.xwy, second); }
  return select(quad.xzy, quad.yzw, second);
}

// The places of a quad's corners, m.
struct Quad { a : vec3f, b : vec3f, c : vec3f, d : vec3f }
// λ of a triangle of the quad.
fn openness(at : Quad, down : bool, second : bool, place : PatchPlace, e1 : vec3f, e2 : vec3f) -> f32 {
  let s = stretches_of(at, down, second, place, e1, e2);
  let half = 0.5 * (s.x - s.y);
  return 0.5 * (s.x + s.y) - sqrt(half * half + s.z * s.z);
}
// The symmetric part of Eᵀ F: xx, yy, xy.
fn stretches_of(at : Quad, down : bool, second : bool, place : PatchPlace, e1 : vec3f, e2 : vec3f) -> vec3f {
  let row = place.per_width * select(at.b - at.a, at.d - at.c, down != second);
  let column = place.per_height * select(at.c - at.a, at.d - at.b, second);
  return vec3f(dot(e1, row), dot(e2, column), 0.5 * (dot(e1, column) + dot(e2, row)));
}

// The direction in which a triangle of the quad is squeezed most: λ is the sum of the corners' places along it, by
// these weights.
struct Squeezed { direction : vec3f, weights : vec4f }
fn least_direction(at : Quad, down : bool, second : bool, place : PatchPlace, e1 : vec3f, e2 : vec3f) -> Squeezed {
  let s = stretches_of(at, down, second, place, e1, e2);
  let half = 0.5 * (s.x - s.y);
  let least = 0.5 * (s.x + s.y) - sqrt(half * half + s.z * s.z);
  var u = select(vec2f(-s.z, s.x - least), vec2f(least - s.y, s.z), half < 0.0);
  u = select(select(vec2f(0.0, 1.0), vec2f(1.0, 0.0), half < 0.0), u / length(u), any(u != vec2f(0.0)));
  let row = place.per_width * select(vec4f(-1.0, 1.0, 0.0, 0.0), vec4f(0.0, 0.0, -1.0, 1.0), down != second);
  let column = place.per_height * select(vec4f(-1.0, 0.0, 1.0, 0.0), vec4f(0.0, -1.0, 0.0, 1.0), second);
  return Squeezed(u.x * e1 + u.y * e2, u.x * row + u.y * column);
}
