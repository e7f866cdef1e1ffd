// How far each hinge of a cloth that keeps bends is bent as a substep begins, for yield_creases.wgsl. One invocation
// per hinge. Source: docs/elements.md, Bending.
#include "gpu/index.wgsl"
#include "element/hinge/law.wgsl"
#include "method/fabric_params.wgsl"
override kBendWords : u32 = 1;  // of a bend: methods that move ways keep its rate beside it
//                                                                               elements      unit
@group(0) @binding(0) var<uniform>             fabric      : FabricParams;
@group(0) @binding(1) var<storage, read>       hinges      : array<vec4u>;    // hinges        a, b, c, d
@group(0) @binding(2) var<storage, read>       rest_angles : array<f32>;      // hinges        rad
@group(0) @binding(3) var<storage, read>       position    : array<vec4f>;    // vertex_count  m
@group(0) @binding(4) var<storage, read_write> bends       : array<f32>;      // hinges, then three a facet: rad

@compute @workgroup_size(kWorkgroupSize)
fn start_bends(@builtin(global_invocation_id) id : vec3u) {
  let hinge = flat_index(id);
  if (hinge >= fabric.hinges) { return; }
  let nodes = hinges[hinge];
  let wing = wing_of(position[nodes.x].xyz, position[nodes.y].xyz, position[nodes.z].xyz, position[nodes.w].xyz);
  bends[kBendWords * hinge] = hinge_angle(wing) - rest_angles[hinge];
}
