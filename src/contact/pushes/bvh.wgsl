// Contacts through the tree over the object triangles: the pairs and pushes of paper.wgsl, bit for bit, in
// O(log) visits. One invocation for kTrianglesEach cloth triangles, 1 or 2: one walk with the box of both costs little
// more than either alone, which pays where the card is full of invocations anyway (src/contact/pushes/pairs_bvh.cpp
// chooses). Source: docs/collision.md.
//
// Leaves that the walk finds wait in a short list and are tested together, so that invocations of a wave, which find
// theirs at different times, spend the costly test at the same time.
#include "gpu/index.wgsl"
#include "contact/pushes/contact_pair.wgsl"

// Mirror: TreeNode in src/contact/object_tree.hpp. Four children, component by component.
struct TreeNode {
  low_x : vec4f, low_y : vec4f, low_z : vec4f,     // m
  high_x : vec4f, high_y : vec4f, high_z : vec4f,  // m
  child : vec4u,  // leaf: 8 * its first triangle + their number, 1 to 4; inner node: 8 * node; 0: none
  spare : vec4u,  // fills the node up to a cache line of 128 bytes
}
//                                                                                       elements      unit
@group(0) @binding(0) var<uniform>             step             : StepBlock;          // 1
@group(0) @binding(1) var<storage, read>       predicted        : array<vec4f>;       // vertex_count  m; w: 1/kg
@group(0) @binding(2) var<storage, read>       previous         : array<vec4f>;       // vertex_count  m; w: 1/kg
@group(0) @binding(3) var<storage, read>       cloth_triangles  : array<u32>;         // 3 * cloth triangles
@group(0) @binding(4) var<storage, read>       object_triangles : array<ObjectTriangle>;
@group(0) @binding(5) var<storage, read>       object_ids       : array<u32>;         // number in the meshes
@group(0) @binding(6) var<storage, read_write> pushes           : array<atomic<i32>>; // 4 * vertex_count: push, count
@group(0) @binding(7) var<storage, read_write> statistics       : array<atomic<u32>>; // state/statistics.wgsl
@group(0) @binding(8) var<storage, read>       tree             : array<TreeNode>;

override kTrianglesEach : u32 = 2;
const kStackSize = 32u;  // kStackSize of object_tree.hpp, which proves that it suffices
const kLeafRoom = 8u;    // waiting leaves; a node adds at most 4, a leaf holds at most 4 triangles: 32 marks

@compute @workgroup_size(kWorkgroupSize)
fn bvh(@builtin(global_invocation_id) id : vec3u) {
  let cloth_count = arrayLength(&cloth_triangles) / 3u;
  let first = kTrianglesEach * flat_index(id);
  if (first >= cloth_count) { return; }
  var pair = cloth_pair(first, cloth_count);
  pair.use_b = pair.use_b && kTrianglesEach == 2u;
  if (!pair.use_a && !pair.use_b) { return; }
  var query = pair.query_a;
  if (!pair.use_a) { query = pair.query_b; }
  if (pair.use_a && pair.use_b) {
    query = Box(min(pair.query_a.low, pair.query_b.low), max(pair.query_a.high, pair.query_b.high));
  }

  var found : HitCount;
  var stack : array<u32, kStackSize>;
  var size = 1u;  // the root, node 0, waits
  var leaves : array<vec2u, kLeafRoom>;  // first triangle and number
  var overflow = 0u;
  var budget = arrayLength(&tree);  // no node comes twice, whatever the tree holds
  while (size > 0u && budget > 0u) {
    var leaf_count = 0u;
    while (size > 0u && budget > 0u && leaf_count <= kLeafRoom - 4u) {
      budget--;
      size--;
      let at = stack[size];
      let child = tree[at].child;
      let overlap = (vec4f(query.low.x) <= tree[at].high_x) & (tree[at].low_x <= vec4f(query.high.x)) &
                    (vec4f(query.low.y) <= tree[at].high_y) & (tree[at].low_y <= vec4f(query.high.y)) &
                    (vec4f(query.low.z) <= tree[at].high_z) & (tree[at].low_z <= vec4f(query.high.z));
      for (var k = 0u; k < 4u; k++) {
        if (!overlap[k]) { continue; }
        let count = child[k] % 8u;
        let index = child[k] / 8u;
        if (count > 0u) {
          leaves[leaf_count] = vec2u(index, count);
          leaf_count++;
        } else if (index > 0u) {
          if (size < kStackSize) { stack[size] = index; size++; } else { overflow++; }
        }
      }
    }
    // Hits are marked first and added after: they are rare, and where a wave cannot skip a branch (software adapters)
    // each test would pay for an addition; SwiftShader took four times as long.
    var marks_a = 0u;
    var marks_b = 0u;
    for (var l = 0u; l < leaf_count; l++) {
      for (var t = 0u; t < leaves[l].y; t++) {
        let object = points_of(object_triangles[leaves[l].x + t]);
        let bit = 1u << (4u * l + t);
        marks_a |= select(0u, bit, pair.use_a && triangles_intersect(pair.a, pair.query_a, object));
        marks_b |= select(0u, bit, pair.use_b && triangles_intersect(pair.b, pair.query_b, object));
      }
    }
    while ((marks_a | marks_b) != 0u) {
      let in_a = marks_a != 0u;
      let k = firstTrailingBit(select(marks_b, marks_a, in_a));
      marks_b = select(marks_b & (marks_b - 1u), marks_b, in_a);
      marks_a &= marks_a - 1u;
      add_pair(&found, select(pair.second, pair.first, in_a), select(pair.nodes_b, pair.nodes_a, in_a),
               leaves[k / 4u].x + k % 4u);
    }
  }
  write_count(found);
  if (overflow + size > 0u) { atomicAdd(&statistics[kStatContactOverflow], overflow + size); }
}
