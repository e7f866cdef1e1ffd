// Contacts through the tree over the object triangles: the pairs and pushes of paper.wgsl, bit for bit, in
// O(log) visits. One invocation a cloth triangle. Source: docs/collision.md.
//
// Leaves that the walk finds wait in a short list and are tested together, so that invocations of a wave, which find
// theirs at different times, spend the costly test at the same time.
#include "shared/index.wgsl"
#include "collision/contact_sum.wgsl"

// Mirror: TreeNode in src/collision/object_tree.hpp. Four children, component by component.
struct TreeNode {
  low_x : vec4f, low_y : vec4f, low_z : vec4f,     // m
  high_x : vec4f, high_y : vec4f, high_z : vec4f,  // m
  child : vec4u,  // a leaf's first triangle or an inner node
  count : vec4u,  // a leaf's triangles, at most 4; 0: an inner node, or with child 0 none, since the root is no child
}
//                                                                                   elements            unit
@group(0) @binding(0) var<uniform>             step             : StepParams;         // 1
@group(0) @binding(1) var<storage, read>       predicted        : array<vec4f>;       // vertex_count       m (w: inverse mass, 1/kg)
@group(0) @binding(2) var<storage, read>       previous         : array<vec4f>;       // vertex_count       m (w: inverse mass, 1/kg)
@group(0) @binding(3) var<storage, read>       cloth_triangles  : array<u32>;         // 3 * cloth triangles
@group(0) @binding(4) var<storage, read>       object_triangles : array<ObjectTriangle>;  // in the order of leaves
@group(0) @binding(5) var<storage, read>       object_ids       : array<u32>;         // object triangles   their number in the meshes
@group(0) @binding(6) var<storage, read_write> pushes           : array<atomic<i32>>; // 4 * vertex_count   m * step.push_scale; count
@group(0) @binding(7) var<storage, read_write> statistics       : array<atomic<u32>>; // shared/statistics.wgsl
@group(0) @binding(8) var<storage, read>       nodes            : array<TreeNode>;

const kStackSize = 32u;  // kStackSize of object_tree.hpp, which proves that it suffices
const kLeafRoom = 12u;           // waiting leaves; a node adds at most 4

@compute @workgroup_size(kWorkgroupSize)
fn bvh(@builtin(global_invocation_id) id : vec3u) {
  let triangle = flat_index(id);
  if (triangle >= arrayLength(&cloth_triangles) / 3u) { return; }
  let corners = cloth_nodes(triangle);
  let cloth = cloth_points(corners);
  if (!all_finite(cloth)) { return; }
  let query = query_box(cloth);

  var sum : ContactSum;
  var stack : array<u32, kStackSize>;
  var size = 1u;  // the root, node 0, waits
  var leaves : array<vec2u, kLeafRoom>;
  var overflow = 0u;
  var budget = arrayLength(&nodes);  // no node comes twice, whatever the tree holds
  while (size > 0u && budget > 0u) {
    var leaf_count = 0u;
    while (size > 0u && budget > 0u && leaf_count <= kLeafRoom - 4u) {
      budget--;
      size--;
      let at = stack[size];
      let child = nodes[at].child;
      let count = nodes[at].count;
      let overlap = (vec4f(query.low.x) <= nodes[at].high_x) & (nodes[at].low_x <= vec4f(query.high.x)) &
                    (vec4f(query.low.y) <= nodes[at].high_y) & (nodes[at].low_y <= vec4f(query.high.y)) &
                    (vec4f(query.low.z) <= nodes[at].high_z) & (nodes[at].low_z <= vec4f(query.high.z));
      for (var k = 0u; k < 4u; k++) {
        if (!overlap[k]) { continue; }
        if (count[k] > 0u) {
          leaves[leaf_count] = vec2u(child[k], child[k] + count[k]);
          leaf_count++;
        } else if (child[k] > 0u) {
          if (size < kStackSize) { stack[size] = child[k]; size++; } else { overflow++; }
        }
      }
    }
    for (var l = 0u; l < leaf_count; l++) {
      for (var t = leaves[l].x; t < leaves[l].y; t++) {
        if (triangles_intersect(cloth, query, points_of(object_triangles[t]))) { add_pair(&sum, triangle, corners, t); }
      }
    }
  }
  write_sum(&sum, corners);
  if (overflow + size > 0u) { atomicAdd(&statistics[kStatContactOverflow], overflow + size); }
}
