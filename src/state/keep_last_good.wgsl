// Saves the state of the last frame in which all nodes were finite and all contacts were listed. Once guard has found a
// node that is not finite, restores the saved state in this frame and all that follow: the state is frozen. The same
// where a list was too short, until the host has made it longer. One invocation per node.
#include "gpu/index.wgsl"
#include "state/statistics.wgsl"
//                                                                                 elements
@group(0) @binding(0) var<storage, read_write> position      : array<vec4f>;    // vertex_count, m
@group(0) @binding(1) var<storage, read_write> velocity      : array<vec4f>;    // vertex_count, m/s
@group(0) @binding(2) var<storage, read_write> good_position : array<vec4f>;    // vertex_count, m
@group(0) @binding(3) var<storage, read_write> good_velocity : array<vec4f>;    // vertex_count, m/s
@group(0) @binding(4) var<storage, read_write> statistics    : array<u32>;      // see state/statistics.wgsl

@compute @workgroup_size(kWorkgroupSize)
fn keep_last_good(@builtin(global_invocation_id) id : vec3u) {
  let node = flat_index(id);
  if (node >= arrayLength(&position)) { return; }
  if ((statistics[kStatNonfinite] | statistics[kStatRolledBack]) == 0u) {
    good_position[node] = position[node];
    good_velocity[node] = velocity[node];
    return;
  }
  position[node] = good_position[node];
  velocity[node] = good_velocity[node];
  if (node == 0u && statistics[kStatNonfinite] != 0u) { statistics[kStatFrozen] = 1u; }
}
