// The implicit tree over triangles in a fixed order, in the buffer `trees` of 16-byte words: a node's children are the eight
// boxes of the level below from 8 * its number on; a leaf is four triangles. A box is two words, low and high [m].
// Source: Chitalu et al. 2020, Binary Ostensibly-Implicit Trees for Fast Collision Detection. Mirror: src/collision/implicit_tree.hpp.
//
// The tree begins with a word (levels - 1, 0, 0, 0), then a word (first word of its boxes, their number, 0, 0) a level, leaves first.
const kLeafTriangles = 4u;
const kTreeArity = 8u;

struct Box { low : vec3f, high : vec3f }

fn box_of(a : vec3f, b : vec3f, c : vec3f) -> Box { return Box(min(min(a, b), c), max(max(a, b), c)); }
fn grown(box : Box, r : f32) -> Box { return Box(box.low - vec3f(r), box.high + vec3f(r)); }
fn overlap(a : Box, b : Box) -> bool { return all(a.low <= b.high) && all(b.low <= a.high); }
fn united(a : Box, b : Box) -> Box { return Box(min(a.low, b.low), max(a.high, b.high)); }
// Overlaps nothing, and leaves every box that it is united with as it is.
fn empty_box() -> Box { return Box(vec3f(3e38), vec3f(-3e38)); }

// Found on the bits: a compiler may take NaN and infinity to be absent.
fn is_finite(v : vec3f) -> bool {
  return all((bitcast<vec3u>(v) & vec3u(0x7f800000u)) != vec3u(0x7f800000u));
}
