// The edges of a cloth of fabric that have a strain limit, in the linear system of a substep: what those beyond it pull
// with where the unknown starts, and how that changes with the places of their ends. One invocation per edge.
// Source: docs/solvers/multigrid.md, equation 5c.
#include "gpu/index.wgsl"
#include "method/fabric_params.wgsl"
#include "method/multigrid/limit_term.wgsl"
#include "method/multigrid/mesh_level.wgsl"
#include "method/multigrid/spring.wgsl"
struct LimitSpring {  // mirror: src/model/limited_edges.hpp
  a : u32,
  b : u32,
  longest : f32,    // m
  stiffness : f32,  // N/m
}
//                                                                            elements      unit
@group(0) @binding(0) var<uniform>             step    : StepBlock;
@group(0) @binding(1) var<uniform>             fabric  : FabricParams;
@group(0) @binding(2) var<uniform>             levels  : array<MeshLevelParams, 2>;
@group(0) @binding(3) var<storage, read>       edges   : array<LimitSpring>;
@group(0) @binding(4) var<storage, read>       place   : array<vec4f>;    // node_count    m
@group(0) @binding(5) var<storage, read>       vectors : array<vec4f>;    // method/multigrid/cloth.wgsl
@group(0) @binding(6) var<storage, read_write> terms   : array<vec4f>;    // method/multigrid/limit_term.wgsl
@group(0) @binding(7) var<storage, read_write> forces  : array<vec4f>;    // 3 * triangles + 4 * hinges + 2 * edges, N

fn way_of(node : u32) -> vec3f { return vectors[vector_at(levels[0], kFirst, node)].xyz; }

@compute @workgroup_size(kWorkgroupSize)
fn limit_terms(@builtin(global_invocation_id) id : vec3u) {
  let number = flat_index(id);
  if (number >= arrayLength(&edges)) { return; }
  let edge = edges[number];
  let law = SpringLaw(edge.longest, 0.0, edge.longest, edge.stiffness);  // no force before it is long
  let span = place[edge.b].xyz - place[edge.a].xyz;
  let pulled = pull_of(span, way_of(edge.b) - way_of(edge.a), vec3f(0.0), law, 0.0, 0.0);
  let first = 3u * fabric.triangles + 4u * fabric.hinges + 2u * number;
  forces[first] = vec4f(pulled.force, 0.0);
  forces[first + 1u] = vec4f(-pulled.force, 0.0);
  let part = sum_of(outer(pulled.block.direction, pulled.block.along), identity(pulled.block.across));
  let at = limit_at(fabric.triangles, number);
  terms[at] = vec4f(part.diagonal, part.mixed.x);
  terms[at + 1u] = vec4f(part.mixed.yz, 0.0, 0.0);
}
