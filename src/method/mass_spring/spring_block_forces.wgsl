// Adds the force of every spring to its two nodes, as spring_forces does, to the same integers: one workgroup per block
// of springs that lie together sums in workgroup memory, and adds each of the block's nodes to `force` once.
// Source: docs/solvers/mass_spring.md, "Sums in workgroup memory".
#include "method/mass_spring/fixed_force.wgsl"
#include "gpu/index.wgsl"
#include "element/spring/packed_spring.wgsl"
struct SpringBlock {  // mirror: src/element/spring/spring_blocks.hpp
  first_node : u32,   // in `nodes`
  node_count : u32,
  first_spring : u32,
  spring_count : u32,
}
struct BlockSpring {  // mirror: src/element/spring/spring_blocks.hpp
  nodes_and_kind : u32,  // places of node a and b among the block's nodes, ten bits each, then the kind
  rest_length : f32,     // m
}
//                                                                              elements          unit
@group(0) @binding(0) var<uniform>             step     : StepBlock;
@group(0) @binding(1) var<storage, read>       position : array<vec4f>;        // vertex_count      m
@group(0) @binding(2) var<storage, read>       velocity : array<vec4f>;        // vertex_count      m/s
@group(0) @binding(3) var<storage, read>       blocks   : array<SpringBlock>;
@group(0) @binding(4) var<storage, read>       nodes    : array<u32>;
@group(0) @binding(5) var<storage, read>       springs  : array<BlockSpring>;  // spring_count
@group(0) @binding(6) var<storage, read>       kinds    : array<SpringKind>;
@group(0) @binding(7) var<storage, read_write> force    : array<atomic<i32>>;  // 3 * vertex_count  N * force_scale

const kBlockNodes = 448u;  // kBlockNodes in src/element/spring/spring_blocks.hpp: 36 bytes each, 15.75 KiB
const kPlaceBits = 10u;
var<workgroup> place : array<f32, 3u * kBlockNodes>;  // m: all x, all y, all z
var<workgroup> speed : array<f32, 3u * kBlockNodes>;  // m/s
var<workgroup> sum   : array<atomic<i32>, 3u * kBlockNodes>;

fn place_of(node : u32) -> vec3f {
  return vec3f(place[node], place[kBlockNodes + node], place[2u * kBlockNodes + node]);
}
fn speed_of(node : u32) -> vec3f {
  return vec3f(speed[node], speed[kBlockNodes + node], speed[2u * kBlockNodes + node]);
}
fn put(node : u32, x : vec3f, v : vec3f) {
  place[node] = x.x;
  place[kBlockNodes + node] = x.y;
  place[2u * kBlockNodes + node] = x.z;
  speed[node] = v.x;
  speed[kBlockNodes + node] = v.y;
  speed[2u * kBlockNodes + node] = v.z;
  atomicStore(&sum[node], 0);
  atomicStore(&sum[kBlockNodes + node], 0);
  atomicStore(&sum[2u * kBlockNodes + node], 0);
}
fn add_force(node : u32, f : vec3i) {
  atomicAdd(&sum[node], f.x);
  atomicAdd(&sum[kBlockNodes + node], f.y);
  atomicAdd(&sum[2u * kBlockNodes + node], f.z);
}

@compute @workgroup_size(kWorkgroupSize)
fn spring_block_forces(@builtin(workgroup_id) group : vec3u, @builtin(local_invocation_index) local : u32) {
  let index = flat_group(group);
  if (index >= arrayLength(&blocks)) { return; }
  let chunk = blocks[index];
  for (var k = local; k < chunk.node_count; k += kWorkgroupSize) {
    let node = nodes[chunk.first_node + k];
    put(k, position[node].xyz, velocity[node].xyz);
  }
  workgroupBarrier();
  for (var k = local; k < chunk.spring_count; k += kWorkgroupSize) {
    let s = springs[chunk.first_spring + k];
    let a = s.nodes_and_kind & ((1u << kPlaceBits) - 1u);
    let b = (s.nodes_and_kind >> kPlaceBits) & ((1u << kPlaceBits) - 1u);
    let kind = kinds[s.nodes_and_kind >> (2u * kPlaceBits)];
    let f = fixed_force(place_of(b) - place_of(a), speed_of(b) - speed_of(a), s.rest_length, kind.stiffness,
                        kind.damping);
    add_force(a, f);
    add_force(b, -f);
  }
  workgroupBarrier();
  for (var k = local; k < chunk.node_count; k += kWorkgroupSize) {
    let node = nodes[chunk.first_node + k];
    atomicAdd(&force[node], atomicLoad(&sum[k]));
    atomicAdd(&force[step.nodes.count + node], atomicLoad(&sum[kBlockNodes + k]));
    atomicAdd(&force[2u * step.nodes.count + node], atomicLoad(&sum[2u * kBlockNodes + k]));
  }
}
