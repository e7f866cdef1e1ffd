// A walk through a tree by all invocations of a workgroup at once, each of which tests a child of a node: with the
// boxes of all their triangles, since those lie side by side and meet nearly the same nodes. The triangles of the
// leaves that it meets wait in `met`. Nodes in one open patch with a part of theirs are not met by it. The including
// kernel binds `params`, `trees` and `patches`.
#include "contact/proximity/tree.wgsl"
#include "contact/proximity/triangles.wgsl"
#include "contact/proximity/patch_cells.wgsl"
struct Tree {
  kind : u32,   // of its triangles, as candidates have it
  tree : u32,   // its first word of `trees`; of a rigid mesh: of its nodes (src/contact/object_tree.hpp)
  first : u32,  // of `triangles`, its first one; of a rigid mesh: of `trees`, the first word of its triangles
  count : u32,  // its triangles; not of a rigid mesh
  after : u32,  // only triangles from this one on
}
const kOwn = 64u;       // triangles of a workgroup; mirror: src/contact/proximity/pair_search.cpp
const kWalkers = 128u;  // its invocations; mirror there
const kRigidArity = 4u;
const kRigidNode = 8u;  // words
const kMostOfLeaf = 7u;  // what three bits can say
const kParts = 8u;
const kOfPart = kOwn / kParts;  // triangles

const kStackRoom = 512u;
const kMetRoom = 1536u;
// What a walk of a rigid mesh needs that takes one node at a time: src/contact/object_tree.hpp. One of an implicit
// tree, of ten levels at most, needs 7 more a level, which is less than kWalkers and this together.
const kStackSize = 32u;
const kLevelShift = 28u;
var<workgroup> lows : array<vec3f, kOwn>;
var<workgroup> highs : array<vec3f, kOwn>;
var<workgroup> part_lows : array<vec3f, kParts>;
var<workgroup> part_highs : array<vec3f, kParts>;
var<workgroup> part_cells : array<vec4u, kParts>;  // of the cloths' tree, in its open patches
var<workgroup> part_patches : array<u32, kParts>;  // patch_cells.wgsl
var<workgroup> stack : array<u32, kStackRoom>;  // nodes: of implicit trees with their level in the upper four bits
var<workgroup> met : array<u32, kMetRoom>;      // places of triangles, as candidates have them
var<workgroup> met_count : atomic<u32>;
var<workgroup> inner_bits : atomic<u32>;        // of a node that is taken alone: its inner children that are met
var<workgroup> stacked : atomic<u32>;           // nodes that a step has put on the stack
var<workgroup> walk_sizes : vec2u;              // nodes in the stack; places in `met`

// The boxes of the workgroup's triangles, united in kParts: one box for all would cover all that lies between two
// cloths that share a workgroup.
fn unite_parts(box : Box, thread : u32) {
  if (thread < kOwn) {
    lows[thread] = box.low;
    highs[thread] = box.high;
  }
  workgroupBarrier();
  if (thread < kParts) {
    var part = empty_box();
    for (var k = thread * kOfPart; k < (thread + 1u) * kOfPart; k++) {
      part = united(part, Box(lows[k], highs[k]));
    }
    part_lows[thread] = part.low;
    part_highs[thread] = part.high;
  }
}

fn meets_parts(box : Box, cells : vec4u) -> bool {
  var meets = false;
  for (var k = 0u; k < kParts; k++) {
    meets = meets || (overlap(box, Box(part_lows[k], part_highs[k])) &&
                      !in_patch(part_patches[k], part_cells[k], cells));
  }
  return meets;
}

// Which patches the parts lie in, once for all walks.
fn find_patches(first_own : u32, thread : u32) {
  if (thread >= kParts) { return; }
  var cells = cells_of_leaf((first_own + kOfPart * thread) / kLeafTriangles);
  for (var t = kLeafTriangles; t < kOfPart; t += kLeafTriangles) {
    cells = united_cells(cells, cells_of_leaf((first_own + kOfPart * thread + t) / kLeafTriangles));
  }
  part_cells[thread] = cells;
  part_patches[thread] = open_patches(cells);
}

