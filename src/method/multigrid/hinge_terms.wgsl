// The hinges of a cloth in the linear system of a substep: how far each is bent where the unknown starts, and its slope
// there. One invocation per hinge. Source: docs/solvers/multigrid.md, Fabric.
#include "gpu/index.wgsl"
#include "element/hinge/law.wgsl"
#include "method/fabric_params.wgsl"
#include "method/multigrid/mesh_level.wgsl"
#include "method/multigrid/spring.wgsl"
//                                                                               elements      unit
@group(0) @binding(0) var<uniform>             step        : StepBlock;
@group(0) @binding(1) var<uniform>             fabric      : FabricParams;
@group(0) @binding(2) var<uniform>             levels      : array<MeshLevelParams, 2>;
@group(0) @binding(3) var<storage, read>       hinges      : array<vec4u>;    // hinges        a, b, c, d
@group(0) @binding(4) var<storage, read>       rest_angles : array<f32>;      // hinges        rad
@group(0) @binding(5) var<storage, read>       bounds      : array<f32>;      // hinges        N·m
@group(0) @binding(6) var<storage, read>       place       : array<vec4f>;    // node_count    m
@group(0) @binding(7) var<storage, read>       vectors     : array<vec4f>;    // method/multigrid/cloth.wgsl
@group(0) @binding(8) var<storage, read_write> wings       : array<vec4f>;    // 4 * hinges    1/m; w of the first: N·m
@group(0) @binding(9) var<storage, read_write> bends       : array<f32>;      // hinges        rad

fn there(node : u32) -> vec3f { return place[node].xyz + vectors[vector_at(levels[0], kFirst, node)].xyz; }
fn speed(node : u32) -> vec3f { return vectors[vector_at(levels[0], kSecond, node)].xyz; }

@compute @workgroup_size(kWorkgroupSize)
fn hinge_terms(@builtin(global_invocation_id) id : vec3u) {
  let hinge = flat_index(id);
  if (hinge >= fabric.hinges) { return; }
  let nodes = hinges[hinge] - vec4u(fabric.first);
  let wing = wing_of(there(nodes.x), there(nodes.y), there(nodes.z), there(nodes.w));
  let slope = hinge_slope(wing);
  let change = hinge_change(slope, speed(nodes.x), speed(nodes.y), speed(nodes.z), speed(nodes.w));
  bends[hinge] = (hinge_angle(wing) - rest_angles[hinge]) + fabric.law.delay * change;
  let rate = 1.0 / formula_of(step.time.step_ratio).he;
  let stiffness = (1.0 + fabric.law.delay * rate) * bounds[hinge];
  wings[4u * hinge] = vec4f(-(slope.b + slope.c + slope.d), stiffness);
  wings[4u * hinge + 1u] = vec4f(slope.b, 0.0);
  wings[4u * hinge + 2u] = vec4f(slope.c, 0.0);
  wings[4u * hinge + 3u] = vec4f(slope.d, 0.0);
}
