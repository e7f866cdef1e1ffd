// The norm from the blocks' sums of squares, by a fixed tree. One workgroup in all.
const kNormBlock = 256u;
//                                                                          elements
@group(0) @binding(0) var<storage, read>       partial : array<f32>;        // blocks
@group(0) @binding(1) var<storage, read_write> norm    : array<f32>;        // 1
var<workgroup> sums : array<f32, kNormBlock>;

@compute @workgroup_size(kNormBlock)
fn finish_norm(@builtin(local_invocation_index) lane : u32) {
  var sum = 0.0;
  for (var i = lane; i < arrayLength(&partial); i += kNormBlock) { sum += partial[i]; }
  sums[lane] = sum;
  for (var half = kNormBlock / 2u; half > 0u; half /= 2u) {
    workgroupBarrier();
    if (lane < half) { sums[lane] += sums[lane + half]; }
  }
  if (lane == 0u) { norm[0] = sqrt(sums[0]); }
}
