// How far each hinge of a cloth is bent from its rest, and τ times how fast. One invocation per hinge.
// Source: docs/elements.md, Bending.
#include "gpu/index.wgsl"
#include "method/fabric_params.wgsl"
#include "element/hinge/law.wgsl"
//                                                                               elements      unit
@group(0) @binding(0) var<uniform>             fabric      : FabricParams;
@group(0) @binding(1) var<storage, read>       hinges      : array<vec4u>;    // hinges        a, b, c, d
@group(0) @binding(2) var<storage, read>       rest_angles : array<f32>;      // hinges        rad
@group(0) @binding(3) var<storage, read>       position    : array<vec4f>;    // vertex_count  m
@group(0) @binding(4) var<storage, read>       velocity    : array<vec4f>;    // vertex_count  m/s
@group(0) @binding(5) var<storage, read_write> bends       : array<f32>;      // hinges        rad

@compute @workgroup_size(kWorkgroupSize)
fn fabric_bends(@builtin(global_invocation_id) id : vec3u) {
  let hinge = flat_index(id);
  if (hinge >= fabric.hinges) { return; }
  let nodes = hinges[hinge];
  let wing = wing_of(position[nodes.x].xyz, position[nodes.y].xyz, position[nodes.z].xyz, position[nodes.w].xyz);
  let slope = hinge_slope(wing);
  let rate = hinge_change(slope, velocity[nodes.x].xyz, velocity[nodes.y].xyz, velocity[nodes.z].xyz,
                          velocity[nodes.w].xyz);
  bends[hinge] = (hinge_angle(wing) - rest_angles[hinge]) + fabric.law.delay * rate;
}
