// The implicit tree over triangles in a fixed order, in the buffer `trees` of 16-byte words: a node's children are the
// eight boxes of the level below from 8 * its number on; a leaf is four triangles. A box is two words: low, high [m];
// their w say which cells of cloth it covers (patch_cells.wgsl), and never change.
// Source: Chitalu et al. 2020, Binary Ostensibly-Implicit Trees for Fast Collision Detection.
// Mirror: src/contact/proximity/implicit_tree.hpp.
//
// The tree begins with a word (levels - 1, 0, 0, 0). A word (first word of its boxes, their number, 0, 0) for each
// level follows, leaves first.
#include "contact/geometry.wgsl"
const kLeafTriangles = 4u;
const kTreeArity = 8u;

fn box_of(a : vec3f, b : vec3f, c : vec3f) -> Box { return Box(min(min(a, b), c), max(max(a, b), c)); }
fn grown(box : Box, r : f32) -> Box { return Box(box.low - vec3f(r), box.high + vec3f(r)); }
fn overlap(a : Box, b : Box) -> bool { return all((a.low <= b.high) & (b.low <= a.high)); }
fn united(a : Box, b : Box) -> Box { return Box(min(a.low, b.low), max(a.high, b.high)); }
// Overlaps nothing, and leaves every box that it is united with as it is.
fn empty_box() -> Box { return Box(vec3f(3e38), vec3f(-3e38)); }

// Of a cloth triangle: places, and slacks in w (reach.wgsl).
fn largest_reach(a : vec4f, b : vec4f, c : vec4f) -> f32 { return max(max(a.w, b.w), c.w); }
// The box of all that a cloth triangle may pass on its corners' ways ahead, without their slack.
fn swept_box(a : vec3f, b : vec3f, c : vec3f, ahead_a : vec3f, ahead_b : vec3f, ahead_c : vec3f) -> Box {
  return united(box_of(a, b, c), box_of(a + ahead_a, b + ahead_b, c + ahead_c));
}
