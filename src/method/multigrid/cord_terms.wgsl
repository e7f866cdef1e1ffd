// What only pulls in a cloth of fabric, from a length on, in the linear system of a substep: edges that have a strain
// limit, and threads of its seams. What those that are longer pull with where the unknown starts, and how that changes
// with the places of their ends. One invocation per cord. Source: docs/solvers/multigrid.md, equation 5c;
// docs/sewing.md.
#include "gpu/index.wgsl"
#include "method/fabric_params.wgsl"
#include "method/multigrid/cord_term.wgsl"
#include "method/multigrid/mesh_level.wgsl"
#include "method/multigrid/spring.wgsl"
struct Cord {  // mirror: src/model/cords.hpp
  a : u32,
  b : u32,
  longest : f32,    // m; 0: it always pulls
  stiffness : f32,  // N/m
  damping : f32,    // N·s/m
}
//                                                                            elements      unit
@group(0) @binding(0) var<uniform>             step    : StepBlock;
@group(0) @binding(1) var<uniform>             fabric  : FabricParams;
@group(0) @binding(2) var<uniform>             levels  : array<MeshLevelParams, 2>;
@group(0) @binding(3) var<storage, read>       cords   : array<Cord>;
@group(0) @binding(4) var<storage, read>       place   : array<vec4f>;    // node_count    m
@group(0) @binding(5) var<storage, read>       vectors : array<vec4f>;    // method/multigrid/cloth.wgsl
@group(0) @binding(6) var<storage, read_write> terms   : array<vec4f>;    // method/multigrid/cord_term.wgsl
@group(0) @binding(7) var<storage, read_write> forces  : array<vec4f>;    // 3 * triangles + 4 * hinges + 2 * cords, N

fn vector_of(vector : u32, node : u32) -> vec3f { return vectors[vector_at(levels[0], vector, node)].xyz; }

fn law_of_cord(cord : Cord) -> SpringLaw {
  if (cord.longest == 0.0) { return SpringLaw(0.0, cord.stiffness, 0.0, 0.0); }
  return SpringLaw(cord.longest, 0.0, cord.longest, cord.stiffness);  // no force before it is long
}

@compute @workgroup_size(kWorkgroupSize)
fn cord_terms(@builtin(global_invocation_id) id : vec3u) {
  let number = flat_index(id);
  if (number >= arrayLength(&cords)) { return; }
  let cord = cords[number];
  let rate = 1.0 / formula_of(step.time.step_ratio).he;
  let span = place[cord.b].xyz - place[cord.a].xyz;
  let pulled = pull_of(span, vector_of(kFirst, cord.b) - vector_of(kFirst, cord.a),
                       vector_of(kSecond, cord.b) - vector_of(kSecond, cord.a), law_of_cord(cord), cord.damping, rate);
  let first = 3u * fabric.triangles + 4u * fabric.hinges + 2u * number;
  forces[first] = vec4f(pulled.force, 0.0);
  forces[first + 1u] = vec4f(-pulled.force, 0.0);
  let part = sum_of(outer(pulled.block.direction, pulled.block.along), identity(pulled.block.across));
  let at = cord_at(fabric.triangles, number);
  terms[at] = vec4f(part.diagonal, part.mixed.x);
  terms[at + 1u] = vec4f(part.mixed.yz, 0.0, 0.0);
}