fn begin_walk(tree : Tree, thread : u32) {
  if (thread == 0u) {
    stack[0] = 0u;  // the root
    if (tree.kind != kNearRigid) { stack[0] = trees[tree.tree].x << kLevelShift; }
    walk_sizes = vec2u(1u, 0u);
    atomicStore(&met_count, 0u);
    atomicStore(&stacked, 0u);
    atomicStore(&inner_bits, 0u);
  }
}

// What a walk goes on with at a child that meets the boxes: a node, or the triangles of a leaf.
struct Child { node : u32, first : u32, count : u32, inner : bool }

fn rigid_child(tree : Tree, node : u32, k : u32) -> Child {
  let word = tree.tree + kRigidNode * node;
  let low = bitcast<vec3f>(vec3u(trees[word][k], trees[word + 1u][k], trees[word + 2u][k]));
  let high = bitcast<vec3f>(vec3u(trees[word + 3u][k], trees[word + 4u][k], trees[word + 5u][k]));
  let child = trees[word + 6u][k];
  if (child == 0u || !meets_parts(Box(low, high), kNoPatch)) { return Child(0u, 0u, 0u, false); }
  return Child(child / 8u, tree.first + 3u * (child / 8u), child % 8u, child % 8u == 0u);
}

fn implicit_child(tree : Tree, entry : u32, k : u32) -> Child {
  let level = (entry >> kLevelShift) - 1u;  // the child's
  let node = kTreeArity * (entry & ((1u << kLevelShift) - 1u)) + k;
  let place = trees[tree.tree + 1u + level];
  let end = kLeafTriangles * ((node + 1u) << (3u * level));
  if (node >= place.y || end <= tree.after) { return Child(0u, 0u, 0u, false); }
  let word = place.x + 2u * node;
  let box = Box(bitcast<vec3f>(trees[word].xyz), bitcast<vec3f>(trees[word + 1u].xyz));
  if (!meets_parts(box, select(kNoPatch, cells_of_box(word), tree.kind == kNearCloth))) {
    return Child(0u, 0u, 0u, false);
  }
  let first = max(kLeafTriangles * node, tree.after);
  return Child((level << kLevelShift) | node, tree.first + first, select(min(end, tree.count) - first, 0u, level > 0u),
               level > 0u);
}

// Takes some nodes from the stack, puts there those of their children that meet the boxes, and to `met` the triangles
// of leaves. All invocations of a workgroup call it. Near the end of the stack it takes one node at a time, whose
// children come in their order: the room left is enough for that.
fn walk_on(tree : Tree, waiting : u32, thread : u32) {
  let arity = select(kTreeArity, kRigidArity, tree.kind == kNearRigid);
  var taken = min(waiting, kWalkers / arity);
  if (waiting + kWalkers + kStackSize > kStackRoom) { taken = 1u; }
  let alone = taken == 1u;
  let slot = thread / arity;
  let k = thread % arity;
  var child = Child(0u, 0u, 0u, false);
  if (slot < taken) {
    let entry = stack[waiting - 1u - slot];
    if (tree.kind == kNearRigid) {
      child = rigid_child(tree, entry, k);
    } else {
      child = implicit_child(tree, entry, k);
    }
  }
  if (child.count > 0u) {
    let place = atomicAdd(&met_count, child.count);
    let step = select(1u, 3u, tree.kind == kNearRigid);
    for (var t = 0u; t < child.count; t++) { met[place + t] = child.first + step * t; }
  }
  if (child.inner && alone) { atomicOr(&inner_bits, 1u << k); }
  workgroupBarrier();
  if (child.inner) {
    var place = countOneBits(atomicLoad(&inner_bits) & ((1u << k) - 1u));
    if (!alone) { place = atomicAdd(&stacked, 1u); }
    stack[waiting - taken + place] = child.node;
  }
  workgroupBarrier();
  if (thread == 0u) {
    let more = select(atomicLoad(&stacked), countOneBits(atomicLoad(&inner_bits)), alone);
    walk_sizes = vec2u(waiting - taken + more, atomicLoad(&met_count));
    atomicStore(&stacked, 0u);
    atomicStore(&inner_bits, 0u);
  }
}
