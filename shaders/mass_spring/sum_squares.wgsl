// The sum of |y|² over each block of 256 nodes, by a fixed tree: the same bits on every run. One workgroup per block.
const kNormBlock = 256u;
//                                                                          elements
@group(0) @binding(0) var<storage, read>       y       : array<vec4f>;      // count
@group(0) @binding(1) var<storage, read_write> partial : array<f32>;        // blocks
var<workgroup> sums : array<f32, kNormBlock>;

@compute @workgroup_size(kNormBlock)
fn sum_squares(@builtin(workgroup_id) group : vec3u, @builtin(local_invocation_index) lane : u32) {
  let node = group.x * kNormBlock + lane;
  var square = 0.0;
  if (node < arrayLength(&y)) { square = dot(y[node].xyz, y[node].xyz); }
  sums[lane] = square;
  for (var half = kNormBlock / 2u; half > 0u; half /= 2u) {
    workgroupBarrier();
    if (lane < half) { sums[lane] += sums[lane + half]; }
  }
  if (lane == 0u) { partial[group.x] = sums[0]; }
}
