// The end of a mesh's substep. One invocation per node.
#include "gpu/index.wgsl"
#include "method/multigrid/finish_node.wgsl"
//                                                                               elements       unit
@group(0) @binding(0) var<uniform>             step         : StepBlock;
@group(0) @binding(1) var<uniform>             nodes        : ClothNodes;
@group(0) @binding(2) var<storage, read>       place        : array<vec4f>;   // count          m (w: N/m; 0: fixed)
@group(0) @binding(3) var<storage, read>       holds        : array<vec4f>;   // method/multigrid/hold.wgsl
@group(0) @binding(4) var<storage, read>       vectors      : array<vec4f>;   // method/multigrid/cloth.wgsl: the finest
@group(0) @binding(5) var<storage, read>       position_in  : array<vec4f>;   // vertex_count   m (w: 1/kg)
@group(0) @binding(6) var<storage, read>       velocity_in  : array<vec4f>;   // vertex_count   m/s (w: as in predict)
@group(0) @binding(7) var<storage, read_write> position_out : array<vec4f>;   // vertex_count   m; came as a step before
@group(0) @binding(8) var<storage, read_write> velocity_out : array<vec4f>;   // vertex_count   m/s

@compute @workgroup_size(kWorkgroupSize)
fn mesh_finish(@builtin(global_invocation_id) id : vec3u) {
  let index = flat_index(id);
  if (index >= nodes.count) { return; }
  if (place[index].w == 0.0) {
    finish_held(index);
  } else {
    finish_free(index, vectors[kFirst * nodes.count + index].xyz);
  }
}
