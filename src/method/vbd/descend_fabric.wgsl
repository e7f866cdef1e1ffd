// Moves every node of one colour of a cloth of fabric to where its own part of what the substep minimises is least by
// Newton's method, its neighbours where they are. No two nodes of a colour are of one triangle or hinge. One invocation
// per node. Source: docs/solvers/vbd.md, equations 3, 4 and 6.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "element/membrane/hessian.wgsl"
#include "method/bent_hinge.wgsl"
#include "method/fabric_params.wgsl"
#include "method/moved_membrane.wgsl"
#include "method/vbd/gathered_color.wgsl"
override kHinges : bool = true;  // whether any hinge resists

//                                                                              elements       unit
@group(0) @binding(0)  var<uniform>             step        : StepBlock;
@group(0) @binding(1)  var<uniform>             color       : GatheredColor;
@group(0) @binding(2)  var<uniform>             fabric      : FabricParams;
@group(0) @binding(3)  var<storage, read>       lists       : array<u32>;      // nodes by colours; rows, entries
@group(0) @binding(4)  var<storage, read>       corners     : array<u32>;      // 3 * triangles
@group(0) @binding(5)  var<storage, read>       slopes      : array<vec4f>;    // triangles     1/m
@group(0) @binding(6)  var<storage, read>       hinges      : array<vec4u>;    // hinges        a, b, c, d
@group(0) @binding(7)  var<storage, read>       moments     : array<vec4f>;    // hinges        weigh_hinges.wgsl
@group(0) @binding(8)  var<storage, read>       position_in : array<vec4f>;    // vertex_count  m
@group(0) @binding(9)  var<storage, read_write> aim         : array<vec4f>;    // vertex_count  m
@group(0) @binding(10) var<storage, read_write> way         : array<vec4f>;    // vertex_count  m (w: 1/kg)

fn pull_of_membrane(triangle : u32, corner : u32) -> Pull {
  let moved = moved_membrane(triangle);
  let at_end = step_stress(fabric.law, moved.f, moved.start, 1.0 / step.time.dt);
  let stress = at_end.stress;
  let h = at_end.hessian;
  let n = corner_slope(moved.slopes, corner);
  let straight = sum_of(scaled(n.x * n.x, symmetric_of(h.warp)), scaled(n.y * n.y, symmetric_of(h.weft)));
  let area = area_of(moved.slopes);
  return Pull(-area * (n.x * stress.warp + n.y * stress.weft),
              scaled(area, sum_of(straight, scaled(2.0 * n.x * n.y, symmetric_of(h.mixed)))));
}

fn pull_of_hinge(hinge : u32, corner : u32) -> Pull {
  let nodes = hinges[hinge];
  let bent = bent_hinge(nodes, way[nodes.x].xyz, way[nodes.y].xyz, way[nodes.z].xyz, way[nodes.w].xyz);
  let begun = moments[hinge];
  let delays = fabric.law.delay / step.time.dt;
  let bends_by = short_way(bent.angle - begun.z) + (delays * bent.turned - begun.w);
  var slope = -(bent.slope.b + bent.slope.c + bent.slope.d);
  if (corner == 1u) { slope = bent.slope.b; }
  if (corner == 2u) { slope = bent.slope.c; }
  if (corner == 3u) { slope = bent.slope.d; }
  return Pull(-(begun.x + begun.y * bends_by) * slope, outer(slope, (1.0 + delays) * begun.y));
}

fn pull_of(entry : u32) -> Pull {
  if (entry < 3u * fabric.triangles) { return pull_of_membrane(entry / 3u, entry % 3u); }
  if (!kHinges) { return Pull(vec3f(0.0), zero_matrix()); }
  let place = entry - 3u * fabric.triangles;
  return pull_of_hinge(place / 4u, place % 4u);
}

@compute @workgroup_size(kWorkgroupSize)
fn descend_fabric(@builtin(global_invocation_id) id : vec3u) { descend(flat_index(id)); }
