// Contacts by brute force: every cloth triangle against every object triangle. Source: Sung et al., section on
// collision. One invocation for a cloth triangle and `chunk` object triangles; neighbours share the chunk, so that a
// wave reads one object triangle at a time.
#include "shared/index.wgsl"
#include "collision/contact_sum.wgsl"

// Mirror: PairRange in src/collision/pairs_paper.cpp.
struct PairRange {
  first : u32,  // of the object triangles of this dispatch
  count : u32,
  chunk : u32,  // object triangles an invocation
}
//                                                                                   elements            unit
@group(0) @binding(0) var<uniform>             step             : StepParams;         // 1
@group(0) @binding(1) var<storage, read>       predicted        : array<vec4f>;       // vertex_count       m (w: inverse mass, 1/kg)
@group(0) @binding(2) var<storage, read>       previous         : array<vec4f>;       // vertex_count       m (w: inverse mass, 1/kg)
@group(0) @binding(3) var<storage, read>       cloth_triangles  : array<u32>;         // 3 * cloth triangles
@group(0) @binding(4) var<storage, read>       object_triangles : array<ObjectTriangle>;
@group(0) @binding(5) var<storage, read>       object_ids       : array<u32>;         // object triangles   their number in the meshes
@group(0) @binding(6) var<storage, read_write> pushes           : array<atomic<i32>>; // 4 * vertex_count   m * step.push_scale; count
@group(0) @binding(7) var<storage, read_write> statistics       : array<atomic<u32>>; // shared/statistics.wgsl
@group(0) @binding(8) var<uniform>             range            : PairRange;          // 1

@compute @workgroup_size(kWorkgroupSize)
fn paper(@builtin(global_invocation_id) id : vec3u) {
  let cloth_count = arrayLength(&cloth_triangles) / 3u;
  let i = flat_index(id);
  let begin = (i / cloth_count) * range.chunk;
  if (begin >= range.count) { return; }
  let triangle = i % cloth_count;
  let nodes = cloth_nodes(triangle);
  let cloth = cloth_points(nodes);
  if (!all_finite(cloth)) { return; }
  let query = query_box(cloth);
  var sum : ContactSum;
  let end = range.first + min(begin + range.chunk, range.count);
  for (var t = range.first + begin; t < end; t++) {
    let object = points_of(object_triangles[t]);
    // The paper has no boxes. They stand last, so that its cost is kept and its pairs are those of the tree.
    if ((edges_hit(cloth, object) || edges_hit(object, cloth)) && boxes_overlap(query, box_of(object))) {
      add_pair(&sum, triangle, nodes, t);
    }
  }
  write_sum(&sum, nodes);
}
