// A 3 x 3 matrix: its symmetric part, and s of the rest, v -> s x v.
#include "method/symmetric.wgsl"

struct Block {
  symmetric : Symmetric,
  skew : vec3f,
}

fn block_sum(a : Block, b : Block) -> Block { return Block(sum_of(a.symmetric, b.symmetric), a.skew + b.skew); }
fn block_scaled(s : f32, a : Block) -> Block { return Block(scaled(s, a.symmetric), s * a.skew); }
