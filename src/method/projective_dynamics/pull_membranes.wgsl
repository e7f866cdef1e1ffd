// The start of a cycle over every node of a cloth of fabric: its way without elements, less its way so far, and what
// its membranes pull it by. One invocation per node. Source: docs/solvers/projective_dynamics.md, Fabric.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "method/fabric_params.wgsl"
#include "method/moved_membrane.wgsl"
#include "method/projective_dynamics/bounded_yarns.wgsl"
//                                                                             elements      unit
@group(0) @binding(0) var<uniform>             step        : StepBlock;
@group(0) @binding(1) var<uniform>             fabric      : FabricParams;
@group(0) @binding(2) var<storage, read>       corners     : array<u32>;    // 3 * triangles
@group(0) @binding(3) var<storage, read>       slopes      : array<vec4f>;  // triangles     1/m
@group(0) @binding(4) var<storage, read>       gathers     : array<u32>;    // rows of nodes, then places in `corners`
@group(0) @binding(5) var<storage, read>       position_in : array<vec4f>;  // vertex_count  m
@group(0) @binding(6) var<storage, read>       aim         : array<vec4f>;  // vertex_count  m
@group(0) @binding(7) var<storage, read>       way         : array<vec4f>;  // vertex_count  m (w: 1/kg)
@group(0) @binding(8) var<storage, read_write> left        : array<vec4f>;  // vertex_count  m (w: 1/kg)

// N
fn pull_of_membrane(triangle : u32, corner : u32) -> vec3f {
  let moved = moved_membrane(triangle);
  let stress = bounded_stress(fabric.law, moved.f, moved.start, 1.0 / step.time.dt);
  let n = corner_slope(moved.slopes, corner);
  return -area_of(moved.slopes) * (n.x * stress.warp + n.y * stress.weft);
}

@compute @workgroup_size(kWorkgroupSize)
fn pull_membranes(@builtin(global_invocation_id) id : vec3u) {
  let row = flat_index(id);
  if (row >= fabric.count) { return; }
  let node = fabric.first + row;
  let own = way[node];
  var pull = vec3f(0.0);
  for (var at = gathers[row]; at < gathers[row + 1u]; at++) {
    let place = gathers[at];
    pull += pull_of_membrane(place / 3u, place % 3u);
  }
  let mobility = step.time.dt * step.time.dt * own.w;  // m/N
  left[node] = vec4f(aim[node].xyz - own.xyz + mobility * pull, own.w);
}
