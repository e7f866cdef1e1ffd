// How far each hinge of a cloth is bent from its rest at the ways so far, and τ times how fast, before a sweep of a
// method that moves ways. One invocation per hinge. Source: docs/solvers/xpbd.md, equation 10.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "method/fabric_params.wgsl"
#include "method/bent_hinge.wgsl"
//                                                                              elements       unit
@group(0) @binding(0) var<uniform>             step        : StepBlock;
@group(0) @binding(1) var<uniform>             fabric      : FabricParams;
@group(0) @binding(2) var<storage, read>       hinges      : array<vec4u>;    // hinges         a, b, c, d
@group(0) @binding(3) var<storage, read>       rest_angles : array<f32>;      // hinges         rad
@group(0) @binding(4) var<storage, read>       position_in : array<vec4f>;    // vertex_count   m
@group(0) @binding(5) var<storage, read>       way         : array<vec4f>;    // vertex_count   m
@group(0) @binding(6) var<storage, read_write> bends       : array<vec2f>;    // hinges         rad: both

@compute @workgroup_size(kWorkgroupSize)
fn bend_hinges(@builtin(global_invocation_id) id : vec3u) {
  let hinge = flat_index(id);
  if (hinge >= fabric.hinges) { return; }
  let nodes = hinges[hinge];
  let bent = bent_hinge(nodes, way[nodes.x].xyz, way[nodes.y].xyz, way[nodes.z].xyz, way[nodes.w].xyz);
  bends[hinge] = vec2f(bent.angle - rest_angles[hinge], fabric.law.delay / step.time.dt * bent.turned);
}
