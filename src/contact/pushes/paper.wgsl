// Contacts by brute force: every cloth triangle against every object triangle. Source: Sung et al., section on
// collision. One invocation for two cloth triangles and `chunk` object triangles.
#include "gpu/index.wgsl"
#include "contact/pushes/contact_pair.wgsl"

// Mirror: PairRange in src/contact/pushes/pairs_paper.hpp.
struct PairRange {
  first : u32,  // of the object triangles of this dispatch
  count : u32,
  chunk : u32,  // object triangles an invocation
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
@group(0) @binding(8) var<uniform>             range            : PairRange;          // 1

// The paper has no boxes. Their test comes last, so that its cost is kept and its pairs are those of the tree.
fn pair_hits(cloth : TrianglePoints, query : Box, object : TrianglePoints) -> bool {
  return (edges_hit(cloth, object) | edges_hit(object, cloth)) & boxes_overlap(query, box_of(object));
}

@compute @workgroup_size(kWorkgroupSize)
fn paper(@builtin(global_invocation_id) id : vec3u, @builtin(workgroup_id) group : vec3u) {
  let cloth_count = arrayLength(&cloth_triangles) / 3u;
  if (2u * id.x >= cloth_count) { return; }
  let pair = cloth_pair(2u * id.x, cloth_count);
  let begin = range.first + group.y * range.chunk;  // the same for a whole wave: it reads one object triangle at a time
  let end = min(begin + range.chunk, range.first + range.count);
  var found : HitCount;
  for (var first = begin; first < end; first += 32u) {
    // Hits are marked first and added after: they are rare, and where a wave cannot skip a branch (software adapters)
    // each test would pay for an addition; SwiftShader took four times as long.
    var marks_a = 0u;
    var marks_b = 0u;
    let count = min(end - first, 32u);
    for (var k = 0u; k < count; k++) {
      let object = points_of(object_triangles[first + k]);
      marks_a |= select(0u, 1u << k, pair.use_a & pair_hits(pair.a, pair.query_a, object));
      marks_b |= select(0u, 1u << k, pair.use_b & pair_hits(pair.b, pair.query_b, object));
    }
    while ((marks_a | marks_b) != 0u) {
      let in_a = marks_a != 0u;
      let k = firstTrailingBit(select(marks_b, marks_a, in_a));
      marks_b = select(marks_b & (marks_b - 1u), marks_b, in_a);
      marks_a &= marks_a - 1u;
      add_pair(&found, select(pair.second, pair.first, in_a), select(pair.nodes_b, pair.nodes_a, in_a), first + k);
    }
  }
  write_count(found);
}
