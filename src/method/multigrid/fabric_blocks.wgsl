// The matrix of a cloth of fabric without its inertia: the sums of what membranes, hinges and cords
// are for two nodes. One invocation per block. Source: docs/solvers/multigrid.md, Fabric.
#include "gpu/index.wgsl"
#include "method/multigrid/element_part.wgsl"
#include "method/multigrid/cord_term.wgsl"
//                                                                              elements
@group(0) @binding(0) var<uniform>             levels   : array<MeshLevelParams, 2>;
@group(0) @binding(1) var<storage, read>       place    : array<vec4f>;     // node_count  w: N/m, 0: fixed
@group(0) @binding(2) var<storage, read>       terms    : array<vec4f>;     // method/multigrid/cord_term.wgsl
@group(0) @binding(3) var<storage, read>       slopes   : array<vec4f>;     // triangles   1/m: membrane/build.hpp
@group(0) @binding(4) var<storage, read>       wings    : array<vec4f>;     // 4 * hinges  1/m; w of the first: N·m
@group(0) @binding(5) var<storage, read>       parts    : array<u32>;       // rows of blocks, then their parts
@group(0) @binding(6) var<storage, read>       targets  : array<vec2u>;     // the entries of each block
@group(0) @binding(7) var<storage, read>       entries  : array<u32>;       // the node of each
@group(0) @binding(8) var<storage, read_write> blocks   : array<vec2f>;     // method/multigrid/mesh_block.wgsl

const kMembrane = 0u;  // mirror: src/method/multigrid/element_pairs.hpp
const kHinge = 1u;

fn slope_at(triangle : u32, corner : u32) -> vec2f {
  let slope = slopes[triangle];
  if (corner == 0u) { return -(slope.xy + slope.zw); }
  return select(slope.xy, slope.zw, corner == 2u);
}

fn block_of_part(part : u32) -> Block {
  let element = element_of(part);
  let kind = kind_of(part);
  let row = row_of(part);
  let column = column_of(part);
  if (kind == kMembrane) {
    return block_of_term(term_of(element), slope_at(element, row), slope_at(element, column));
  }
  if (kind != kHinge) {  // a cord
    let at = cord_at(arrayLength(&slopes), element);
    let found = Symmetric(terms[at].xyz, vec3f(terms[at].w, terms[at + 1u].xy));
    return Block(scaled(select(-1.0, 1.0, row == column), found), vec3f(0.0));
  }
  let stiffness = wings[4u * element].w;
  let a = stiffness * wings[4u * element + row].xyz;
  let b = wings[4u * element + column].xyz;
  // a bᵀ, whose rest is half of v -> b x a x v
  return Block(Symmetric(a * b, 0.5 * (a.yxx * b.zzy + a.zzy * b.yxx)), 0.5 * cross(b, a));
}

@compute @workgroup_size(kWorkgroupSize)
fn fabric_blocks(@builtin(global_invocation_id) id : vec3u) { sum_block(flat_index(id)); }
